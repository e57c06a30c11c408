// SPDX-License-Identifier: GPL-3.0-or-later
#include "server/Server.h"

#include "server/Connection.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include <optional>
#include <thread>

namespace reebquad {
namespace studio {

namespace asio = boost::asio;
using asio::ip::tcp;

struct Server::Implementation {
  Implementation(const Doorway& doorway, const Start& start, const Limits& limits)
      : acceptor(context, tcp::v4(), doorway.socket()), retry(context) {
    shared.emplace(doorway, limits,
                   [this](std::function<void()> task) { asio::post(context, std::move(task)); });
    if (start.resumes)
      shared->hub.resume();
    else if (!start.file.empty())
      shared->hub.open_file(start.file);
    accept();
    thread = std::thread([this] { context.run(); });
  }

  ~Implementation() {
    context.stop();
    thread.join();
    shared->hub.stop();
  }

  void accept() {
    acceptor.async_accept([this](boost::system::error_code failed, tcp::socket socket) {
      if (failed) return accept_later(); // too many open files, say
      if (shared->guests.make_room(shared->limits.connections)) {
        boost::system::error_code ignored;
        socket.set_option(tcp::no_delay(true), ignored);
        serve_connection(std::move(socket), *shared);
      }
      accept();
    });
  }

  void accept_later() {
    retry.expires_after(std::chrono::milliseconds(100));
    retry.async_wait([this](boost::system::error_code) { accept(); });
  }

  // The context's handlers own connections, which refer to `shared`: so the context is destroyed first.
  std::optional<Shared> shared;
  asio::io_context context{1};
  tcp::acceptor acceptor;
  asio::steady_timer retry;
  std::thread thread;
};

Server::Server(const Doorway& doorway, const Start& start, const Limits& limits)
    : m_implementation(std::make_unique<Implementation>(doorway, start, limits)) {}

Server::Server(const std::filesystem::path& folder, unsigned short port, const Limits& limits)
    : m_doorway(std::make_unique<Doorway>(folder, port)),
      m_implementation(std::make_unique<Implementation>(*m_doorway, Start(), limits)) {}

Server::~Server() = default;

unsigned short Server::port() const {
  return m_implementation->acceptor.local_endpoint().port();
}

std::string Server::url() const {
  return m_implementation->shared->gate.url();
}

bool Server::awaits_visitor() const {
  return m_implementation->shared->gate.awaits_visitor();
}

void Server::renew_token() {
  m_implementation->shared->gate.renew_token();
}

} // namespace studio
} // namespace reebquad
