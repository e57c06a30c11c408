// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the studio's server without sockets: messages, files, the saved session, the worker.
#include "temporary_folder.h"

#include "server/Client.h"
#include "server/Request.h"
#include "server/Worker.h"
#include "session/Folder.h"
#include "session/Store.h"
#include "view/Frame.h"
#include "view/Frame_patch.h"

#include <algorithm>
#include <csignal>
#include <future>
#include <sys/wait.h>
#include <unistd.h>

using namespace reebquad::studio;

namespace {

Json vectors() {
  return Json::parse(contents(std::string(REEBQUAD_TEST_DIR) + "/../studio/vectors.json"));
}

std::string from_hex(const std::string& digits) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
    bytes += char(std::stoi(digits.substr(i, 2), nullptr, 16));
  return bytes;
}

} // namespace

TEST_CASE("frames are encoded as the test vectors of the protocol say") {
  const Json frames = vectors()["frames"];
  REQUIRE(!frames.empty());
  for (const Json& vector : frames) {
    Frame frame(vector["layer"]);
    frame.data = vector["data"];
    for (const Json& array : vector["arrays"]) {
      const std::string type = array["type"];
      if (type == "f32") frame.add(array["name"], array["values"].get<std::vector<float>>());
      if (type == "u32") frame.add(array["name"], array["values"].get<std::vector<std::uint32_t>>());
      if (type == "i32") frame.add(array["name"], array["values"].get<std::vector<std::int32_t>>());
      if (type == "u8") frame.add(array["name"], array["values"].get<std::vector<std::uint8_t>>());
    }
    CHECK(*frame.encode() == from_hex(vector["bytes"]));
  }
}

TEST_CASE("what changed of a layer is said as the test vectors of the protocol say") {
  const Json patches = vectors()["patches"];
  REQUIRE(!patches.empty());
  for (const Json& vector : patches) {
    CAPTURE(vector["about"].get<std::string>());
    const auto patch = frame_patch(from_hex(vector["before"]), from_hex(vector["after"]));
    REQUIRE(patch);
    CHECK(*patch == from_hex(vector["patch"]));
  }
}

TEST_CASE("what changed of a layer is said only where that is shorter") {
  const auto layer = [](std::uint32_t from) {
    Frame frame("field");
    std::vector<float> values;
    for (std::uint32_t i = 0; i < 1000; ++i) values.push_back(float(from + i * i));
    frame.add("value", values);
    return *frame.encode();
  };
  CHECK(!frame_patch(layer(0), layer(1)));
  const auto nothing = frame_patch(layer(1), layer(1));
  REQUIRE(nothing);
  CHECK(nothing->size() < 300);
}

TEST_CASE("requests are taken or refused as the test vectors of the protocol say") {
  const Json requests = vectors()["requests"];
  REQUIRE(!requests.empty());
  for (const Json& vector : requests) {
    const std::string text = vector["text"];
    CAPTURE(text);
    const auto request = parse_request(text);
    CHECK(bool(request) == vector["ok"].get<bool>());
    if (!request) CHECK(request.error().message == vector["message"]);
    CHECK(request_id(text) == vector["id"].get<std::int64_t>());
  }
}

TEST_CASE("a request may be long and deep up to the limits and no further") {
  const auto padded = [](std::size_t size) {
    const std::string head = R"({"id":1,"command":"undo","pad":")", tail = "\"}";
    return head + std::string(size - head.size() - tail.size(), 'x') + tail;
  };
  CHECK(bool(parse_request(padded(longest_request))));
  CHECK(!parse_request(padded(longest_request + 1)));
  const auto nested = [](int depth) {
    return R"({"id":1,"command":"edit","edit":{"a":)" + std::string(std::size_t(depth), '[') +
           std::string(std::size_t(depth), ']') + "}}";
  };
  CHECK(bool(parse_request(nested(13))));
  CHECK(!parse_request(nested(40)));
  CHECK(!parse_request(nested(400000)));
}

