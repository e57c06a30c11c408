// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SERVER_WORKER_H
#define REEBQUAD_SERVER_WORKER_H

#include <CGAL/Reeb_quadrangulation/Observer.h>

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

namespace reebquad {
namespace studio {

/// One thread that does the jobs one after the other, so that the sockets are served while a mesh is made.
class Worker {
public:
  using Observer = CGAL::Reeb_quadrangulation::Observer;
  /// What it throws is given to `failed`; the worker goes on.
  using Job = std::function<void(Observer&)>;
  using Failed = std::function<void(const std::string& what)>;
  /// Called from the worker's thread, at most about 20 times a second; an empty stage means that there is no
  /// job.
  using Progress = std::function<void(const std::string& stage, double fraction)>;

  explicit Worker(Progress progress);
  /// Asks the running job to stop and waits for it; jobs that have not begun are dropped.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// A job that is `replaceable` is cancelled when the next job comes that `replaces`; but of those with the
  /// same `drag`, if that is not 0, each is carried out, so that all of them can be seen. False if too many
  /// jobs wait.
  bool push(Job job, Failed failed, bool replaceable = false, bool replaces = true, std::int64_t drag = 0);
  /// Asks the running job and all that wait to stop; they still run, and see that they are cancelled.
  void cancel();

private:
  class Job_observer;
  struct Entry {
    Job job;
    Failed failed;
    bool replaceable = false;
    std::int64_t drag = 0;
    std::atomic<bool> cancelled{false};
  };

  void work();

  Progress m_progress;
  std::mutex m_mutex;
  std::condition_variable m_wake;
  std::deque<std::shared_ptr<Entry>> m_queue;
  std::shared_ptr<Entry> m_running;
  bool m_stop = false;
  std::thread m_thread; // last: it uses all the others
};

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_SERVER_WORKER_H
