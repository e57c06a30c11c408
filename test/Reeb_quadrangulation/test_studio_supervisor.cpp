// SPDX-License-Identifier: GPL-3.0-or-later
// A crash of the studio's engine is not the end of the studio, nor of the work.
#include "studio_client.h"
#include "temporary_folder.h"
#include "tiny_surfaces.h"

#include "server/Server.h"
#include "server/Supervisor.h"

#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>

#include <csignal>
#include <cstdlib>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace CGAL::Reeb_quadrangulation;
using namespace reebquad::studio;

namespace {

/// What the child tells: which process it is, and the address that it prints.
struct Told {
  pid_t child = 0;
  char url[200] = {};
};

/// A studio in a process of its own: the supervisor and, under it, the child that serves.
class Studio {
public:
  explicit Studio(const std::string& folder) {
    REQUIRE(pipe(m_pipe) == 0);
    m_process = fork();
    REQUIRE(m_process >= 0);
    if (m_process > 0) return;
    for (const int signal : {SIGSEGV, SIGTERM, SIGABRT}) std::signal(signal, SIG_DFL); // not Catch2's report
    const Doorway doorway(folder, 0);
    const auto serve = [&](int crashes) {
      Start start;
      start.resumes = crashes == 1;
      const Server server(doorway, start);
      Told told;
      told.child = getpid();
      server.url().copy(told.url, sizeof told.url - 1);
      if (write(m_pipe[1], &told, sizeof told) != sizeof told) return 1;
      for (;;) pause();
    };
    _exit(supervise(
        serve, [] { return false; }, [](int, int) {}));
  }
  ~Studio() {
    // Never `kill(-1, ...)` or `kill(0, ...)`, which are for many.
    if (m_process > 0 && kill(m_process, SIGKILL) == 0) waitpid(m_process, nullptr, 0);
    close(m_pipe[0]);
    close(m_pipe[1]);
  }
  Studio(const Studio&) = delete;
  Studio& operator=(const Studio&) = delete;

  /// Of the child that started last; waits until one does.
  Told next() {
    Told told;
    REQUIRE(read(m_pipe[0], &told, sizeof told) == sizeof told);
    REQUIRE(told.child > 1);
    return told;
  }
  /// The exit code of the supervisor.
  int wait() {
    int status = 0;
    REQUIRE(waitpid(m_process, &status, 0) == m_process);
    m_process = 0;
    return WEXITSTATUS(status);
  }

private:
  int m_pipe[2];
  pid_t m_process; ///< 0 when it has ended
};

/// False also for a process that has ended but that nobody has asked for its exit code.
bool is_running(pid_t process) {
  const std::string stat = contents("/proc/" + std::to_string(process) + "/stat");
  const std::size_t end = stat.rfind(')');
  return end != std::string::npos && stat.substr(end, 4) != ") Z ";
}

/// The next state in which so many edits are applied.
nlohmann::json state_with(Page_socket& page, int applied) {
  nlohmann::json state = page.last_state;
  while (state.value("applied", -1) != applied) state = page.wait_for("event", "state");
  return state;
}

} // namespace

TEST_CASE(
    "a studio that is killed under load goes on at the same address with the work up to the last edit") {
  const char* const asked = std::getenv("REEBQUAD_CRASHES");
  const int rounds = asked ? std::atoi(asked) : 5;
  for (int round = 0; round < rounds; ++round) {
    const Temporary_folder folder;
    folder.write("t.off", torus_file());
    Studio studio(folder.path(""));
    const Told first = studio.next();
    const Visitor us = enter(first.url);
    int saved = 0;
    {
      Page_socket page(us);
      REQUIRE(page.request({{"id", 1}, {"command", "open_file"}, {"name", "t.off"}})["ok"] == true);
      REQUIRE(page.request({{"id", 2}, {"command", "edit"}, {"edit", {{"edit", "suggest"}}}})["ok"] == true);
      REQUIRE(page.request({{"id", 3},
                            {"command", "edit"},
                            {"edit", {{"edit", "set_target"}, {"quads", 600}}}})["ok"] == true);
      saved = 2;
      for (int id = 4; id < 8; ++id) // nobody waits for these
        page.send(nlohmann::json{
            {"id", id}, {"command", "edit"}, {"edit", {{"edit", "set_target"}, {"quads", 500 + 50 * id}}}}
                      .dump());
      std::this_thread::sleep_for(std::chrono::milliseconds(7 * round % 60));
      REQUIRE(kill(first.child, round % 2 == 0 ? SIGSEGV : SIGKILL) == 0);
    }
    CHECK(studio.next().child != first.child);
    Page_socket page(us); // the same secret opens it at the same port
    REQUIRE(page.opening.status == 101);
    nlohmann::json state = page.last_state;
    while (state.is_null() || !state.contains("applied")) state = page.wait_for("event", "state");
    REQUIRE(page.request({{"id", 1}, {"command", "list_files"}})["ok"] == true); // what is restored is there
    const int applied = page.last_state["applied"];
    CHECK(applied >= saved);
    CHECK(applied <= saved + 4);
    REQUIRE(page.request({{"id", 2}, {"command", "undo"}})["ok"] == true);
    state_with(page, applied - 1);
  }
}

TEST_CASE("what crashes again and again is given up, and children do not outlive the supervisor") {
  const Temporary_folder folder;
  Studio studio(folder.path(""));
  pid_t child = 0;
  for (int i = 0; i < most_crashes; ++i) {
    child = studio.next().child;
    REQUIRE(kill(child, SIGSEGV) == 0);
  }
  CHECK(studio.wait() == 1);

  {
    Studio second(folder.path("")); // the folder is free again
    child = second.next().child;
  }
  for (int i = 0; i < 200 && is_running(child); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  CHECK(!is_running(child));
}