TEST_CASE("only files inside the folder have a path") {
  const Temporary_folder outside;
  outside.write("secret.obj", "v 0 0 0\n");
  std::filesystem::create_directories(outside.path("inside/sub"));
  std::ofstream(outside.path("inside/mesh.obj")) << "v 0 0 0\n";
  std::ofstream(outside.path("inside/sub/deep.off")) << "OFF\n";
  std::ofstream(outside.path("inside/.hidden")) << "x";
  std::filesystem::create_symlink(outside.path("secret.obj"), outside.path("inside/link.obj"));
  std::filesystem::create_symlink(outside.path(""), outside.path("inside/up"));
  std::filesystem::create_symlink(outside.path("inside/mesh.obj"), outside.path("inside/good.obj"));
  std::filesystem::create_symlink("/nowhere/at/all", outside.path("inside/dangling.obj"));
  const Folder folder(outside.path("inside"));

  for (const char* name :
       {"mesh.obj", "sub/deep.off", "good.obj", "new.obj", "sub/new file.obj", "a..b.obj", "ü.obj"}) {
    CAPTURE(name);
    REQUIRE(folder.resolve(name));
    CHECK(folder.resolve(name)->rfind(folder.path().string() + "/", 0) == 0);
  }
  const std::string secret = outside.path("secret.obj");
  std::vector<std::string> forbidden{"",
                                     ".",
                                     "..",
                                     "/",
                                     "//",
                                     "\\",
                                     "...",
                                     "....",
                                     "./mesh.obj",
                                     "../secret.obj",
                                     "../../etc/passwd",
                                     "/etc/passwd",
                                     "//etc/passwd",
                                     "sub/../mesh.obj",
                                     "sub/../../secret.obj",
                                     "sub/./deep.off",
                                     "sub//deep.off",
                                     "sub/",
                                     "mesh.obj/",
                                     "..\\secret.obj",
                                     "sub\\..\\..\\secret.obj",
                                     "C:\\secret.obj",
                                     ".hidden",
                                     "sub/.hidden",
                                     ".reebquad/session.json",
                                     "link.obj",
                                     "up/secret.obj",
                                     "up/inside/../secret.obj",
                                     "dangling.obj",
                                     "missing/new.obj",
                                     "missing/../mesh.obj",
                                     "..;/secret.obj",
                                     "../secret.obj ",
                                     " ../secret.obj",
                                     "sub/..",
                                     "sub/../..",
                                     ".../../secret.obj",
                                     "..\t/secret.obj",
                                     "mesh.obj\n",
                                     "\x7f",
                                     "..\r\n/secret.obj",
                                     "mesh.obj/../../secret.obj",
                                     "~/../secret.obj",
                                     "file:///etc/passwd",
                                     secret,
                                     std::string("mesh.obj\0.obj", 13),
                                     std::string(5000, 'a'),
                                     "..%2fsecret.obj/..",
                                     "%2e%2e/%2e%2e/../x",
                                     "/proc/self/environ",
                                     "../../../../../../../../etc/shadow",
                                     "sub/../sub/../../secret.obj"};
  for (const char* up : {"../", "..//", "../.", "../..", "..\\..", "/..", "/../", "sub/../../"})
    forbidden.push_back(std::string(up) + "secret.obj");
  CHECK(forbidden.size() >= 60);
  for (const std::string& name : forbidden) {
    CAPTURE(name);
    CHECK(!folder.resolve(name));
  }
  for (const Listed_file& file : folder.meshes()) CHECK(file.name != "link.obj");
  CHECK(folder.meshes().size() == 3);
}

