// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SERVER_CONNECTION_H
#define REEBQUAD_SERVER_CONNECTION_H

#include "server/Gate.h"
#include "server/Hub.h"
#include "server/Server.h"

#include <boost/asio/ip/tcp.hpp>

#include <list>

namespace reebquad {
namespace studio {

/// The protocol over the WebSocket, by its name in the handshake.
constexpr const char* socket_protocol = "reebquad";

/// A connection, as the others see it.
class Guest {
public:
  virtual ~Guest() = default;
  /// Closes the connection.
  virtual void send_away() = 0;
  bool is_known = false; ///< it has shown the secret
};

/// All connections. When there are too many, that of the stranger who is there longest has to go: strangers
/// cannot shut users out.
class Guests {
public:
  using Place = std::list<Guest*>::iterator;
  Place add(Guest* guest) { return m_guests.insert(m_guests.end(), guest); }
  void remove(Place place) { m_guests.erase(place); }
  /// False if there are `most` already, all of whom are known.
  bool make_room(std::size_t most);

private:
  std::list<Guest*> m_guests;
};

/// What connections share. Used on the sockets' thread.
struct Shared {
  Shared(const Doorway& doorway, const Limits& limits_, Hub::Post post)
      : gate(doorway.port(), doorway.secret(), limits_.token_life), limits(limits_),
        hub(Folder(doorway.folder()), std::move(post)) {}
  Gate gate;
  Limits limits;
  Guests guests;
  Hub hub;
};

/// Serves HTTP requests on the socket, one after the other, until it is closed or becomes a WebSocket.
void serve_connection(boost::asio::ip::tcp::socket socket, Shared& shared);

/// Takes a place among the guests, as long as it lives.
class Place {
public:
  Place(Shared& shared, Guest* guest) : m_shared(shared), m_place(shared.guests.add(guest)) {}
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;
  ~Place() { m_shared.guests.remove(m_place); }

private:
  Shared& m_shared;
  Guests::Place m_place;
};

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_SERVER_CONNECTION_H
