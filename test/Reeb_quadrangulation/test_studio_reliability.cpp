// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing is lost, whichever system call fails and at whichever the process is killed. The calls that write
// are ours here: each counts, and one of them fails or kills.
#include "temporary_folder.h"

#include "session/Folder.h"
#include "session/Store.h"

#include <CGAL/Reeb_quadrangulation/IO/atomic_file.h>
#include <CGAL/Reeb_quadrangulation/IO/read_file.h>

#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <functional>
#include <iostream>
#include <memory>
#include <set>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace CGAL::Reeb_quadrangulation;
using reebquad::studio::digest;
using reebquad::studio::Folder;
using reebquad::studio::Saved_session;
using reebquad::studio::Store;

namespace {

struct Trap {
  int at = 0;              ///< the call that fails, counted from 1; 0: none
  int error = 0;           ///< what it says; 0: it kills the process
  bool has_unnamed = true; ///< whether the file system has files without names
  int calls = 0;
};
Trap trap;

/// Whether this call is to fail; `errno` is set then.
bool is_caught() {
  if (trap.at == 0 || ++trap.calls != trap.at) return false;
  if (trap.error == 0) ::kill(::getpid(), SIGKILL);
  errno = trap.error;
  return true;
}

long raw(long number, long a, long b = 0, long c = 0, long d = 0, long e = 0) {
  return ::syscall(number, a, b, c, d, e);
}

} // namespace