TEST_CASE("a session is never lost, whenever the process is killed") {
  constexpr int kills = 500;
  const Temporary_folder place;
  const Folder folder(place.path(""));
  const Store store(folder);
  const std::string mesh(50000, 'm');
  int last = 0;
  for (int round = 0; round < kills; ++round) {
    int told[2];
    REQUIRE(pipe(told) == 0);
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      for (int n = last + 1;; ++n) {
        Saved_session session;
        session.name = "mesh.obj";
        const std::string bytes = mesh + std::to_string(n / 3 % 5); // another mesh every third time
        session.bytes = bytes.size();
        session.digest = digest(bytes);
        Saved_part part;
        for (int i = 0; i < n % 50; ++i) part.edits.push_back({{"edit", "set_target"}, {"quads", n}});
        part.edits.push_back(n);
        part.applied = int(part.edits.size());
        session.parts = {part};
        if (!store.save_upload(session, bytes) || !store.save(session)) _exit(1);
        if (write(told[1], &n, sizeof n) != sizeof n) _exit(1);
      }
    }
    close(told[1]);
    // Some time after its first save, at another moment in each round.
    int saved = last;
    REQUIRE(read(told[0], &saved, sizeof saved) == sizeof saved);
    usleep(useconds_t(round * 37 % 2500));
    kill(child, SIGKILL);
    while (read(told[0], &last, sizeof last) == sizeof last) saved = last;
    close(told[0]);
    int status = 0;
    waitpid(child, &status, 0);
    REQUIRE(WIFSIGNALED(status));

    last = 0;
    for (const Saved_session& session : store.sessions()) {
      last = std::max(last, session.parts.at(0).edits.back().get<int>());
      CHECK(bool(store.load_mesh(session)));
    }
    CHECK(last >= saved);
    CHECK(last <= saved + 1);
    CHECK(store.unreadable().empty());
  }
}

namespace {

Saved_session session_of(const std::string& name, const std::string& bytes, int edits = 1) {
  Saved_session session;
  session.name = session.file = name;
  session.bytes = bytes.size();
  session.digest = digest(bytes);
  Saved_part part;
  for (int i = 0; i < edits; ++i) part.edits.push_back({{"edit", "suggest"}});
  session.parts = {part};
  return session;
}

} // namespace

TEST_CASE("a damaged or foreign session file is as none, stays as it is, and a changed mesh is told") {
  const Temporary_folder place;
  const Store store((Folder(place.path(""))));
  CHECK(!store.load());
  place.write("mesh.obj", "v 0 0 0\n");
  const Saved_session session = session_of("mesh.obj", "v 0 0 0\n");
  REQUIRE(store.save(session));
  REQUIRE(store.load());
  CHECK(bool(store.load_mesh(*store.load())));
  place.write("mesh.obj", "v 0 0 1\n");
  CHECK(!store.load_mesh(*store.load()));
  const std::string name = ".reebquad/session-" + session.digest + ".json", good = contents(place.path(name));
  const std::string head = R"({"name":"a","file":"","bytes":1,"digest":"0123456789abcdef",)";
  for (
      const std::string& bad :
      {std::string(), std::string("{}"), std::string("[1,2"), good.substr(0, good.size() / 2),
       std::string(R"({"version":2,"name":1,"file":"","bytes":1,"digest":"","component":1,"parts":[]})"),
       std::string(
           R"({"version":2,"name":"a","file":"","bytes":1,"digest":"../../../etc/pwd","component":1,"parts":[]})"),
       head + R"("version":1,"component":1,"parts":[]})", head + R"("version":3,"component":1,"parts":[]})",
       head + R"("version":2,"component":0,"parts":[]})",
       head + R"("version":2,"component":1,"parts":[{"component":1,"edits":[],"applied":7}]})",
       head + R"("version":2,"component":1,"parts":[{"component":1,"applied":0,"edits":[)" +
           std::string(1000000, '[') + std::string(1000000, ']') + "]}]}"}) {
    place.write(name, bad);
    CHECK(!store.load());
    CHECK(store.unreadable() == std::vector<std::string>{name});
    const CGAL::Reeb_quadrangulation::Result<std::string> kept = store.set_aside(session.digest);
    REQUIRE(kept);
    CHECK(contents(place.path(*kept)) == bad);
    REQUIRE(store.save(session));
    CHECK(contents(place.path(*kept)) == bad);
    CHECK(store.load());
  }
  // A session that names a file outside is not followed.
  place.write(name, R"({"version":2,"name":"a","file":"../../etc/passwd","bytes":1,)"
                    R"("digest":"0123456789abcdef","component":1,"parts":[]})");
  REQUIRE(store.load());
  CHECK(!store.load_mesh(*store.load()));
}

