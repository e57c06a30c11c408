// SPDX-License-Identifier: GPL-3.0-or-later
#include "server/Socket_connection.h"

#include <boost/asio/buffer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket.hpp>

namespace reebquad {
namespace studio {

namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;

namespace {

class Socket_connection : public Client,
                          public Guest,
                          public std::enable_shared_from_this<Socket_connection> {
public:
  Socket_connection(beast::tcp_stream stream, Shared& shared)
      : m_socket(std::move(stream)), m_shared(shared), m_place(shared, this) {
    is_known = true;
  }

  void send_away() override { leave(); }

  void accept(const beast::http::request<beast::http::string_body>& request) {
    // From here on the WebSocket's own limits of time hold.
    beast::get_lowest_layer(m_socket).expires_never();
    websocket::stream_base::timeout times;
    times.handshake_timeout = m_shared.limits.header_time;
    times.idle_timeout = m_shared.limits.socket_idle_time;
    times.keep_alive_pings = true;
    m_socket.set_option(times);
    websocket::permessage_deflate compression;
    compression.client_enable = compression.server_enable = false;
    m_socket.set_option(compression);
    m_socket.set_option(websocket::stream_base::decorator([](websocket::response_type& answer) {
      answer.set(beast::http::field::sec_websocket_protocol, socket_protocol);
    }));
    m_socket.read_message_max(longest_request);
    m_socket.auto_fragment(false);
    m_socket.async_accept(request, [self = shared_from_this()](beast::error_code failed) {
      if (failed) return;
      self->m_shared.hub.add(self);
      self->read();
    });
  }

  void send(Message message) override {
    if (m_closing) return;
    if (!m_outbox.push(std::move(message))) return close(websocket::close_code::try_again_later);
    if (!m_writing) write();
  }

private:
  void read() {
    m_socket.async_read(m_buffer, [self = shared_from_this()](beast::error_code failed, std::size_t) {
      if (failed) return self->leave();
      self->take();
    });
  }

  void take() {
    if (!m_socket.got_text()) return close(websocket::close_code::unknown_data);
    const auto bytes = m_buffer.data();
    m_shared.hub.receive(shared_from_this(), {static_cast<const char*>(bytes.data()), bytes.size()});
    m_buffer.consume(m_buffer.size());
    if (!m_closing) read();
  }

  void write() {
    m_writing = true;
    m_sent = m_outbox.pop();
    m_socket.binary(m_sent.is_binary);
    m_socket.async_write(boost::asio::buffer(*m_sent.bytes),
                         [self = shared_from_this()](beast::error_code failed, std::size_t) {
                           self->m_writing = false;
                           self->m_sent.bytes.reset();
                           if (failed) return self->leave();
                           if (!self->m_outbox.empty()) self->write();
                         });
  }

  // Says goodbye only if nothing is being written: who takes nothing would not take that either.
  void close(websocket::close_code code) {
    m_closing = true;
    if (m_writing) return leave();
    m_writing = true;
    m_socket.async_close(code, [self = shared_from_this()](beast::error_code) { self->leave(); });
  }

  void leave() {
    m_closing = true;
    beast::get_lowest_layer(m_socket).close();
    m_shared.hub.remove(shared_from_this());
  }

  websocket::stream<beast::tcp_stream> m_socket;
  Shared& m_shared;
  Place m_place;
  beast::flat_buffer m_buffer;
  Outbox m_outbox;
  Message m_sent; ///< being written
  bool m_writing = false;
  bool m_closing = false;
};

} // namespace

void serve_socket(beast::tcp_stream stream, beast::http::request<beast::http::string_body> request,
                  Shared& shared) {
  std::make_shared<Socket_connection>(std::move(stream), shared)->accept(request);
}

} // namespace studio
} // namespace reebquad
