// SPDX-License-Identifier: GPL-3.0-or-later
// Who is let into the studio's server, and what it does with rude clients.
#include "studio_client.h"
#include "temporary_folder.h"
#include "tiny_surfaces.h"

#include "server/Server.h"

#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>

#include <memory>
#include <thread>

using namespace CGAL::Reeb_quadrangulation;
using reebquad::studio::Limits;
using reebquad::studio::Server;

TEST_CASE("exactly the right host, origin and secret together open a socket") {
  const Temporary_folder folder;
  const Server server(folder.path(""), 0);
  const Visitor us = enter(server.url());
  const std::string port = std::to_string(us.port);
  const std::vector<std::string> hosts{us.host,
                                       "localhost:" + port,
                                       "127.0.0.1",
                                       "127.0.0.1:1",
                                       "127.0.0.1:" + port + "0",
                                       "[::1]:" + port,
                                       "evil.example:" + port,
                                       us.host + ".evil.example",
                                       ""};
  const std::vector<std::string> origins{us.origin,
                                         "http://localhost:" + port,
                                         "https://" + us.host,
                                         "http://127.0.0.1",
                                         us.origin + "/",
                                         us.origin + ".evil.example",
                                         "http://evil.example",
                                         "null",
                                         ""};
  const std::vector<std::string> protocols{"reebquad, " + us.secret,
                                           "reebquad," + us.secret,
                                           "reebquad, " + us.secret.substr(1),
                                           "reebquad, " + us.secret + "0",
                                           "reebquad, " + std::string(64, '0'),
                                           us.secret,
                                           "other, " + us.secret,
                                           "reebquad",
                                           ""};
  int opened = 0;
  for (const std::string& host : hosts)
    for (const std::string& origin : origins)
      for (const std::string& protocol : protocols) {
        CAPTURE(host, origin, protocol);
        Headers headers;
        if (!host.empty()) headers.emplace_back("Host", host);
        if (!origin.empty()) headers.emplace_back("Origin", origin);
        for (const auto& header : Page_socket::handshake(us.secret))
          if (header.first != "Sec-WebSocket-Protocol") headers.push_back(header);
        if (!protocol.empty()) headers.emplace_back("Sec-WebSocket-Protocol", protocol);
        const Answer answer = ask(us.port, "GET", "/api/socket", headers);
        const bool right =
            host == us.host && origin == us.origin && (protocol == protocols[0] || protocol == protocols[1]);
        CHECK((answer.status == 101) == right);
        if (right) CHECK(answer.header("Sec-WebSocket-Protocol") == "reebquad");
        CHECK((right || answer.status == 421 || answer.status == 403 || answer.status == 401 ||
               answer.status == 400));
        CHECK(answer.seconds < 1);
        opened += answer.status == 101;
      }
  CHECK(opened == 2);
}

TEST_CASE("the token opens once and not for long, and what it opens is no cookie") {
  const Temporary_folder folder, elsewhere;
  Limits limits;
  limits.token_life = std::chrono::milliseconds(1500);
  Server server(folder.path(""), 0, limits);
  const std::string origin = server.url().substr(0, server.url().find("/#"));
  const Headers headers{{"Host", origin.substr(7)}, {"Origin", origin}};
  const auto token = [&] { return server.url().substr(server.url().find('=') + 1); };
  REQUIRE(token().size() == 64); // 256 bits
  for (const std::string& wrong : {token().substr(1), token() + "0", std::string(64, '0'), std::string("x"),
                                   token().substr(0, 63) + "g"}) {
    const Answer bad = ask(server.port(), "POST", "/api/enter", headers, wrong);
    CHECK(bad.status == 403);
    CHECK(bad.body.find("secret") == std::string::npos);
  }
  CHECK(server.awaits_visitor());
  const Answer good = ask(server.port(), "POST", "/api/enter", headers, token());
  REQUIRE(good.status == 200);
  CHECK(good.header("Set-Cookie").empty());
  CHECK(good.body.find(token()) == std::string::npos);
  CHECK(!server.awaits_visitor());
  CHECK(ask(server.port(), "POST", "/api/enter", headers, token()).status == 403);

  server.renew_token();
  CHECK(server.awaits_visitor());
  std::this_thread::sleep_for(std::chrono::milliseconds(1700));
  CHECK(!server.awaits_visitor());
  CHECK(ask(server.port(), "POST", "/api/enter", headers, token()).status == 403);
  server.renew_token();
  CHECK(ask(server.port(), "POST", "/api/enter", headers, token()).status == 200);

  // What a browser would send to any port of this machine opens nothing.
  Headers cookie = headers;
  cookie.emplace_back("Cookie", "reebquad=" + nlohmann::json::parse(good.body)["secret"].get<std::string>());
  CHECK(ask(server.port(), "GET", "/api/download?what=obj", cookie).status == 401);
  // Another run has another token and another secret.
  const Server other(elsewhere.path(""), 0);
  CHECK(other.url().substr(other.url().find('=')) != server.url().substr(server.url().find('=')));
  CHECK(enter(other.url()).secret != nlohmann::json::parse(good.body)["secret"]);
}

