// SPDX-License-Identifier: GPL-3.0-or-later
// The dispatcher: finds the subcommand, runs it, and turns what escapes from it into a sentence and an exit
// code.
#include "Command.h"
#include "Interruption.h"
#include "Printable.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <system_error>
#include <unistd.h>

namespace {

using namespace reebquad;

Exit_code execute_help(const Arguments&);

constexpr std::array commands{
    Command{"run", "make a certified quad mesh of a triangle surface", execute_run},
    Command{"check", "tell what is wrong with a triangle mesh, and what can be mended", execute_check},
    Command{"batch", "make quad meshes of a collection, each in a process of its own", execute_batch},
    Command{"replay", "design a quad mesh by the edits of a recipe", execute_replay},
    Command{"suggest", "list edits that are worth while, with a reason each, or take them", execute_suggest},
    Command{"texture", "edit patches of a quad mesh of any origin", execute_texture},
    Command{"stitch", "join patches of quads into one mesh", execute_stitch},
    Command{"polygons", "turn quads into hexagons or other polygons", execute_polygons},
    Command{"stats", "certify and measure a quad mesh of any origin", execute_stats},
    Command{"studio", "design a quad mesh in the browser", execute_studio},
    Command{"shape", "write a built-in triangle surface", execute_shape},
    Command{"version", "print the version of reebquad and of its libraries", execute_version},
    Command{"help", "print this list", execute_help},
};

Exit_code execute_help(const Arguments&) {
  std::cout << "reebquad turns a triangle surface into a certified quad mesh.\n\n"
               "Usage: reebquad COMMAND [arguments]   (reebquad COMMAND --help tells the options)\n\n";
  for (const Command& command : commands) std::printf("  %-8s %s\n", command.name, command.summary);
  return Exit_code::success;
}

Exit_code dispatch(const Arguments& arguments) {
  const std::string name = arguments.empty() ? "" : arguments.front();
  if (name == "--help" || name == "-h") return execute_help({});
  if (name == "--version") return execute_version({});
  for (const Command& command : commands) {
    if (name == command.name) return command.execute({arguments.begin() + 1, arguments.end()});
  }
  throw Usage_error(name.empty() ? "no command is given; 'reebquad help' lists them"
                                 : "there is no command '" + name + "'; 'reebquad help' lists them");
}

Exit_code fail(const std::string& sentence, Exit_code code) {
  std::cerr << "reebquad: " << sentence << '\n';
  return code;
}

Exit_code guarded_dispatch(const Arguments& arguments) {
  try {
    return dispatch(arguments);
  } catch (const Failure& error) {
    return fail(error.what(), error.code);
  } catch (const std::bad_alloc&) {
    return fail("memory ran out", Exit_code::other_failure);
  } catch (const std::exception& error) {
    return fail(error.what(), Exit_code::other_failure);
  }
}

/// What no one catches, as what is thrown in another thread: there is no stack to go back to, and perhaps no
/// memory.
[[noreturn]] void end_unguarded() {
  const char* sentence = "reebquad: an error that is a defect of the program\n";
  try {
    if (std::current_exception()) std::rethrow_exception(std::current_exception());
  } catch (const std::bad_alloc&) {
    sentence = "reebquad: memory ran out\n";
  } catch (const std::system_error&) {
    sentence = "reebquad: the system refused a thread or a file\n";
  } catch (...) {
    std::abort(); // with a core to look into
  }
  [[maybe_unused]] const ssize_t told = ::write(STDERR_FILENO, sentence, std::strlen(sentence));
  ::_exit(static_cast<int>(Exit_code::other_failure));
}

/// What a process must expect of a shell: pipes that are closed and files that may not grow are errors of
/// writing, which are told.
void prepare_process() {
  watch_for_interruption(); // first of all, so that an early Ctrl-C gets its exit code too
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  std::set_terminate(end_unguarded);
}

/// What was printed but could not be written is no success.
Exit_code flushed(Exit_code code) {
  std::cout.flush();
  errno = 0;
  if (std::cout && std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  const std::string why = errno != 0 ? std::generic_category().message(errno) : "it is closed";
  return fail("the standard output cannot be written: " + why,
              code == Exit_code::success ? Exit_code::other_failure : code);
}

} // namespace

int main(int argc, char** argv) {
  prepare_process();
  const Printable out(std::cout), err(std::cerr);
  return static_cast<int>(flushed(guarded_dispatch({argv + 1, argv + argc})));
}
