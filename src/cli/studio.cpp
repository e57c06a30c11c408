// SPDX-License-Identifier: GPL-3.0-or-later
// The studio: serves the page and waits for Ctrl-C. A child process does the work, so that its crash is not
// the end.
#include "Command.h"
#include "Interruption.h"
#include "Redirect_page.h"

#include "server/Server.h"
#include "server/Supervisor.h"
#include "view/Assets.h"

#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <optional>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

extern char** environ;

namespace reebquad {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

struct Studio_options {
  unsigned short port = 0;
  bool open_browser = true;
  fs::path folder;
  std::string file; ///< relative to the folder; empty: none
};

/// Nothing if only the help was asked for.
std::optional<Studio_options> parse_studio_options(const Arguments& arguments) {
  Command_line line("studio [FILE] [options]");
  line.options.add_options() //
      ("port", po::value<int>()->value_name("N")->default_value(0),
       "listen on this port; 0: any that is free") //
      ("no-browser", "do not open the page, only print its address");
  line.take("FILE");
  if (!line.parse(arguments)) return std::nullopt;
  Studio_options options;
  const int port = line.values["port"].as<int>();
  if (port < 0 || port > 65535) throw Usage_error("--port lies between 0 and 65535");
  options.port = static_cast<unsigned short>(port);
  options.open_browser = !line.has("no-browser");
  options.folder = fs::current_path();
  if (!line.has("FILE")) return options;
  // A file elsewhere makes its folder the one that is worked in.
  const fs::path file = fs::absolute(line.text("FILE")).lexically_normal();
  std::error_code failed;
  if (!fs::is_regular_file(file, failed))
    throw Failure(Exit_code::unreadable_file, line.text("FILE") + ": the file cannot be read");
  const fs::path inside = fs::canonical(file).lexically_relative(fs::canonical(options.folder));
  if (inside.empty() || *inside.begin() == "..") {
    options.folder = file.parent_path();
    options.file = file.filename().string();
  } else {
    options.file = inside.generic_string();
  }
  return options;
}

/// Asks the desktop to show a page. Nothing depends on it: the address stands on the screen as well.
void open_browser(const std::string& page) {
#ifdef __APPLE__
  std::string program = "open";
#else
  std::string program = "xdg-open";
#endif
  std::string argument = page;
  char* const argv[] = {program.data(), argument.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", 1 /* O_WRONLY */, 0);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", 1, 0);
  posix_spawnattr_t attributes; // signals that we ignore are no business of others
  sigset_t defaults;
  sigemptyset(&defaults);
  sigaddset(&defaults, SIGPIPE);
  sigaddset(&defaults, SIGXFSZ);
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigdefault(&attributes, &defaults);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  pid_t child = 0;
  if (posix_spawnp(&child, program.c_str(), &actions, &attributes, argv, environ) == 0)
    std::thread([child] { waitpid(child, nullptr, 0); }).detach();
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
}

/// Whether the user pressed Enter within a twentieth of a second. Elsewhere than at a terminal nobody can.
bool is_asked_for_address() {
  static bool has_terminal = isatty(STDIN_FILENO) != 0;
  if (!has_terminal) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return false;
  }
  pollfd waiting{STDIN_FILENO, POLLIN, 0};
  if (poll(&waiting, 1, 50) <= 0) return false;
  char line[256];
  const ssize_t n = read(STDIN_FILENO, line, sizeof line);
  has_terminal = n > 0;
  return n > 0 && line[n - 1] == '\n';
}

/// The child's work: serves until Ctrl-C.
Exit_code serve(const studio::Doorway& doorway, const Studio_options& options, int crashes) {
  // What crashed once when it was brought back is not brought back again without being asked for.
  studio::Start start;
  if (crashes == 0) start.file = options.file;
  start.resumes = crashes == 1;
  studio::Server server(doorway, start);
  std::cout << server.url() << std::endl;
  std::optional<Redirect_page> page;
  if (options.open_browser && crashes == 0) {
    page = Redirect_page::write(server.url());
    if (page) open_browser(page->path());
  }
  while (!interrupted()) {
    if (is_asked_for_address()) {
      server.renew_token();
      std::cout << server.url() << std::endl;
    }
    if (page && !server.awaits_visitor()) page.reset();
  }
  return Exit_code::interrupted;
}

int serve_guarded(const studio::Doorway& doorway, const Studio_options& options, int crashes) {
  try {
    return static_cast<int>(serve(doorway, options, crashes));
  } catch (const std::exception& error) {
    std::cerr << "reebquad: " << error.what() << std::endl;
    return static_cast<int>(Exit_code::other_failure);
  }
}

void tell_crash(int signal, int crashes) {
  std::cerr << "reebquad: the engine of the studio crashed (" << strsignal(signal) << "); "
            << (crashes >= studio::most_crashes ? "it crashes again and again and is given up"
                : crashes == 1                  ? "it is started again, with your work up to the last edit"
                                                : "it is started again, with nothing open")
            << std::endl;
}

} // namespace

Exit_code execute_studio(const Arguments& arguments) {
  const std::optional<Studio_options> options = parse_studio_options(arguments);
  if (!options) return Exit_code::success;
  if (studio::assets().empty())
    throw Failure(Exit_code::other_failure,
                  std::string("this program was built without the page of the studio (") +
                      studio::missing_page_reason() + "): install npm and build again");
  const studio::Doorway doorway(options->folder, options->port);
  const auto work = [&](int crashes) { return serve_guarded(doorway, *options, crashes); };
  return static_cast<Exit_code>(studio::supervise(work, interrupted, tell_crash));
}

} // namespace reebquad