TEST_CASE("requests without the secret read and change nothing") {
  const Temporary_folder folder;
  const Server server(folder.path(""), 0);
  const Visitor us = enter(server.url());
  const Headers no_secret{{"Host", us.host}, {"Origin", us.origin}};
  CHECK(ask(us.port, "POST", "/api/upload?name=a.off", no_secret, torus_file()).status == 401);
  CHECK(ask(us.port, "GET", "/api/download?what=obj", no_secret).status == 401);
  CHECK(ask(us.port, "GET", "/api/nothing", no_secret).status == 401);
  // Not even with the secret does another origin get in.
  const Headers foreign{
      {"Host", us.host}, {"Origin", "http://evil.example"}, {"Authorization", "Bearer " + us.secret}};
  CHECK(ask(us.port, "POST", "/api/upload?name=a.off", foreign, torus_file()).status == 403);
  const Headers no_origin{{"Host", us.host}, {"Authorization", "Bearer " + us.secret}};
  CHECK(ask(us.port, "POST", "/api/upload?name=a.off", no_origin, torus_file()).status == 403);
  CHECK(ask(us.port, "POST", "/api/upload?name=a.off", us.headers(), torus_file()).status == 200);
}

TEST_CASE("every answer carries the strict policy") {
  const Temporary_folder folder;
  const Server server(folder.path(""), 0);
  const Visitor us = enter(server.url());
  for (const char* target : {"/", "/missing", "/api/download?what=obj"}) {
    const Answer answer = ask(us.port, "GET", target, us.headers());
    const std::string policy = answer.header("Content-Security-Policy");
    CHECK(policy.find("default-src 'none'; script-src 'self'; style-src 'self'") == 0);
    CHECK(policy.find("unsafe") == std::string::npos);
    CHECK(answer.header("X-Content-Type-Options") == "nosniff");
    CHECK(answer.header("Referrer-Policy") == "no-referrer");
    CHECK(answer.header("Access-Control-Allow-Origin").empty());
  }
}

TEST_CASE("paths that climb lead nowhere, and the server goes on") {
  const Temporary_folder folder;
  folder.write("secret.txt", "secret");
  std::filesystem::create_directories(folder.path("inside"));
  const Server server(folder.path("inside"), 0);
  const Visitor us = enter(server.url());
  std::vector<std::string> targets;
  for (const char* up : {"..", "%2e%2e", "%2E%2E", ".%2e", "%2e.", "..%00", "%252e%252e", "..%c0%af",
                         "%c0%ae%c0%ae", "..;", "....", "...", ".. ", "..%20", "..%09"})
    for (const char* file : {"/secret.txt", "%2fsecret.txt", "\\secret.txt", "/../../../etc/passwd"})
      targets.push_back(std::string("/") + up + file);
  for (const char* target :
       {"//etc/passwd", "/etc/passwd", "/./secret.txt", "/assets/../../secret.txt",
        "/index.html/../../secret.txt", "/?/../secret.txt", "/api/../secret.txt",
        "/api/download/../../secret.txt", "http://evil.example/secret.txt", "*", "secret.txt"})
    targets.emplace_back(target);
  REQUIRE(targets.size() >= 60);
  for (const std::string& target : targets) {
    CAPTURE(target);
    const Answer answer = ask(us.port, "GET", target, us.headers());
    CHECK((answer.status == 404 || answer.status == 400 || answer.status == 401));
    CHECK(answer.body.find("secret\"") == std::string::npos);
    CHECK(answer.body != "secret");
    CHECK(answer.seconds < 1);
  }
  // The same through the requests that name files.
  Page_socket page(us);
  REQUIRE(page.opening.status == 101);
  int id = 0;
  for (const char* name : {"../secret.txt", "/etc/passwd", "..\\secret.txt", "./x", ".reebquad/session.json",
                           "a/../../secret.txt"})
    for (const char* command : {"open_file", "export", "save_recipe"}) {
      CAPTURE(name, command);
      CHECK(page.request({{"id", ++id}, {"command", command}, {"name", name}})["ok"] == false);
    }
  CHECK(contents(folder.path("secret.txt")) == "secret");
}

