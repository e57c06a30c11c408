// SPDX-License-Identifier: GPL-3.0-or-later
#include "Interruption.h"

#include "Exit_code.h"

#include <atomic>
#include <csignal>
#include <sys/time.h>
#include <unistd.h>

namespace reebquad {

namespace {

std::atomic<bool> stop_requested{false};
std::atomic<int> uninterruptible{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "signal handlers may use lock-free atomics only");

void end_process() {
  if (uninterruptible.load() == 0) _exit(static_cast<int>(Exit_code::interrupted));
}

void on_interrupt(int) {
  if (stop_requested.exchange(true)) end_process();
  // Repeats, so that work which is uninterruptible now is ended soon after it is not.
  const itimerval deadline{{0, 50000}, {0, 400000}};
  setitimer(ITIMER_REAL, &deadline, nullptr);
}

void on_deadline(int) {
  end_process();
}

} // namespace

void watch_for_interruption() {
  struct sigaction action = {};
  action.sa_flags = SA_RESTART;
  action.sa_handler = on_deadline;
  sigaction(SIGALRM, &action, nullptr);
  action.sa_handler = on_interrupt;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() {
  return stop_requested.load();
}

Uninterruptible::Uninterruptible() {
  ++uninterruptible;
}
Uninterruptible::~Uninterruptible() {
  --uninterruptible;
}

} // namespace reebquad
