// SPDX-License-Identifier: GPL-3.0-or-later
// reebquad batch IN... -o DIR: a collection of meshes, each run in a process of its own, with a record of
// each.
#include "Batch_child.h"
#include "Batch_record.h"
#include "Batch_tables.h"
#include "Interruption.h"
#include "Outputs.h"
#include "Run_options.h"

#include <CGAL/Reeb_quadrangulation/IO/atomic_file.h>
#include <CGAL/Reeb_quadrangulation/IO/mesh_format.h>
#include <CGAL/Reeb_quadrangulation/render.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <deque>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sys/file.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;
namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

using Texts = std::vector<std::string>;

struct Batch_options {
  Texts inputs;
  std::string folder; ///< absolute
  Texts one;
  int jobs = 1;
  Child_limits limits;
  int share = 1, shares = 1;
  std::string format;
  int html_rows = 2000;
  bool retries = false, only_lists = false, only_tables = false, quiet = false;
  Arguments run; ///< handed on
  bool is_whole() const { return shares == 1 && one.empty(); }
};

void write_whole(const std::string& file, const std::string& bytes) {
  const Uninterruptible whole;
  succeed_or_fail(write_file_atomically(file, bytes), file);
}

/// The end of what a child said, without the program's name.
std::string last_sentence(const std::string& log) {
  std::ifstream stream(log, std::ios::binary);
  std::string line, last;
  constexpr std::streamoff most = 1 << 16;
  stream.seekg(0, std::ios::end);
  stream.seekg(std::max<std::streamoff>(0, std::streamoff(stream.tellg()) - most));
  while (std::getline(stream, line))
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  const std::string prefix = "reebquad: ";
  if (last.rfind(prefix, 0) == 0) last.erase(0, prefix.size());
  last.erase(0, last.find_first_not_of(' ') == std::string::npos ? 0 : last.find_first_not_of(' '));
  return one_line(last);
}

/// The folder of a mesh's results, held for one process: a lock of the folder itself, which the system
/// takes back from a process that was killed.
class Held_folder {
public:
  explicit Held_folder(const std::string& folder)
      : m_file(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    // Where the file system has no locks, it is as if there were no other process.
    m_is_elsewhere = m_file >= 0 && ::flock(m_file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  }
  Held_folder(Held_folder&& other) noexcept
      : m_file(std::exchange(other.m_file, -1)), m_is_elsewhere(other.m_is_elsewhere) {}
  Held_folder& operator=(Held_folder&& other) noexcept {
    std::swap(m_file, other.m_file);
    m_is_elsewhere = other.m_is_elsewhere;
    return *this;
  }
  ~Held_folder() {
    if (m_file >= 0) ::close(m_file);
  }
  bool is_elsewhere() const { return m_is_elsewhere; }
  int file() const { return m_file; }

private:
  int m_file;
  bool m_is_elsewhere = false;
};

class Batch {
public:
  explicit Batch(const Batch_options& options) : m_options(options), m_request(options.run) {
    m_request.insert(m_request.begin(), options.format);
  }

  Exit_code execute() {
    m_jobs = m_options.one.empty() ? find_jobs(m_options.inputs, m_options.folder)
                                   : find_named_jobs(m_options.inputs, m_options.folder, m_options.one);
    const auto is_other = [&](const Batch_job& job) {
      return !is_in_share(job, m_options.share, m_options.shares);
    };
    m_jobs.erase(std::remove_if(m_jobs.begin(), m_jobs.end(), is_other), m_jobs.end());
    if (m_options.only_lists) return list_pending();
    fs::create_directories(m_options.folder);
    if (!m_options.only_tables) work();
    if (m_options.is_whole()) write_tables();
    return tell_outcome();
  }

private:
  struct Task {
    const Batch_job* job;
    Held_folder folder;
    Batch_record record;
    Batch_child child;
  };
  enum class Start { started, done, elsewhere };

  std::string folder_of(const Batch_job& job) const { return m_options.folder + "/meshes/" + job.name; }
  std::string result(const Batch_job& job, const std::string& name) const {
    return folder_of(job) + '/' + name;
  }
  std::string quads(const Batch_job& job) const { return result(job, "quads." + m_options.format); }

