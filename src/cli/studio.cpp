// SPDX-License-Identifier: GPL-3.0-or-later
// The studio: serves the page and waits for Ctrl-C.
#include "Command.h"
#include "Interruption.h"

#include "server/Server.h"
#include "session/Folder.h"
#include "view/Assets.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <spawn.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>

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

/// Asks the desktop to show the page. Nothing depends on it: the address stands on the screen as well.
void open_browser(const std::string& url) {
#ifdef __APPLE__
  std::string program = "open";
#else
  std::string program = "xdg-open";
#endif
  std::string argument = url;
  char* const argv[] = {program.data(), argument.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", 1 /* O_WRONLY */, 0);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", 1, 0);
  pid_t child = 0;
  if (posix_spawnp(&child, program.c_str(), &actions, nullptr, argv, environ) == 0)
    std::thread([child] { waitpid(child, nullptr, 0); }).detach();
  posix_spawn_file_actions_destroy(&actions);
}

} // namespace

Exit_code execute_studio(const Arguments& arguments) {
  const std::optional<Studio_options> options = parse_studio_options(arguments);
  if (!options) return Exit_code::success;
  if (studio::assets().empty())
    throw Failure(Exit_code::other_failure,
                  std::string("this program was built without the page of the studio (") +
                      studio::missing_page_reason() + "): install npm and build again");
  studio::Server server(options->folder, options->port);
  std::cout << server.url() << std::endl;
  if (!options->file.empty()) server.open_file(options->file);
  if (options->open_browser) open_browser(server.url());
  while (!interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  return Exit_code::interrupted;
}

} // namespace reebquad