TEST_CASE("malformed and oversized requests are refused") {
  const Temporary_folder folder;
  Limits limits;
  limits.upload_bytes = 100000;
  const Server server(folder.path(""), 0, limits);
  const Visitor us = enter(server.url());
  const std::string host =
      "Host: " + us.host + "\r\nOrigin: " + us.origin + "\r\nAuthorization: Bearer " + us.secret + "\r\n";
  const std::vector<std::pair<std::string, int>> table{
      {"nonsense\r\n\r\n", 400},
      {"GET / HTTP/9.9\r\n" + host + "\r\n", 400},
      {"GET /\r\n\r\n", 400},
      {std::string("\0\1\2\3\r\n\r\n", 8), 400},
      {"GET / HTTP/1.1\r\n" + host + "X: " + std::string(20000, 'x') + "\r\n\r\n", 431},
      {"GET /" + std::string(20000, 'x') + " HTTP/1.1\r\n" + host + "\r\n", 431},
      {"GET / HTTP/1.1\r\nHost: " + us.host + "\r\n" + host + "\r\n", 421},
      {"GET / HTTP/1.1\r\n" + host + "Origin: " + us.origin + "\r\n\r\n", 403},
      {"DELETE / HTTP/1.1\r\n" + host + "\r\n", 405},
      {"POST /api/upload HTTP/1.1\r\n" + host + "Content-Length: 999999999999\r\n\r\n", 413},
      {"POST /api/upload HTTP/1.1\r\n" + host + "Content-Length: -1\r\n\r\n", 400},
      {"POST /api/upload HTTP/1.1\r\n" + host + "Content-Length: 5\r\nContent-Length: 6\r\n\r\nhello", 400},
      {"POST /api/upload HTTP/1.1\r\n" + host +
           "Content-Length: 5\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n",
       400},
      {"POST /api/upload HTTP/1.1\r\n" + host + "Transfer-Encoding: chunked\r\n\r\n30D41\r\n" +
           std::string(200001, 'x') + "\r\n0\r\n\r\n",
       413},
      {"POST /api/upload HTTP/1.1\r\n" + host + "Content-Length: 5\r\n\r\nhello", 422},
      {"POST /api/enter HTTP/1.1\r\n" + host + "Content-Length: 5000\r\n\r\n", 413},
      {"GET /api/socket HTTP/1.1\r\n" + host + "\r\n", 401}, // the secret stands elsewhere there
      {"GET /api/socket HTTP/1.1\r\n" + host + "Sec-WebSocket-Protocol: reebquad, " + us.secret + "\r\n\r\n",
       426},
  };
  for (const auto& [text, status] : table) {
    CAPTURE(text.substr(0, 300));
    Raw_socket socket(us.port);
    socket.send(text);
    CHECK(read_answer(socket).status == status);
  }
  CHECK(ask(us.port, "POST", "/api/upload?name=t.off", us.headers(), torus_file()).status == 200);
}

TEST_CASE("messages that are not of the protocol are answered or end the connection, never the server") {
  const Temporary_folder folder;
  const Server server(folder.path(""), 0);
  const Visitor us = enter(server.url());
  Page_socket page(us);
  for (const char* text : {"", "x", "{}", "[]", "{\"id\":1}", R"({"id":5,"command":"nothing"})"}) {
    page.send(text);
    CHECK(page.wait_for("reply")["ok"] == false);
  }
  const auto ends = [&](const std::string& bytes, int opcode) {
    Page_socket rude(us);
    REQUIRE(rude.opening.status == 101);
    rude.send_raw(bytes);
    for (;;) {
      const Page_socket::Message message = rude.receive(5);
      if (message.opcode < 0 || message.opcode == 8) return message.opcode == -1 || message.opcode == opcode;
    }
  };
  CHECK(ends(Page_socket::frame("binary", 2), 8));
  CHECK(ends(Page_socket::frame(std::string(2000000, 'x')), 8));
  CHECK(ends(Page_socket::frame("", 1, std::uint64_t(1) << 62), 8)); // only announced
  CHECK(ends(Page_socket::frame("\xff\xfe"), 8));                    // not UTF-8
  CHECK(ends(std::string("\x81\x02hi"), 8));                         // not masked
  CHECK(ends(std::string("\xf1\x80\0\0\0\0", 6), 8));                // reserved bits
  CHECK(ends(std::string("\x83\x80\0\0\0\0", 6), 8));                // unknown opcode
  CHECK(ends(Page_socket::frame(std::string(200, 'p'), 9), 8));      // a ping that is too long
  CHECK(page.request({{"id", 1}, {"command", "list_files"}})["ok"] == true);
}

