// SPDX-License-Identifier: GPL-3.0-or-later
#include "server/Connection.h"

#include "server/Socket_connection.h"
#include "view/Assets.h"

#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include <algorithm>
#include <optional>
#include <utility>

namespace reebquad {
namespace studio {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using CGAL::Reeb_quadrangulation::Error_code;

namespace {

constexpr std::uint64_t longest_small_body = 4096;
constexpr std::size_t longest_upload_name = 200;

std::string_view view(beast::string_view text) {
  return {text.data(), text.size()};
}

/// The value of `key` in the query of a request's target, with %XX decoded; empty if there is none.
std::string query_value(std::string_view target, std::string_view key) {
  std::size_t begin = target.find('?');
  while (begin < target.size()) {
    const std::size_t end = std::min(target.find('&', begin + 1), target.size());
    const std::string_view part = target.substr(begin + 1, end - begin - 1);
    begin = end;
    if (part.size() <= key.size() || part.substr(0, key.size()) != key || part[key.size()] != '=') continue;
    std::string value;
    const auto digit = [](char c) {
      return c >= '0' && c <= '9'   ? c - '0'
             : c >= 'a' && c <= 'f' ? c - 'a' + 10
             : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                    : -1;
    };
    for (std::size_t i = key.size() + 1; i < part.size(); ++i) {
      const bool coded =
          part[i] == '%' && i + 2 < part.size() && digit(part[i + 1]) >= 0 && digit(part[i + 2]) >= 0;
      value += coded ? char(16 * digit(part[i + 1]) + digit(part[i + 2])) : part[i];
      if (coded) i += 2;
    }
    return value;
  }
  return "";
}

/// The last part of a name that a page gives, without what must not stand in a name.
std::string plain_name(const std::string& name) {
  std::string plain;
  for (const char c : name.substr(name.find_last_of("/\\") + 1))
    if (static_cast<unsigned char>(c) >= 32 && c != 127 && plain.size() < longest_upload_name) plain += c;
  return plain.empty() ? "mesh" : plain;
}

/// The secret in the value of an `Authorization` header.
std::string_view bearer(std::string_view value) {
  constexpr std::string_view scheme = "Bearer ";
  return value.substr(0, scheme.size()) == scheme ? value.substr(scheme.size()) : std::string_view();
}

/// A page cannot add headers to a WebSocket's handshake, but name protocols: ours, and the secret.
std::string_view offered_secret(std::string_view protocols) {
  const std::string first = std::string(socket_protocol) + ",";
  if (protocols.substr(0, first.size()) != first) return {};
  protocols.remove_prefix(first.size());
  while (!protocols.empty() && protocols.front() == ' ') protocols.remove_prefix(1);
  return protocols;
}

class Http_connection : public Guest, public std::enable_shared_from_this<Http_connection> {
public:
  Http_connection(asio::ip::tcp::socket socket, Shared& shared)
      : m_stream(std::move(socket)), m_shared(shared), m_place(shared, this) {}

  void send_away() override { m_stream.close(); }

  void read_header() {
    m_parser.emplace();
    m_parser->header_limit(std::uint32_t(m_shared.limits.header_bytes));
    m_parser->body_limit(m_shared.limits.upload_bytes); // a smaller one once the path is known
    m_stream.expires_after(m_shared.limits.header_time);
    http::async_read_header(m_stream, m_buffer, *m_parser,
                            [self = shared_from_this()](beast::error_code failed, std::size_t) {
                              if (failed) return self->fail_reading(failed);
                              self->judge();
                            });
  }

private:
  using Request_message = http::request<http::string_body>;
  const Request_message& request() const { return m_parser->get(); }
  std::string_view target() const { return view(request().target()); }
  std::string_view path() const { return target().substr(0, target().find('?')); }
  std::string header(http::field field) const { return std::string(view(request()[field])); }

  void fail_reading(beast::error_code failed) {
    if (failed == http::error::header_limit)
      return refuse(http::status::request_header_fields_too_large, "the header is too long");
    if (failed == http::error::body_limit)
      return refuse(http::status::payload_too_large, "the file is too large");
    if (failed.category() == http::make_error_code(http::error::bad_method).category() &&
        failed != http::error::end_of_stream && failed != http::error::partial_message)
      return refuse(http::status::bad_request, "this is no HTTP request");
    close();
  }