  /// The record of a mesh that is done; none if there is none, or one of other bytes or of another request.
  std::optional<Batch_record> valid_record(const Batch_job& job) const {
    std::optional<Batch_record> record = read_record(result(job, "record.json"));
    if (record && record->request == m_request && is_of(*record, job.file)) return record;
    if (record && record->file != one_line(job.file) && fs::exists(record->file))
      throw Usage_error(folder_of(job) + " has the results of another mesh, " + record->file +
                        "; give each collection a folder of its own");
    return std::nullopt;
  }

  bool is_done(const Batch_job& job) const {
    const std::optional<Batch_record> record = valid_record(job);
    return record && !(m_options.retries && record->is_failed());
  }

  Exit_code list_pending() const {
    for (const Batch_job& job : m_jobs)
      if (!is_done(job)) std::cout << job.name << '\n';
    return Exit_code::success;
  }

  void work() {
    std::deque<const Batch_job*> queue;
    for (const Batch_job& job : m_jobs) queue.push_back(&job);
    m_total = queue.size();
    while (!queue.empty() || !m_tasks.empty()) {
      if (interrupted()) stop();
      bool is_idle = !collect();
      // Those that another process has in hand are looked at again until it is done with them, or gone.
      for (std::size_t tries = queue.size(); tries > 0 && m_tasks.size() < std::size_t(m_options.jobs);
           --tries) {
        const Batch_job* const job = queue.front();
        queue.pop_front();
        const Start start = begin(*job);
        if (start == Start::elsewhere) queue.push_back(job);
        is_idle = is_idle && start == Start::elsewhere;
        if (interrupted()) stop();
      }
      if (is_idle) std::this_thread::sleep_for(std::chrono::milliseconds(m_tasks.empty() ? 200 : 10));
    }
  }

  [[noreturn]] void stop() {
    m_tasks.clear(); // kills the children; what they had begun has no record
    const std::size_t left = m_total - m_finished;
    throw Failure(Exit_code::interrupted, "interrupted; " + std::to_string(left) +
                                              (left == 1 ? " mesh is" : " meshes are") +
                                              " left, which the same command goes on with");
  }

  Start begin(const Batch_job& job) {
    if (is_done(job)) {
      ++m_finished;
      return Start::done;
    }
    fs::create_directories(folder_of(job));
    Held_folder folder(folder_of(job));
    if (folder.is_elsewhere()) return Start::elsewhere;
    if (is_done(job)) { // since another process has let go
      ++m_finished;
      return Start::done;
    }
    // What an earlier request left is gone before anything new comes, so that there is never a result of
    // one beside a record of another.
    for (const auto& entry : fs::directory_iterator(folder_of(job)))
      if (entry.is_regular_file() && is_result(entry.path().filename().string())) fs::remove(entry.path());
    Batch_record record = begin_record(job, m_request);
    Batch_child child(arguments(job), result(job, "log.txt"), m_options.limits, folder.file());
    m_tasks.push_back({&job, std::move(folder), std::move(record), std::move(child)});
    return Start::started;
  }

  static bool is_result(const std::string& name) {
    return name == "record.json" || name == "report.json" || name == "thumbnail.png" || name == "log.txt" ||
           name.rfind("quads.", 0) == 0;
  }

  Arguments arguments(const Batch_job& job) const {
    Arguments all{"run", job.file, "-o", quads(job), "--report", result(job, "report.json"), "--quiet"};
    if (can_write_png()) all.insert(all.end(), {"--thumbnail", result(job, "thumbnail.png")});
    const bool has_threads =
        std::any_of(m_options.run.begin(), m_options.run.end(), [](const std::string& text) {
          return text == "--threads" || text.rfind("--threads=", 0) == 0;
        });
    if (!has_threads) {
      all.push_back("--threads");
      all.push_back(std::to_string(std::max(1, int(std::thread::hardware_concurrency()) / m_options.jobs)));
    }
    all.insert(all.end(), m_options.run.begin(), m_options.run.end());
    return all;
  }

  /// Whether a child has ended.
  bool collect() {
    bool has_ended = false;
    for (std::size_t t = 0; t < m_tasks.size();) {
      const std::optional<Child_end> end = m_tasks[t].child.end();
      if (!end) {
        ++t;
        continue;
      }
      has_ended = true;
      finish(m_tasks[t], *end);
      m_tasks.erase(m_tasks.begin() + std::ptrdiff_t(t));
    }
    return has_ended;
  }

