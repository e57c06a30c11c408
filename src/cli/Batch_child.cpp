// SPDX-License-Identifier: GPL-3.0-or-later
#include "Batch_child.h"

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace reebquad {

namespace {

double seconds_of(const timeval& time) {
  return double(time.tv_sec) + 1e-6 * double(time.tv_usec);
}

/// Between fork and exec: only what may be called there.
[[noreturn]] void become_program(char* const* argv, int errors, int nowhere, rlim_t bytes, int lock,
                                 pid_t parent) {
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  if (::getppid() != parent) ::_exit(127); // it died before the call above
  ::setpgid(0, 0);                         // Ctrl-C is the parent's business
  std::signal(SIGPIPE, SIG_DFL);
  std::signal(SIGXFSZ, SIG_DFL);
  ::dup2(nowhere, STDIN_FILENO);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(errors, STDERR_FILENO);
  if (lock >= 0) ::fcntl(lock, F_SETFD, 0);
  if (bytes > 0) {
    const rlimit memory{bytes, bytes};
    ::setrlimit(RLIMIT_AS, &memory);
  }
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  ::execv("/proc/self/exe", argv);
  ::execvp(argv[0], argv);
  ::_exit(127);
}

} // namespace

Batch_child::Batch_child(const Arguments& arguments, const std::string& errors, const Child_limits& limits,
                         int lock)
    : m_seconds(limits.seconds) {
  Arguments copies = arguments;
  copies.insert(copies.begin(), "reebquad");
  std::vector<char*> argv;
  for (std::string& argument : copies) argv.push_back(argument.data());
  argv.push_back(nullptr);
  const int log = ::open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (log < 0)
    throw Failure(Exit_code::other_failure,
                  errors + ": the file cannot be written: " + std::generic_category().message(errno));
  const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  const pid_t parent = ::getpid();
  m_process = ::fork();
  if (m_process == 0) become_program(argv.data(), log, nowhere, rlim_t(limits.megabytes) << 20, lock, parent);
  const int error = errno;
  ::close(log);
  ::close(nowhere);
  if (m_process < 0)
    throw Failure(Exit_code::other_failure,
                  "the system refused a process: " + std::generic_category().message(error));
}

Batch_child::Batch_child(Batch_child&& other) noexcept {
  *this = std::move(other);
}

Batch_child& Batch_child::operator=(Batch_child&& other) noexcept {
  std::swap(m_process, other.m_process);
  m_start = other.m_start;
  m_seconds = other.m_seconds;
  m_is_stopped = other.m_is_stopped;
  return *this;
}

Batch_child::~Batch_child() {
  if (m_process <= 0) return;
  ::kill(m_process, SIGKILL);
  while (::waitpid(m_process, nullptr, 0) < 0 && errno == EINTR) {
  }
}

std::optional<Child_end> Batch_child::end() {
  const double seconds = std::chrono::duration<double>(Clock::now() - m_start).count();
  if (m_seconds > 0 && seconds > m_seconds && !m_is_stopped) {
    m_is_stopped = true;
    ::kill(m_process, SIGKILL); // its files are written whole or not at all
  }
  int status = 0;
  rusage usage{};
  if (::wait4(m_process, &status, WNOHANG, &usage) != m_process) return std::nullopt;
  m_process = -1;
  Child_end end;
  end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  end.code = end.signal > 0 ? 128 + end.signal : WEXITSTATUS(status);
  end.is_time_limit = m_is_stopped && end.signal == SIGKILL;
  end.seconds = seconds;
  end.cpu_seconds = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
#ifdef __APPLE__
  end.peak_megabytes = double(usage.ru_maxrss) / (1 << 20);
#else
  end.peak_megabytes = double(usage.ru_maxrss) / (1 << 10);
#endif
  return end;
}

} // namespace reebquad