TEST_CASE("each mesh has a session of its own, also that of the time when there was only one") {
  const Temporary_folder place;
  const Store store((Folder(place.path(""))));
  const Saved_session a = session_of("a.off", "OFF a", 3), b = session_of("b.off", "OFF b", 2);
  REQUIRE(store.save(a));
  std::filesystem::rename(place.path(".reebquad/session-" + a.digest + ".json"),
                          place.path(".reebquad/session.json"));
  REQUIRE(store.save(b));
  REQUIRE(store.sessions().size() == 2);
  REQUIRE(store.load(a.digest));
  CHECK(store.load(a.digest)->number_of_edits() == 3);
  CHECK(store.load(b.digest)->number_of_edits() == 2);
  REQUIRE(store.save(a)); // under its new name, and only there
  CHECK(!std::filesystem::exists(place.path(".reebquad/session.json")));
  CHECK(store.sessions().size() == 2);
  store.forget(a.digest);
  REQUIRE(store.sessions().size() == 1);
  CHECK(store.load()->name == "b.off");
}

TEST_CASE("links and folders of others do not lead the store out of the folder") {
  const Temporary_folder place, outside;
  const std::string secret = outside.write("bashrc", "secret");
  outside.write("mesh-0123456789abcdef", "kept");
  const Saved_session session = session_of("a.off", "OFF a");
  const Store store((Folder(place.path(""))));
  SECTION("the folder is a link") {
    std::filesystem::permissions(outside.path(""), std::filesystem::perms(0755));
    std::filesystem::create_symlink(outside.path(""), place.path(".reebquad"));
    CHECK(!store.save(session));
    CHECK(!store.save_upload(session, "bytes"));
    store.forget("0123456789abcdef");
    CHECK(!store.load());
    CHECK(contents(outside.path("mesh-0123456789abcdef")) == "kept");
    CHECK(std::filesystem::status(outside.path("")).permissions() == std::filesystem::perms(0755));
    CHECK(std::distance(std::filesystem::directory_iterator(outside.path("")), {}) == 2);
  }
  SECTION("a file in it is a link") {
    std::filesystem::create_directory(place.path(".reebquad"));
    const std::string name = place.path(".reebquad/session-" + session.digest + ".json");
    std::filesystem::create_symlink(secret, name);
    std::filesystem::create_symlink(secret, place.path(".reebquad/mesh-" + session.digest));
    CHECK(!store.load());
    REQUIRE(store.save(session));
    REQUIRE(store.save_upload(session, "bytes"));
    CHECK(std::filesystem::is_regular_file(std::filesystem::symlink_status(name)));
    CHECK(store.load());
  }
  CHECK(contents(secret) == "secret");
}