  /// Decides on the header alone whether to go on, before a body is read or anything is looked up.
  void judge() {
    const Request_message& r = request();
    if (r.count(http::field::host) != 1 || !m_shared.gate.host_is_ours(header(http::field::host)))
      return refuse(http::status::misdirected_request, "this is not the host that was asked for");
    if (r.count(http::field::origin) > 1 || !m_shared.gate.origin_is_not_foreign(header(http::field::origin)))
      return refuse(http::status::forbidden, "pages of other origins have no access");
    if (path().substr(0, 5) != "/api/") return serve_asset();
    const bool needs_origin = r.method() != http::verb::get || path() == "/api/socket";
    if (needs_origin && !m_shared.gate.origin_is_ours(header(http::field::origin)))
      return refuse(http::status::forbidden, "the origin is missing");
    if (path() != "/api/enter" && !has_secret())
      return refuse(http::status::unauthorized, "open the address that the program printed");
    serve_api();
  }

  bool has_secret() {
    const std::string shown = path() == "/api/socket"
                                  ? std::string(offered_secret(header(http::field::sec_websocket_protocol)))
                                  : std::string(bearer(header(http::field::authorization)));
    is_known = m_shared.gate.secret_opens(shown);
    return is_known;
  }

  void serve_asset() {
    const Request_message& r = request();
    if (r.method() != http::verb::get && r.method() != http::verb::head)
      return refuse(http::status::method_not_allowed, "files can only be read");
    const Asset* asset = target() == path() ? find_asset(path()) : nullptr;
    if (!asset) return refuse(http::status::not_found, "there is no such page");
    answer(http::status::ok, std::string(asset->type), std::string(asset->bytes));
  }

  void serve_api() {
    const http::verb method = request().method();
    if (path() == "/api/enter" && method == http::verb::post)
      return read_body(longest_small_body, &Http_connection::enter);
    if (path() == "/api/upload" && method == http::verb::post)
      return read_body(m_shared.limits.upload_bytes, &Http_connection::upload);
    if (path() == "/api/socket" && method == http::verb::get) return become_socket();
    if (path() == "/api/download" && method == http::verb::get) return download();
    refuse(http::status::not_found, "there is no such request");
  }

  using Handler = void (Http_connection::*)();

  void read_body(std::uint64_t limit, Handler handler) {
    m_handler = handler;
    m_parser->body_limit(limit);
    const auto length = m_parser->content_length();
    if (length && *length > limit) return refuse(http::status::payload_too_large, "the file is too large");
    m_body_deadline = std::chrono::steady_clock::now() +
                      (is_known ? m_shared.limits.upload_time : m_shared.limits.header_time);
    if (header(http::field::expect) == "100-continue")
      return refuse(http::status::expectation_failed, "send the body at once");
    read_more();
  }

  void read_more() {
    if (m_parser->is_done()) return (this->*m_handler)();
    const auto now = std::chrono::steady_clock::now();
    if (now > m_body_deadline) return close();
    m_stream.expires_at(std::min(now + m_shared.limits.quiet_time, m_body_deadline));
    http::async_read_some(m_stream, m_buffer, *m_parser,
                          [self = shared_from_this()](beast::error_code failed, std::size_t) {
                            if (failed) return self->fail_reading(failed);
                            self->read_more();
                          });
  }

  void enter() {
    if (!m_shared.gate.token_opens(request().body()))
      return refuse(http::status::forbidden, "the address was used already, is too old, or of another run");
    answer(http::status::ok, "application/json", Json{{"secret", m_shared.gate.secret()}}.dump());
  }

  void upload() {
    m_stream.expires_never();
    m_shared.hub.upload(plain_name(query_value(target(), "name")), std::move(m_parser->get().body()),
                        [self = shared_from_this()](Result<std::string> result) {
                          self->answer_with(std::move(result), "application/json");
                        });
  }

  void download() {
    m_stream.expires_never();
    m_shared.hub.download(query_value(target(), "what"),
                          [self = shared_from_this()](Result<std::string> result) {
                            self->answer_with(std::move(result), "application/octet-stream");
                          });
  }

