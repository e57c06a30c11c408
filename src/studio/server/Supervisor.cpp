// SPDX-License-Identifier: GPL-3.0-or-later
#include "server/Supervisor.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <deque>
#include <fcntl.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace reebquad {
namespace studio {

namespace {

using Clock = std::chrono::steady_clock;

// The parent holds the other end of the pipe and writes nothing: the read ends when it does.
void end_with_parent(int pipe) {
  std::thread([pipe] {
    char byte = 0;
    while (::read(pipe, &byte, 1) < 0 && errno == EINTR) {
    }
    ::_exit(1);
  }).detach();
}

pid_t start(const std::function<int(int)>& work, int crashes, std::array<int, 2>& pipe) {
  if (::pipe(pipe.data()) != 0) throw std::system_error(errno, std::generic_category(), "no pipe");
  for (const int end : pipe) ::fcntl(end, F_SETFD, FD_CLOEXEC);
  const pid_t child = ::fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "no process can be started");
  if (child > 0) {
    ::close(pipe[0]);
    return child;
  }
  ::close(pipe[1]);
  end_with_parent(pipe[0]);
  ::_exit(work(crashes));
}

int wait_for(pid_t child, const std::function<bool()>& stop) {
  int status = 0;
  bool told = false;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (!told && stop()) {
      ::kill(child, SIGTERM);
      told = true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return status;
}

} // namespace

int supervise(const std::function<int(int crashes)>& work, const std::function<bool()>& stop,
              const std::function<void(int signal, int crashes)>& crashed) {
  std::deque<Clock::time_point> crashes;
  for (;;) {
    std::array<int, 2> pipe{};
    const pid_t child = start(work, int(crashes.size()), pipe);
    const int status = wait_for(child, stop);
    ::close(pipe[1]);
    if (!WIFSIGNALED(status)) return WEXITSTATUS(status);
    if (stop()) return 130;
    const Clock::time_point now = Clock::now();
    crashes.push_back(now);
    while (now - crashes.front() > std::chrono::minutes(1)) crashes.pop_front();
    crashed(WTERMSIG(status), int(crashes.size()));
    if (int(crashes.size()) >= most_crashes) return 1;
  }
}

} // namespace studio
} // namespace reebquad
