// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SERVER_CONNECTION_H
#define REEBQUAD_SERVER_CONNECTION_H

#include "server/Gate.h"
#include "server/Hub.h"
#include "server/Server.h"

#include <boost/asio/ip/tcp.hpp>

namespace reebquad {
namespace studio {

/// What connections share. Used on the sockets' thread.
struct Shared {
  Shared(const Folder& folder, unsigned short port, const Limits& limits_, Hub::Post post)
      : gate(port), limits(limits_), hub(folder, std::move(post)) {}
  Gate gate;
  Limits limits;
  std::size_t connections = 0;
  Hub hub;
};

/// Serves HTTP requests on the socket, one after the other, until it is closed or becomes a WebSocket.
void serve_connection(boost::asio::ip::tcp::socket socket, Shared& shared);

/// Takes a place among the connections, as long as it lives.
class Place {
public:
  explicit Place(Shared& shared) : m_shared(&shared) { ++m_shared->connections; }
  Place(Place&& other) noexcept : m_shared(other.m_shared) { other.m_shared = nullptr; }
  Place& operator=(Place&&) = delete;
  ~Place() {
    if (m_shared) --m_shared->connections;
  }

private:
  Shared* m_shared;
};

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_SERVER_CONNECTION_H