  void answer_with(Result<std::string> result, const std::string& type) {
    if (result) return answer(http::status::ok, type, std::move(*result));
    refuse(http::status::unprocessable_entity, result.error().message);
  }

  void become_socket() {
    if (!boost::beast::websocket::is_upgrade(request()))
      return refuse(http::status::upgrade_required, "a WebSocket is expected");
    serve_socket(std::move(m_stream), m_parser->release(), m_shared);
  }

  /// Answers and closes the connection: the rest of what was refused is not read.
  void refuse(http::status status, const std::string& sentence) {
    m_keep = false;
    answer(status, "application/json",
           Json{{"error", sentence}}.dump(-1, ' ', false, Json::error_handler_t::replace));
  }

  void answer(http::status status, const std::string& type, std::string body) {
    const unsigned version = m_parser->is_header_done() ? request().version() : 11;
    const bool head = m_parser->is_header_done() && request().method() == http::verb::head;
    m_keep = m_keep && m_parser->is_header_done() && m_parser->is_done() && request().keep_alive();
    m_response.emplace(status, version);
    http::response<http::string_body>& r = *m_response;
    r.set(http::field::content_type, type);
    r.set("X-Content-Type-Options", "nosniff");
    r.set("Content-Security-Policy", m_shared.gate.content_security_policy());
    r.set("Referrer-Policy", "no-referrer");
    r.set("Cross-Origin-Opener-Policy", "same-origin");
    r.set("Cross-Origin-Resource-Policy", "same-origin");
    r.set(http::field::cache_control, "no-store");
    r.keep_alive(m_keep);
    r.body() = std::move(body);
    r.prepare_payload();
    if (head) r.body().clear();
    write();
  }

  void write() {
    m_serializer.emplace(*m_response);
    if (m_parser->is_header_done() && request().method() == http::verb::head) m_serializer->split(true);
    write_more();
  }

  // In pieces, so that a large file over a slow connection is given up only when nothing moves.
  void write_more() {
    m_stream.expires_after(m_shared.limits.quiet_time);
    const bool only_header = m_serializer->split();
    http::async_write_some(m_stream, *m_serializer,
                           [self = shared_from_this(), only_header](beast::error_code failed, std::size_t) {
                             if (failed) return self->close();
                             const bool done = only_header ? self->m_serializer->is_header_done()
                                                           : self->m_serializer->is_done();
                             if (!done) return self->write_more();
                             if (self->m_keep) return self->read_header();
                             self->close();
                           });
  }

  // The client is let read what was sent: closing at once with bytes unread would reset the connection.
  void close() {
    beast::error_code ignored;
    m_stream.socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
    drain();
  }

  void drain() {
    if (m_drained > m_shared.limits.header_bytes * 64) return m_stream.close();
    if (m_drained == 0) m_stream.expires_after(std::chrono::seconds(1));
    m_stream.async_read_some(asio::buffer(m_rest),
                             [self = shared_from_this()](beast::error_code failed, std::size_t size) {
                               if (failed) return self->m_stream.close();
                               self->m_drained += size;
                               self->drain();
                             });
  }

  beast::tcp_stream m_stream;
  Shared& m_shared;
  Place m_place;
  beast::flat_buffer m_buffer{std::size_t(1) << 16};
  std::optional<http::request_parser<http::string_body>> m_parser;
  std::optional<http::response<http::string_body>> m_response;
  std::optional<http::response_serializer<http::string_body>> m_serializer;
  std::chrono::steady_clock::time_point m_body_deadline;
  Handler m_handler = nullptr;
  bool m_keep = true;
  std::array<char, 4096> m_rest{};
  std::size_t m_drained = 0;
};

} // namespace

bool Guests::make_room(std::size_t most) {
  if (m_guests.size() < most) return true;
  for (Guest* guest : m_guests)
    if (!guest->is_known && !std::exchange(guest->is_known, true)) { // counts no more
      guest->send_away();
      return true;
    }
  return false;
}

void serve_connection(asio::ip::tcp::socket socket, Shared& shared) {
  std::make_shared<Http_connection>(std::move(socket), shared)->read_header();
}

} // namespace studio
} // namespace reebquad
