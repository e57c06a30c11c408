// SPDX-License-Identifier: GPL-3.0-or-later
// Who is let into the studio's server, and what it does with rude clients.
#include "studio_client.h"
#include "temporary_folder.h"
#include "tiny_surfaces.h"

#include <server/Server.h>

#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>

#include <memory>

using namespace CGAL::Reeb_quadrangulation;
using reebquad::studio::Limits;
using reebquad::studio::Server;

namespace {

std::string torus_file() {
  Result<Encoded_mesh> encoded = encode_mesh(polygon_soup(tiny::torus(24, 12)), Mesh_format::off);
  REQUIRE(encoded);
  return encoded->bytes;
}

} // namespace

TEST_CASE("exactly the right host, origin and cookie together open a socket") {
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
  const std::string other_secret(64, '0');
  const std::vector<std::string> cookies{us.cookie,
                                         us.cookie.substr(0, us.cookie.size() - 1),
                                         us.cookie + "0",
                                         us.cookie.substr(0, us.cookie.find('=') + 1) + other_secret,
                                         "other=1; " + us.cookie,
                                         "session=" + us.cookie.substr(us.cookie.find('=') + 1),
                                         ""};
  int opened = 0;
  for (const std::string& host : hosts)
    for (const std::string& origin : origins)
      for (const std::string& cookie : cookies) {
        CAPTURE(host, origin, cookie);
        Headers headers;
        if (!host.empty()) headers.emplace_back("Host", host);
        if (!origin.empty()) headers.emplace_back("Origin", origin);
        if (!cookie.empty()) headers.emplace_back("Cookie", cookie);
        for (const auto& header : Page_socket::handshake()) headers.push_back(header);
        const Answer answer = ask(us.port, "GET", "/api/socket", headers);
        const bool right = host == us.host && origin == us.origin &&
                           (cookie == us.cookie || cookie == "other=1; " + us.cookie);
        CHECK((answer.status == 101) == right);
        CHECK((right || answer.status == 421 || answer.status == 403 || answer.status == 401 ||
               answer.status == 400));
        CHECK(answer.seconds < 1);
        opened += answer.status == 101;
      }
  CHECK(opened == 2);
}

TEST_CASE("the token is exchanged for a cookie that scripts cannot read, and nothing else is") {
  const Temporary_folder folder;
  const Server server(folder.path(""), 0);
  const Visitor us = enter(server.url());
  const Headers headers{{"Host", us.host}, {"Origin", us.origin}};
  const std::string token = server.url().substr(server.url().find('=') + 1);
  REQUIRE(token.size() == 64); // 256 bits
  const Answer good = ask(us.port, "POST", "/api/enter", headers, token);
  CHECK(good.header("Set-Cookie").find("; HttpOnly; SameSite=Strict") != std::string::npos);
  CHECK(good.header("Set-Cookie").find(token) == std::string::npos);
  for (const std::string& wrong :
       {token.substr(1), token + "0", std::string(64, '0'), std::string("x"), token.substr(0, 63) + "g"}) {
    const Answer bad = ask(us.port, "POST", "/api/enter", headers, wrong);
    CHECK(bad.status == 403);
    CHECK(bad.header("Set-Cookie").empty());
  }
  // Another run has another token, and the cookie of this one does not open it.
  const Server other(folder.path(""), 0);
  CHECK(other.url().substr(other.url().find('=')) != server.url().substr(server.url().find('=')));
}

TEST_CASE("requests without the cookie read and change nothing") {
  const Temporary_folder folder;
  const Server server(folder.path(""), 0);
  const Visitor us = enter(server.url());
  const Headers no_cookie{{"Host", us.host}, {"Origin", us.origin}};
  CHECK(ask(us.port, "POST", "/api/upload?name=a.off", no_cookie, torus_file()).status == 401);
  CHECK(ask(us.port, "GET", "/api/download?what=obj", no_cookie).status == 401);
  CHECK(ask(us.port, "GET", "/api/nothing", no_cookie).status == 401);
  // A form of another page would be sent with the cookie by an old browser, but not with our origin.
  const Headers foreign{{"Host", us.host}, {"Origin", "http://evil.example"}, {"Cookie", us.cookie}};
  CHECK(ask(us.port, "POST", "/api/upload?name=a.off", foreign, torus_file()).status == 403);
  const Headers no_origin{{"Host", us.host}, {"Cookie", us.cookie}};
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
