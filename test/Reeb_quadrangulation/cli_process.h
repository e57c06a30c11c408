// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the program as a shell would, under a limit of time and memory, and keeps what it printed.
#ifndef REEBQUAD_TEST_CLI_PROCESS_H
#define REEBQUAD_TEST_CLI_PROCESS_H

#include "temporary_folder.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#if defined(__SANITIZE_ADDRESS__)
constexpr bool memory_is_limited = false; // the sanitizer reserves terabytes of addresses
constexpr double patience = 10;
#else
constexpr bool memory_is_limited = true;
constexpr double patience = 1;
#endif

struct Outcome {
  int code = -1; ///< as a shell gives it: 128 + the signal that ended it, if one did
  std::string out, err;
  double seconds = 0;
  double seconds_after_signal = 0;
};

struct Limits {
  double seconds = 60;          ///< then the program is killed
  std::size_t megabytes = 1000; ///< of address space
  double interrupt_after = -1;  ///< seconds until SIGINT is sent; negative: never
};

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline void become_program(const std::vector<std::string>& arguments, const std::string& out,
                           const std::string& err, const Limits& limits) {
  dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
  dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
  if (memory_is_limited) {
    const rlimit memory{limits.megabytes << 20, limits.megabytes << 20};
    setrlimit(RLIMIT_AS, &memory);
  }
  std::vector<char*> argv;
  std::string program = REEBQUAD_PROGRAM;
  argv.push_back(program.data());
  std::vector<std::string> copies = arguments;
  for (std::string& argument : copies) argv.push_back(argument.data());
  argv.push_back(nullptr);
  execv(program.c_str(), argv.data());
  _exit(127);
}

/// `reebquad ARGUMENTS...` with its output caught.
inline Outcome reebquad(const std::vector<std::string>& arguments, const Limits& limits = {}) {
  using Clock = std::chrono::steady_clock;
  const Temporary_folder folder;
  const std::string out = folder.path("out"), err = folder.path("err");
  const Clock::time_point start = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) become_program(arguments, out, err, limits);

  Outcome outcome;
  int status = 0;
  double signalled = -1;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (limits.interrupt_after >= 0 && signalled < 0 && elapsed() >= limits.interrupt_after) {
      kill(child, SIGINT);
      signalled = elapsed();
    }
    if (elapsed() > patience * limits.seconds) kill(child, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  outcome.seconds = elapsed();
  if (signalled >= 0) outcome.seconds_after_signal = outcome.seconds - signalled;
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.out = contents(out);
  outcome.err = contents(err);
  return outcome;
}

#endif // REEBQUAD_TEST_CLI_PROCESS_H
