// SPDX-License-Identifier: GPL-3.0-or-later
#include "server/Server.h"

#include "server/Connection.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include <optional>
#include <system_error>
#include <thread>

namespace reebquad {
namespace studio {

namespace asio = boost::asio;
using asio::ip::tcp;

struct Server::Implementation {
  Implementation(const std::filesystem::path& folder, unsigned short port, const Limits& limits)
      : acceptor(context), retry(context) {
    listen(port);
    shared.emplace(Folder(folder), acceptor.local_endpoint().port(), limits,
                   [this](std::function<void()> task) { asio::post(context, std::move(task)); });
    accept();
    thread = std::thread([this] { context.run(); });
  }

  ~Implementation() {
    context.stop();
    thread.join();
    shared->hub.stop();
  }

  void listen(unsigned short port) {
    boost::system::error_code failed;
    const tcp::endpoint loopback(asio::ip::address_v4::loopback(), port);
    acceptor.open(loopback.protocol(), failed);
    if (!failed) acceptor.set_option(tcp::acceptor::reuse_address(true), failed);
    if (!failed) acceptor.bind(loopback, failed);
    if (!failed) acceptor.listen(128, failed);
    if (failed)
      throw std::system_error(failed.value(), std::generic_category(),
                              "port " + std::to_string(port) + " cannot be used");
  }

  void accept() {
    acceptor.async_accept([this](boost::system::error_code failed, tcp::socket socket) {
      if (failed) return accept_later(); // too many open files, say
      if (shared->connections < shared->limits.connections) {
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

Server::Server(const std::filesystem::path& folder, unsigned short port, const Limits& limits)
    : m_implementation(std::make_unique<Implementation>(folder, port, limits)) {}

Server::~Server() = default;

unsigned short Server::port() const {
  return m_implementation->acceptor.local_endpoint().port();
}

std::string Server::url() const {
  return m_implementation->shared->gate.url();
}

void Server::open_file(const std::string& name) {
  Implementation& i = *m_implementation;
  asio::post(i.context, [&i, name] { i.shared->hub.open_file(name); });
}

} // namespace studio
} // namespace reebquad