TEST_CASE("slow clients hold up nobody and are given up") {
  const Temporary_folder folder;
  Limits limits;
  limits.header_time = std::chrono::milliseconds(600);
  limits.quiet_time = std::chrono::milliseconds(600);
  limits.socket_idle_time = std::chrono::milliseconds(900);
  const Server server(folder.path(""), 0, limits);
  const Visitor us = enter(server.url());
  std::vector<std::unique_ptr<Raw_socket>> slow;
  for (int i = 0; i < 60; ++i) {
    slow.push_back(std::make_unique<Raw_socket>(us.port));
    if (i % 3 == 0) slow.back()->send("GET / HT");
    if (i % 3 == 1) {
      Headers headers = us.headers();
      headers.emplace_back("Content-Length", "1000");
      slow.back()->send(request_text("POST", "/api/upload?name=a.off", headers) + "OFF");
    }
  }
  Page_socket silent(us); // takes pings but never answers
  const Answer quick = ask(us.port, "GET", "/missing", us.headers());
  CHECK(quick.status == 404);
  CHECK(quick.seconds < 1);
  for (const auto& socket : slow) {
    while (socket->receive(5)) {
    }
    CHECK(!socket->timed_out); // the server closed it
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(2500));
  bool ended = false;
  for (int i = 0; i < 20 && !ended; ++i) {
    const Page_socket::Message message = silent.receive_silently(2);
    ended = message.opcode == -1 || message.opcode == 8;
  }
  CHECK(ended);
}

TEST_CASE("32 pages see the same session") {
  const Temporary_folder folder;
  const Server server(folder.path(""), 0);
  const Visitor us = enter(server.url());
  std::vector<std::unique_ptr<Page_socket>> pages;
  for (int i = 0; i < 32; ++i) {
    pages.push_back(std::make_unique<Page_socket>(us));
    REQUIRE(pages.back()->opening.status == 101);
    CHECK(pages.back()->wait_for("event", "hello")["version"] == 2);
  }
  REQUIRE(ask(us.port, "POST", "/api/upload?name=t.off", us.headers(), torus_file()).status == 200);
  REQUIRE(pages[7]->request({{"id", 1}, {"command", "edit"}, {"edit", {{"edit", "suggest"}}}})["ok"] == true);
  for (const auto& page : pages) {
    nlohmann::json state = page->last_state;
    while (!state.contains("certificate")) state = page->wait_for("event", "state");
    CHECK(state["certificate"]["passed"] == true);
    CHECK(state["statistics"]["quads"] > 0);
    CHECK(page->binary_messages >= 7);
  }
  const Answer quads = ask(us.port, "GET", "/api/download?what=obj", us.headers());
  CHECK(quads.status == 200);
  CHECK(quads.body.find("\nf ") != std::string::npos);
}

TEST_CASE("the next run of the program offers the session, and brings it back with the same quads") {
  const Temporary_folder folder;
  std::string before;
  {
    const Server server(folder.path(""), 0);
    const Visitor us = enter(server.url());
    Page_socket page(us);
    CHECK(!page.wait_for("event", "state").contains("last_session"));
    REQUIRE(ask(us.port, "POST", "/api/upload?name=t.off", us.headers(), torus_file()).status == 200);
    REQUIRE(page.request({{"id", 1}, {"command", "edit"}, {"edit", {{"edit", "suggest"}}}})["ok"] == true);
    REQUIRE(page.request(
                {{"id", 2}, {"command", "edit"}, {"edit", {{"edit", "set_target"}, {"quads", 700}}}})["ok"] ==
            true);
    before = ask(us.port, "GET", "/api/download?what=obj", us.headers()).body;
    REQUIRE(page.request({{"id", 3}, {"command", "edit"}, {"edit", {{"edit", "no_such_edit"}}}})["ok"] ==
            false);
    CHECK(ask(us.port, "GET", "/api/download?what=obj", us.headers()).body == before);
    REQUIRE(page.request({{"id", 4}, {"command", "undo"}})["ok"] == true);
    REQUIRE(page.request({{"id", 5}, {"command", "undo"}})["ok"] == true);
    CHECK(page.request({{"id", 6}, {"command", "undo"}})["ok"] == false);
    REQUIRE(page.request({{"id", 7}, {"command", "redo"}})["ok"] == true);
    REQUIRE(page.request({{"id", 8}, {"command", "go_to"}, {"step", 2}})["ok"] == true);
  }
  const Server server(folder.path(""), 0);
  const Visitor us = enter(server.url());
  Page_socket page(us);
  CHECK(page.wait_for("event", "state")["last_session"]["edits"] == 2);
  REQUIRE(page.request({{"id", 1}, {"command", "restore"}})["ok"] == true);
  CHECK(ask(us.port, "GET", "/api/download?what=obj", us.headers()).body == before);
}