TEST_CASE("work is cancelled within a quarter of a second, and by the edit that replaces it") {
  using Clock = std::chrono::steady_clock;
  std::promise<void> begun;
  std::promise<Clock::time_point> stopped;
  Worker worker([](const std::string&, double) {});
  const auto until_cancelled = [](Worker::Observer& observer) {
    while (!observer.cancelled()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  const auto never = [](const std::string&) { FAIL("the job threw"); };
  worker.push(
      [&](Worker::Observer& observer) {
        begun.set_value();
        until_cancelled(observer);
        stopped.set_value(Clock::now());
      },
      never);
  begun.get_future().wait();
  const Clock::time_point asked = Clock::now();
  worker.cancel();
  CHECK(stopped.get_future().get() - asked < std::chrono::milliseconds(250));

  std::promise<bool> was_cancelled, is_fresh;
  worker.push(
      [&](Worker::Observer& observer) {
        until_cancelled(observer);
        was_cancelled.set_value(true);
      },
      never, true);
  worker.push([&](Worker::Observer& observer) { is_fresh.set_value(!observer.cancelled()); }, never);
  CHECK(was_cancelled.get_future().get());
  CHECK(is_fresh.get_future().get());

  // A job that only looks does not cancel what comes before it.
  std::promise<void> running, looked_for;
  std::promise<bool> went_on;
  worker.push(
      [&](Worker::Observer& observer) {
        running.set_value();
        looked_for.get_future().wait();
        went_on.set_value(!observer.cancelled());
      },
      never, true);
  running.get_future().wait();
  worker.push([](Worker::Observer&) {}, never, false, false);
  looked_for.set_value();
  CHECK(went_on.get_future().get());
}

TEST_CASE("of a drag each edit is carried out, until something else comes") {
  Worker worker([](const std::string&, double) {});
  const auto never = [](const std::string&) { FAIL("the job threw"); };
  std::promise<void> begun, pushed;
  std::promise<bool> first, second, third;
  worker.push(
      [&](Worker::Observer& observer) {
        begun.set_value();
        pushed.get_future().wait();
        first.set_value(observer.cancelled());
      },
      never, true, true, 7);
  begun.get_future().wait();
  worker.push([&](Worker::Observer& observer) { second.set_value(observer.cancelled()); }, never, true, true,
              7);
  SECTION("one of the same drag") {
    pushed.set_value();
    CHECK(!first.get_future().get());
    CHECK(!second.get_future().get());
  }
  SECTION("another drag") {
    worker.push([&](Worker::Observer& observer) { third.set_value(observer.cancelled()); }, never, true, true,
                8);
    pushed.set_value();
    CHECK(first.get_future().get());
    CHECK(second.get_future().get());
    CHECK(!third.get_future().get());
  }
}

TEST_CASE("a job that throws does not end the worker") {
  Worker worker([](const std::string&, double) {});
  std::promise<std::string> said;
  std::promise<void> went_on;
  worker.push([](Worker::Observer&) { throw std::runtime_error("broken"); },
              [&](const std::string& what) { said.set_value(what); });
  worker.push([&](Worker::Observer&) { went_on.set_value(); }, [](const std::string&) {});
  CHECK(said.get_future().get() == "broken");
  went_on.get_future().wait();
}

TEST_CASE("a slow page gets the newest of the messages that replace each other") {
  const auto bytes = [](const std::string& text) { return std::make_shared<const std::string>(text); };
  Outbox outbox;
  for (int i = 0; i < 100000; ++i) REQUIRE(outbox.push({"progress", bytes(std::to_string(i)), false}));
  REQUIRE(outbox.push({"", bytes("reply"), false}));
  REQUIRE(outbox.push({"progress", bytes("last"), false}));
  REQUIRE(outbox.size() == 2);
  CHECK(*outbox.pop().bytes == "reply");
  CHECK(*outbox.pop().bytes == "last");
  // Changes of a layer that it has not been sent are of no use to it.
  REQUIRE(outbox.push({"layer", bytes("first"), true}));
  CHECK(*outbox.pop().bytes == "first");
  REQUIRE(outbox.push({"layer", bytes("change"), true, bytes("second")}));
  REQUIRE(outbox.push({"layer", bytes("next change"), true, bytes("third")}));
  CHECK(*outbox.pop().bytes == "third");
  REQUIRE(outbox.push({"layer", bytes("last change"), true, bytes("fourth")}));
  CHECK(*outbox.pop().bytes == "last change");
  int taken = 0;
  while (outbox.push({"", bytes("x"), false})) ++taken;
  CHECK(taken == 1000);
}
