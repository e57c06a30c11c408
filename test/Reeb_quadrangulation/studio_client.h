// SPDX-License-Identifier: GPL-3.0-or-later
// A client of the studio's server that can also be rude: raw sockets, with the handshake and the frames of a
// WebSocket (RFC 6455) written out.
#ifndef REEBQUAD_TEST_STUDIO_CLIENT_H
#define REEBQUAD_TEST_STUDIO_CLIENT_H

#include "tiny_surfaces.h"

#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <arpa/inet.h>
#include <chrono>
#include <cstdint>
#include <netinet/in.h>
#include <poll.h>
#include <string>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>
#include <vector>

/// A connection to a port of this machine.
class Raw_socket {
public:
  explicit Raw_socket(unsigned short port) : m_socket(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    REQUIRE(connect(m_socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
  }
  ~Raw_socket() { close(m_socket); }
  Raw_socket(const Raw_socket&) = delete;
  Raw_socket& operator=(const Raw_socket&) = delete;

  /// False if the other side has closed.
  bool send(const std::string& bytes) {
    std::size_t sent = 0;
    while (sent < bytes.size()) {
      const ssize_t n = ::send(m_socket, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
      if (n <= 0) return false;
      sent += std::size_t(n);
    }
    return true;
  }

  /// Waits for bytes and appends them to `received`; false at the end of the connection or after `seconds`.
  bool receive(double seconds) {
    pollfd waiting{m_socket, POLLIN, 0};
    if (poll(&waiting, 1, int(1000 * seconds)) <= 0) {
      timed_out = true;
      return false;
    }
    char bytes[65536];
    const ssize_t n = recv(m_socket, bytes, sizeof bytes, 0);
    if (n <= 0) return false;
    received.append(bytes, std::size_t(n));
    return true;
  }

  std::string received;
  bool timed_out = false;

private:
  int m_socket;
};

using Headers = std::vector<std::pair<std::string, std::string>>;

struct Answer {
  int status = 0; ///< 0: the connection ended without an answer
  std::string head, body;
  double seconds = 0;

  std::string header(const std::string& name) const {
    const std::size_t begin = head.find("\r\n" + name + ": ");
    if (begin == std::string::npos) return "";
    const std::size_t value = begin + name.size() + 4;
    return head.substr(value, head.find("\r\n", value) - value);
  }
};

/// Reads one HTTP answer from the socket.
inline Answer read_answer(Raw_socket& socket, double seconds = 10) {
  const auto start = std::chrono::steady_clock::now();
  Answer answer;
  std::size_t end = std::string::npos;
  while ((end = socket.received.find("\r\n\r\n")) == std::string::npos)
    if (!socket.receive(seconds)) return answer;
  answer.head = socket.received.substr(0, end + 2);
  answer.status = std::stoi(answer.head.substr(9, 3));
  const std::string length = answer.header("Content-Length");
  const std::size_t size = length.empty() ? 0 : std::stoul(length);
  while (socket.received.size() < end + 4 + size && socket.receive(seconds)) {
  }
  answer.body = socket.received.substr(end + 4, size);
  socket.received.erase(0, end + 4 + size);
  answer.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return answer;
}

inline std::string request_text(const std::string& method, const std::string& target, const Headers& headers,
                                const std::string& body = "") {
  std::string text = method + " " + target + " HTTP/1.1\r\n";
  for (const auto& [name, value] : headers) text += name + ": " + value + "\r\n";
  if (!body.empty()) text += "Content-Length: " + std::to_string(body.size()) + "\r\n";
  return text + "\r\n" + body;
}

inline Answer ask(unsigned short port, const std::string& method, const std::string& target,
                  const Headers& headers, const std::string& body = "") {
  Raw_socket socket(port);
  socket.send(request_text(method, target, headers, body));
  return read_answer(socket);
}

/// What a browser that was let in knows.
struct Visitor {
  unsigned short port;
  std::string host, origin, secret;

  Headers headers() const {
    return {{"Host", host}, {"Origin", origin}, {"Authorization", "Bearer " + secret}};
  }
};

/// Enters with the token of the address that the program prints.
inline Visitor enter(const std::string& url) {
  Visitor visitor;
  const std::size_t sign = url.find("/#token=");
  REQUIRE(sign != std::string::npos);
  visitor.origin = url.substr(0, sign);
  visitor.host = visitor.origin.substr(std::string("http://").size());
  visitor.port = static_cast<unsigned short>(std::stoi(visitor.host.substr(visitor.host.find(':') + 1)));
  const Answer answer =
      ask(visitor.port, "POST", "/api/enter", {{"Host", visitor.host}, {"Origin", visitor.origin}},
          url.substr(sign + std::string("/#token=").size()));
  REQUIRE(answer.status == 200);
  visitor.secret = nlohmann::json::parse(answer.body)["secret"];
  return visitor;
}

/// A page's WebSocket.
class Page_socket {
public:
  explicit Page_socket(const Visitor& visitor) : m_socket(visitor.port) {
    Headers headers = visitor.headers();
    for (const auto& header : handshake(visitor.secret)) headers.push_back(header);
    m_socket.send(request_text("GET", "/api/socket", headers));
    opening = read_answer(m_socket);
  }

  static Headers handshake(const std::string& secret) {
    return {{"Upgrade", "websocket"},
            {"Connection", "Upgrade"},
            {"Sec-WebSocket-Version", "13"},
            {"Sec-WebSocket-Protocol", "reebquad, " + secret},
            {"Sec-WebSocket-Key", "dGhlIHNhbXBsZSBub25jZQ=="}};
  }

  bool send(const std::string& text, int opcode = 1) { return m_socket.send(frame(text, opcode)); }

  bool send_raw(const std::string& bytes) { return m_socket.send(bytes); }

  /// A masked frame; `announced` replaces the length in its head.
  static std::string frame(const std::string& payload, int opcode = 1, std::uint64_t announced = 0) {
    const std::uint64_t size = announced ? announced : payload.size();
    std::string bytes{char(0x80 | opcode)};
    if (size < 126) {
      bytes += char(0x80 | size);
    } else {
      const int digits = size < 65536 ? 2 : 8;
      bytes += char(0x80 | (digits == 2 ? 126 : 127));
      for (int i = digits - 1; i >= 0; --i) bytes += char(size >> (8 * i) & 255);
    }
    return bytes + std::string(4, '\0') + payload; // a mask of zeros changes nothing
  }

  struct Message {
    int opcode = -1; ///< 1 text, 2 binary, 8 close; -1: the connection ended, -2: nothing came in time
    std::string payload;
  };

  Message receive(double seconds = 20) { return receive(seconds, true); }
  /// The same, without an answer to pings.
  Message receive_silently(double seconds) { return receive(seconds, false); }

  Message receive(double seconds, bool answers) {
    for (;;) {
      Message message;
      if (take_frame(message)) {
        if (message.opcode == 9 && answers) send(message.payload, 10);
        if (message.opcode < 9) return message;
        continue;
      }
      if (!m_socket.receive(seconds)) {
        message.opcode = m_socket.timed_out ? -2 : -1;
        return message;
      }
    }
  }

  /// The next text message that has this member, with this value if one is given.
  nlohmann::json wait_for(const std::string& member, const nlohmann::json& value = nullptr) {
    for (;;) {
      const Message message = receive();
      REQUIRE(message.opcode >= 1);
      REQUIRE(message.opcode != 8);
      if (message.opcode != 1) {
        ++binary_messages;
        continue;
      }
      nlohmann::json json = nlohmann::json::parse(message.payload);
      if (json.value("event", "") == "state") last_state = json;
      if (json.contains(member) && (value.is_null() || json[member] == value)) return json;
    }
  }

  nlohmann::json request(const nlohmann::json& message) {
    send(message.dump());
    return wait_for("reply", message["id"]);
  }

  Answer opening;
  int binary_messages = 0;
  nlohmann::json last_state; ///< that was received

private:
  bool take_frame(Message& message) {
    const std::string& r = m_socket.received;
    if (r.size() < 2) return false;
    std::uint64_t size = std::uint64_t(r[1]) & 127;
    std::size_t head = 2;
    if (size >= 126) {
      const std::size_t digits = size == 126 ? 2 : 8;
      if (r.size() < head + digits) return false;
      size = 0;
      for (std::size_t i = 0; i < digits; ++i) size = size << 8 | static_cast<unsigned char>(r[head + i]);
      head += digits;
    }
    if (r.size() < head + size) return false;
    message.opcode = r[0] & 15;
    message.payload = r.substr(head, std::size_t(size));
    m_socket.received.erase(0, head + std::size_t(size));
    return true;
  }

  Raw_socket m_socket;
};

/// The bytes of an OFF file.
inline std::string torus_file() {
  using namespace CGAL::Reeb_quadrangulation;
  const auto encoded = encode_mesh(polygon_soup(tiny::torus(24, 12)), Mesh_format::off);
  REQUIRE(encoded);
  return encoded->bytes;
}

#endif // REEBQUAD_TEST_STUDIO_CLIENT_H
