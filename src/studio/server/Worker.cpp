// SPDX-License-Identifier: GPL-3.0-or-later
#include "server/Worker.h"

#include <chrono>
#include <new>

namespace reebquad {
namespace studio {

namespace {
constexpr std::size_t longest_queue = 100;
constexpr std::chrono::milliseconds between_reports{50};
} // namespace

class Worker::Job_observer : public Observer {
public:
  Job_observer(const Entry& entry, const Progress& report) : m_entry(entry), m_report(report) {}

  void progress(const std::string& stage, double fraction) override {
    const auto now = std::chrono::steady_clock::now();
    if (now - m_last < between_reports) return;
    m_last = now;
    m_report(stage, fraction);
  }
  bool cancelled() const override { return m_entry.cancelled.load(std::memory_order_relaxed); }

private:
  const Entry& m_entry;
  const Progress& m_report;
  std::chrono::steady_clock::time_point m_last{};
};

Worker::Worker(Progress progress) : m_progress(std::move(progress)), m_thread([this] { work(); }) {}

Worker::~Worker() {
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_stop = true;
    m_queue.clear();
    if (m_running) m_running->cancelled = true;
  }
  m_wake.notify_all();
  m_thread.join();
}

bool Worker::push(Job job, Failed failed, bool replaceable, bool replaces, std::int64_t drag) {
  const std::lock_guard<std::mutex> lock(m_mutex);
  if (m_queue.size() >= longest_queue) return false;
  const auto goes = [&](const Entry& entry) {
    return replaces && entry.replaceable && (drag == 0 || entry.drag != drag);
  };
  if (m_running && goes(*m_running)) m_running->cancelled = true;
  for (const auto& waiting : m_queue)
    if (goes(*waiting)) waiting->cancelled = true;
  auto entry = std::make_shared<Entry>();
  entry->job = std::move(job);
  entry->failed = std::move(failed);
  entry->replaceable = replaceable;
  entry->drag = drag;
  m_queue.push_back(std::move(entry));
  m_wake.notify_all();
  return true;
}

void Worker::cancel() {
  const std::lock_guard<std::mutex> lock(m_mutex);
  if (m_running) m_running->cancelled = true;
  for (const auto& waiting : m_queue) waiting->cancelled = true;
}

void Worker::work() {
  for (;;) {
    std::shared_ptr<Entry> entry;
    {
      std::unique_lock<std::mutex> lock(m_mutex);
      m_running.reset();
      m_wake.wait(lock, [this] { return m_stop || !m_queue.empty(); });
      if (m_stop) return;
      entry = m_queue.front();
      m_queue.pop_front();
      m_running = entry;
    }
    try {
      Job_observer observer(*entry, m_progress);
      entry->job(observer);
    } catch (const std::bad_alloc&) {
      entry->failed("memory ran out");
    } catch (const std::exception& error) {
      entry->failed(error.what());
    }
    m_progress("", 1);
  }
}

} // namespace studio
} // namespace reebquad
