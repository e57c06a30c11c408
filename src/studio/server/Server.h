// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SERVER_SERVER_H
#define REEBQUAD_SERVER_SERVER_H

#include "server/Doorway.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace reebquad {
namespace studio {

/// What the server allows. The defaults suit a person at a browser; tests take smaller ones.
struct Limits {
  std::size_t connections = 256;
  std::size_t header_bytes = 16 << 10;
  std::uint64_t upload_bytes = std::uint64_t(1) << 30;
  /// For a whole request header, also while a connection is kept, and for a body of someone unknown.
  std::chrono::milliseconds header_time{10000};
  std::chrono::milliseconds token_life{600000};
  std::chrono::milliseconds quiet_time{15000}; ///< within a body, or while an answer is taken
  std::chrono::milliseconds upload_time{600000};
  std::chrono::milliseconds socket_idle_time{60000}; ///< pages answer pings within it
};

/// What the server does before anyone asks.
struct Start {
  std::string file; ///< a mesh file of the folder, by its name relative to it, that is opened; empty: none
  bool resumes = false; ///< brings back what was open last, if there is anything
};

/// The studio's HTTP and WebSocket server on the loopback address: one thread for the sockets, one for the
/// work.
class Server {
public:
  /// Serves at a doorway, which must outlive it.
  Server(const Doorway& doorway, const Start& start, const Limits& limits = {});
  /// At a doorway of its own; throws as that does.
  Server(const std::filesystem::path& folder, unsigned short port, const Limits& limits = {});
  /// Stops listening, closes all connections and ends the work.
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  unsigned short port() const;
  /// The address of the page with the token that opens it, once.
  std::string url() const;
  /// Whether nobody has come in with that token, and it still opens.
  bool awaits_visitor() const;
  /// Another token takes its place.
  void renew_token();

private:
  struct Implementation;
  std::unique_ptr<Doorway> m_doorway; ///< if it is its own
  std::unique_ptr<Implementation> m_implementation;
};

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_SERVER_SERVER_H