extern "C" {
int open(const char* path, int flags, ...) {
  mode_t mode = 0;
  if ((flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE) {
    va_list rest;
    va_start(rest, flags);
    mode = mode_t(va_arg(rest, int));
    va_end(rest);
  }
  if ((flags & O_TMPFILE) == O_TMPFILE && !trap.has_unnamed) {
    errno = EOPNOTSUPP;
    return -1;
  }
  if ((flags & O_ACCMODE) != O_RDONLY && is_caught()) return -1;
  return int(raw(SYS_openat, AT_FDCWD, long(path), flags, mode));
}
ssize_t write(int file, const void* bytes, size_t size) {
  return is_caught() ? -1 : ssize_t(raw(SYS_write, file, long(bytes), long(size)));
}
int fsync(int file) {
  return is_caught() ? -1 : int(raw(SYS_fsync, file));
}
int fchmod(int file, mode_t mode) {
  return is_caught() ? -1 : int(raw(SYS_fchmod, file, long(mode)));
}
int close(int file) {
  const bool fails = is_caught();
  const int closed = int(raw(SYS_close, file)), error = trap.error;
  if (!fails) return closed;
  errno = error;
  return -1;
}
int linkat(int from, const char* old, int to, const char* path, int flags) noexcept {
  return is_caught() ? -1 : int(raw(SYS_linkat, from, long(old), to, long(path), flags));
}
int rename(const char* from, const char* to) noexcept {
  return is_caught() ? -1 : int(raw(SYS_renameat2, AT_FDCWD, long(from), AT_FDCWD, long(to), 0));
}
int mkdir(const char* path, mode_t mode) noexcept {
  return is_caught() ? -1 : int(raw(SYS_mkdirat, AT_FDCWD, long(path), long(mode)));
}
}

namespace {

std::set<std::string> files_in(const std::string& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

/// Does the work with the n-th call caught, for n = 1, 2, ..., and looks at what there is after each; the
/// number of calls that there are.
int catch_each(int error, const std::function<void()>& prepare, const std::function<bool()>& work,
               const std::function<void(bool done)>& look) {
  for (int n = 1;; ++n) {
    prepare();
    trap.calls = 0;
    trap.error = error;
    if (error != 0) {
      trap.at = n;
      const bool done = work();
      trap.at = 0;
      look(done);
      if (trap.calls < n) return n - 1;
      continue;
    }
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      trap.at = n;
      _exit(work() ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    look(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    if (WIFEXITED(status)) return n - 1;
  }
}

} // namespace

TEST_CASE("a file is the old one or the new one, whichever call fails or kills") {
  const Temporary_folder folder;
  const std::string path = folder.path("file"), old(3000, 'o'), fresh(5000, 'n');
  int calls = 0, kills = 0;
  for (const bool has_unnamed : {true, false})
    for (const int error : {0, EIO, ENOSPC, EDQUOT}) {
      trap.has_unnamed = has_unnamed;
      std::string said;
      const auto prepare = [&] {
        for (const std::string& name : files_in(folder.path(""))) std::filesystem::remove(folder.path(name));
        REQUIRE(write_file_atomically(path, old));
      };
      const auto work = [&] {
        const Result<void> written = write_file_atomically(path, fresh);
        said = written ? "" : written.error().message;
        return bool(written);
      };
      const auto look = [&](bool done) {
        const std::string now = contents(path);
        CHECK((now == fresh || (now == old && !done)));
        // An error means that the old file is there, but for the last one, which says that it is not.
        if (error != 0 && !done) CHECK((now == fresh) == (said.find("is written") != std::string::npos));
        std::set<std::string> names = files_in(folder.path(""));
        if (error != 0) CHECK(names == std::set<std::string>{"file"});
        if (error != 0 || names.size() == 1) return;
        // What a kill leaves, where there must be a name for a moment, goes when it is old enough to be
        // nobody's.
        REQUIRE(names.size() == 2);
        names.erase("file");
        const std::string left = folder.path(*names.begin());
        REQUIRE(write_file_atomically(path, old));
        CHECK(std::filesystem::exists(left));
        std::filesystem::last_write_time(left, std::filesystem::file_time_type::clock::now() -
                                                   std::chrono::minutes(2));
        REQUIRE(write_file_atomically(path, old));
        CHECK(!std::filesystem::exists(left));
      };
      (error == 0 ? kills : calls) += catch_each(error, prepare, work, look);
    }
  trap.has_unnamed = true;
  CHECK(calls >= 30);
  CHECK(kills >= 10);
  std::cout << "a file: " << calls << " calls failed, " << kills << " kills, nothing lost\n";
}

TEST_CASE("a session is the old one or the new one, whichever call fails or kills") {
  const std::string mesh = "OFF a mesh", other = "OFF another";
  const auto session = [&](const std::string& bytes, int edits) {
    Saved_session s;
    s.name = "a.off";
    s.bytes = bytes.size();
    s.digest = digest(bytes);
    s.parts.emplace_back();
    for (int i = 0; i < edits; ++i) s.parts[0].edits.push_back({{"edit", "suggest"}});
    return s;
  };
  int calls = 0, kills = 0;
  for (const bool is_first : {true, false})
    for (const int error : {0, EIO, ENOSPC}) {
      std::unique_ptr<Temporary_folder> folder;
      std::unique_ptr<Store> store;
      const auto prepare = [&] {
        folder = std::make_unique<Temporary_folder>();
        store = std::make_unique<Store>(Folder(folder->path("")));
        if (is_first) return;
        for (const std::string& bytes : {other, mesh}) {
          REQUIRE(store->save_upload(session(bytes, 1), bytes));
          REQUIRE(store->save(session(bytes, 1)));
        }
      };
      const auto work = [&] {
        const Saved_session now = session(mesh, 2);
        return store->save_upload(now, mesh) && store->save(now);
      };
      const auto look = [&](bool done) {
        const std::optional<Saved_session> now = store->load(digest(mesh));
        if (now) CHECK(bool(store->load_mesh(*now)));
        if (!is_first) {
          REQUIRE(now);
          const std::optional<Saved_session> kept = store->load(digest(other));
          REQUIRE(kept);
          CHECK(kept->number_of_edits() == 1);
          CHECK(bool(store->load_mesh(*kept)));
        }
        if (done) {
          REQUIRE(now);
          CHECK(now->number_of_edits() == 2);
        }
        CHECK(store->unreadable().empty());
      };
      (error == 0 ? kills : calls) += catch_each(error, prepare, work, look);
    }
  CHECK(calls >= 30);
  CHECK(kills >= 15);
  std::cout << "a session: " << calls << " calls failed, " << kills << " kills, nothing lost\n";
}

TEST_CASE("permissions stay, but not those to run a file in its owner's name") {
  const Temporary_folder folder;
  const std::string path = folder.write("file", "old");
  REQUIRE(chmod(path.c_str(), 06751) == 0);
  REQUIRE(write_file_atomically(path, "new"));
  struct stat status;
  REQUIRE(stat(path.c_str(), &status) == 0);
  CHECK((status.st_mode & 07777) == 0751);
}

TEST_CASE("reading waits for nobody and has an end") {
  const Temporary_folder folder;
  const std::string pipe_path = folder.path("pipe");
  REQUIRE(mkfifo(pipe_path.c_str(), 0600) == 0);
  for (const std::string& path :
       {pipe_path, std::string("/dev/zero"), folder.path(""), folder.path("none")}) {
    CAPTURE(path);
    const Result<std::string> bytes = read_file(path, 1000000);
    REQUIRE(!bytes);
    CHECK(bytes.error().code == Error_code::unreadable_file);
  }
  CHECK(!read_file(folder.write("long", std::string(1001, 'x')), 1000));
  const std::string whole(200001, 'y');
  CHECK(*read_file(folder.write("whole", whole), whole.size()) == whole);
  std::filesystem::create_symlink(folder.path("whole"), folder.path("link"));
  CHECK(read_file(folder.path("link"), whole.size()));
  CHECK(!read_file(folder.path("link"), whole.size(), Symbolic_link::refused));

  // A pipe that someone writes into, slowly, is read to its end.
  const pid_t writer = fork();
  REQUIRE(writer >= 0);
  const int reads = ::open(pipe_path.c_str(), O_RDWR);
  if (writer == 0) {
    for (int i = 0; i < 3; ++i) {
      usleep(20000);
      if (::write(reads, "abc", 3) != 3) _exit(1);
    }
    _exit(0);
  }
  const auto close_later = [&] {
    waitpid(writer, nullptr, 0);
    ::close(reads);
  };
  std::thread closer(close_later);
  const Result<std::string> bytes = read_file(pipe_path, 1000);
  closer.join();
  REQUIRE(bytes);
  CHECK(*bytes == "abcabcabc");
}