  void finish(Task& task, const Child_end& end) {
    if (end.code == int(Exit_code::interrupted) || end.code == 127) {
      // Whoever ended the child did not mean the mesh: it has no record and is done another time.
      m_tasks.clear();
      throw Failure(end.code == 127 ? Exit_code::other_failure : Exit_code::interrupted,
                    end.code == 127 ? "this program cannot be started again" : "a run was interrupted");
    }
    const Batch_job& job = *task.job;
    Batch_record& record = task.record;
    record.exit_code = end.code;
    record.seconds = end.seconds;
    record.cpu_seconds = end.cpu_seconds;
    record.peak_megabytes = end.peak_megabytes;
    const bool has_quads = end.code == 0 || end.code == int(Exit_code::in_part);
    record.outcome = end.code == 0 ? "certified" : has_quads ? "in part" : "failed";
    if (end.code != 0) record.sentence = sentence_of(end, last_sentence(result(job, "log.txt")));
    take_report(result(job, "report.json"), record);
    const Uninterruptible whole;
    std::error_code ignored;
    if (fs::file_size(result(job, "log.txt"), ignored) == 0) fs::remove(result(job, "log.txt"), ignored);
    write_whole(result(job, "record.json"), to_json_line(record));
    ++m_finished;
    tell(record);
  }

  std::string sentence_of(const Child_end& end, const std::string& said) const {
    char limit[64];
    std::snprintf(limit, sizeof limit, "%g s are over (--time)", m_options.limits.seconds);
    if (end.is_time_limit) return limit;
    if (end.signal > 0)
      return std::string("ended by signal ") + std::to_string(end.signal) + " (" + ::strsignal(end.signal) +
             ")" + (said.empty() ? "" : ": " + said);
    if (said == "memory ran out" && m_options.limits.megabytes > 0)
      return said + " at " + std::to_string(m_options.limits.megabytes) + " MB (--memory)";
    return said;
  }

  void tell(const Batch_record& record) const {
    if (m_options.quiet) return;
    char numbers[96];
    std::snprintf(numbers, sizeof numbers, "%d quads, %.1f s, %.0f MB", record.quads, record.seconds,
                  record.peak_megabytes);
    std::cerr << '[' << m_finished << '/' << m_total << "] " << record.name << ": " << record.outcome;
    if (!record.is_failed()) std::cerr << ", " << numbers;
    if (!record.warnings.empty()) std::cerr << ", warning: " << record.warnings.front();
    if (!record.sentence.empty()) std::cerr << ": " << record.sentence;
    std::cerr << std::endl;
  }

  void write_tables() const {
    std::vector<Batch_row> rows;
    for (const Batch_job& job : m_jobs) rows.push_back({job, valid_record(job), folder_of(job)});
    write_whole(m_options.folder + "/batch.csv", csv_table(rows));
    write_whole(m_options.folder + "/batch.jsonl", json_lines(rows));
    write_whole(m_options.folder + "/batch.html",
                html_overview(std::move(rows), m_options.folder, std::size_t(m_options.html_rows)));
  }

  Exit_code tell_outcome() const {
    std::size_t good = 0, in_part = 0, failed = 0;
    for (const Batch_job& job : m_jobs)
      if (const std::optional<Batch_record> record = valid_record(job))
        ++(record->is_good() ? good : record->is_failed() ? failed : in_part);
    const std::size_t pending = m_jobs.size() - good - in_part - failed;
    std::cout << m_jobs.size() << (m_jobs.size() == 1 ? " mesh: " : " meshes: ") << good << " certified, "
              << in_part << " in part, " << failed << " failed"
              << (pending > 0 ? ", " + std::to_string(pending) + " pending" : "");
    if (m_options.is_whole()) std::cout << "; " << one_line(m_options.folder) << "/batch.html shows them";
    std::cout << '\n';
    return in_part + failed + pending > 0 ? Exit_code::in_part : Exit_code::success;
  }