TEST_CASE("strangers who take all connections do not shut the user out") {
  const Temporary_folder folder;
  Limits limits;
  limits.connections = 8;
  const Server server(folder.path(""), 0, limits);
  const Visitor us = enter(server.url());
  Page_socket page(us);
  std::vector<std::unique_ptr<Raw_socket>> strangers;
  for (int i = 0; i < 40; ++i) {
    strangers.push_back(std::make_unique<Raw_socket>(us.port));
    if (i % 2 == 0)
      strangers.back()->send("POST /api/enter HTTP/1.1\r\nHost: " + us.host + "\r\nOrigin: " + us.origin +
                             "\r\nContent-Length: 64\r\n\r\n0");
  }
  CHECK(page.request({{"id", 1}, {"command", "list_files"}})["ok"] == true);
  CHECK(ask(us.port, "POST", "/api/upload?name=t.off", us.headers(), torus_file()).status == 200);
  Page_socket second(us);
  CHECK(second.opening.status == 101);
}

TEST_CASE("two studios in one folder are told") {
  const Temporary_folder folder;
  const auto first = std::make_unique<Server>(folder.path(""), 0);
  CHECK_THROWS_WITH(Server(folder.path(""), 0), Catch::Contains("another studio works in this folder"));
}

TEST_CASE("each mesh has its session, opening it brings that back, and no file is written over unasked") {
  const Temporary_folder folder;
  folder.write("a.off", torus_file());
  folder.write("b.off", torus_file() + "# another\n");
  std::string quads;
  {
    const Server server(folder.path(""), 0);
    const Visitor us = enter(server.url());
    Page_socket page(us);
    REQUIRE(page.request({{"id", 1}, {"command", "open_file"}, {"name", "a.off"}})["ok"] == true);
    REQUIRE(page.request({{"id", 2}, {"command", "edit"}, {"edit", {{"edit", "suggest"}}}})["ok"] == true);
    REQUIRE(page.request(
                {{"id", 3}, {"command", "edit"}, {"edit", {{"edit", "set_target"}, {"quads", 500}}}})["ok"] ==
            true);
    for (const char* command : {"export", "save_recipe"})
      for (const bool replace : {false, true})
        CHECK(page.request(
                  {{"id", 4}, {"command", command}, {"name", "a.off"}, {"replace", replace}})["ok"] == false);
    REQUIRE(page.request({{"id", 5}, {"command", "export"}, {"name", "q.obj"}})["ok"] == true);
    quads = contents(folder.path("q.obj"));
    CHECK(page.request({{"id", 6}, {"command", "export"}, {"name", "q.obj"}})["ok"] == false);
    CHECK(page.request({{"id", 7}, {"command", "export"}, {"name", "q.obj"}, {"replace", true}})["ok"] ==
          true);
    REQUIRE(page.request({{"id", 8}, {"command", "open_file"}, {"name", "b.off"}})["ok"] == true);
    REQUIRE(page.request({{"id", 9}, {"command", "edit"}, {"edit", {{"edit", "suggest"}}}})["ok"] == true);
  }
  CHECK(contents(folder.path("a.off")) == torus_file());
  const Server server(folder.path(""), 0);
  const Visitor us = enter(server.url());
  Page_socket page(us);
  const nlohmann::json state = page.wait_for("event", "state");
  REQUIRE(state["sessions"].size() == 2);
  CHECK(state["sessions"][0]["name"] == "b.off");
  CHECK(state["last_session"]["name"] == "b.off");
  REQUIRE(page.request({{"id", 1}, {"command", "open_file"}, {"name", "a.off"}})["ok"] == true);
  CHECK(page.last_state["applied"] == 2);
  REQUIRE(page.request({{"id", 2}, {"command", "export"}, {"name", "again.obj"}})["ok"] == true);
  CHECK(contents(folder.path("again.obj")) == quads);
}