  const Batch_options& m_options;
  Arguments m_request;
  std::vector<Batch_job> m_jobs;
  std::vector<Task> m_tasks;
  std::size_t m_total = 0, m_finished = 0;
};

void declare_batch_options(Command_line& line) {
  const int cores = std::max(1, int(std::thread::hardware_concurrency()));
  line.options.add_options()                                                                  //
      ("output,o", po::value<std::string>()->value_name("DIR"), "the folder of all results")  //
      ("jobs", po::value<int>()->value_name("N")->default_value(cores), "how many at a time") //
      ("memory", po::value<int>()->value_name("MB")->default_value(0),
       "how much memory each may ask for; 0: no limit") //
      ("time", po::value<double>()->value_name("SECONDS")->default_value(0),
       "how long each may take; 0: no limit") //
      ("format", po::value<std::string>()->value_name("EXT")->default_value("obj"),
       "of the quads: the extension of a format that is written") //
      ("retry", "try again what has failed")                      //
      ("shard", po::value<std::string>()->value_name("I/N"),
       "do share I of N only: all shares together are everything, each mesh once") //
      ("one", po::value<Texts>()->composing()->value_name("NAME"),
       "do the mesh of that name only, as --pending prints it (repeatable)")         //
      ("pending", "print the names of the meshes that are not done, and do nothing") //
      ("table", "write the tables of what is done, and do nothing else")             //
      ("html-rows", po::value<int>()->value_name("N")->default_value(2000),
       "how many meshes the overview shows, failures first") //
      ("quiet", "print errors and the last line only");
  line.hidden.add_options()("IN", po::value<Texts>());
  line.positional.add("IN", -1);
}

template <class T> T at_least(const Command_line& line, const char* option, T low, T high) {
  const T value = line.values[option].as<T>();
  if (value >= low && value <= high) return value;
  throw Usage_error("--" + std::string(option) + " is out of range");
}

void set_share(const std::string& text, Batch_options& options) {
  char rest = 0;
  if (std::sscanf(text.c_str(), "%9d/%9d%c", &options.share, &options.shares, &rest) != 2 ||
      options.share < 1 || options.share > options.shares)
    throw Usage_error("--shard is I/N with I from 1 to N, as in 3/8; it got '" + text + "'");
}

/// Options of run that name one file make no sense for many meshes; the others are tried before anything
/// begins.
void check_run_options(const Batch_options& options) {
  for (const std::string& text : options.run)
    for (const char* own : {"--output", "--report", "--html", "--pictures", "--write-recipe", "--thumbnail",
                            "--force", "--quiet", "--help", "-o", "-h"})
      if (text == own || text.rfind(std::string(own) + (own[1] == '-' ? "=" : ""), 0) == 0)
        throw Usage_error(std::string(own) + ": batch itself sees to that");
  Arguments tried{"mesh", "-o", "quads." + options.format};
  tried.insert(tried.end(), options.run.begin(), options.run.end());
  if (!parse_run_options(tried))
    throw Usage_error("no help is to be had behind --; 'reebquad run --help' has it");
}

std::optional<Batch_options> parse_batch_options(const Arguments& arguments) {
  Command_line line("batch IN... -o DIR [options] [-- options of run]");
  declare_batch_options(line);
  const auto bar = std::find(arguments.begin(), arguments.end(), "--");
  if (!line.parse({arguments.begin(), bar})) return std::nullopt;
  Batch_options options;
  if (bar != arguments.end()) options.run.assign(bar + 1, arguments.end());
  if (!line.has("IN")) throw Usage_error("IN is missing\nUsage: reebquad " + line.usage);
  options.inputs = line.values["IN"].as<Texts>();
  options.folder = fs::absolute(line.required("output")).lexically_normal().string();
  if (options.folder.size() > 1 && options.folder.back() == '/') options.folder.pop_back();
  options.jobs = at_least(line, "jobs", 1, 4096);
  options.limits.megabytes = at_least(line, "memory", 0, 1 << 30);
  options.limits.seconds = at_least(line, "time", 0.0, 1e9);
  options.format = line.text("format");
  if (options.format.find('/') != std::string::npos ||
      format_of_extension("quads." + options.format) == Mesh_format::automatic)
    throw Usage_error("--format: '" + options.format + "' is not the extension of a format that is written");
  options.html_rows = at_least(line, "html-rows", 1, 1000000);
  if (line.has("one")) options.one = line.values["one"].as<Texts>();
  if (line.has("shard")) set_share(line.text("shard"), options);
  if (line.has("one") && line.has("shard")) throw Usage_error("--one and --shard exclude each other");
  options.retries = line.has("retry");
  options.only_lists = line.has("pending");
  options.only_tables = line.has("table");
  options.quiet = line.has("quiet");
  check_run_options(options);
  return options;
}

} // namespace

Exit_code execute_batch(const Arguments& arguments) {
  const std::optional<Batch_options> options = parse_batch_options(arguments);
  if (!options) return Exit_code::success;
  watch_for_interruption();
  return Batch(*options).execute();
}

} // namespace reebquad
