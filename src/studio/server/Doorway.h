// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SERVER_DOORWAY_H
#define REEBQUAD_SERVER_DOORWAY_H

#include "session/Folder_lock.h"

#include <filesystem>
#include <string>

namespace reebquad {
namespace studio {

/// What outlives a server whose process crashes, where another process is to go on: the folder, locked; the
/// port, which is listened to, so that pages that knock meanwhile wait; and the secret that pages were given.
/// A process that is forked has it as well.
class Doorway {
public:
  /// Listens on the loopback address, on a free port if `port` is 0. Throws `std::system_error` if the port
  /// is taken, and `std::runtime_error` if another studio works in the folder.
  Doorway(const std::filesystem::path& folder, unsigned short port);
  ~Doorway();
  Doorway(const Doorway&) = delete;
  Doorway& operator=(const Doorway&) = delete;

  const std::filesystem::path& folder() const { return m_folder; }
  unsigned short port() const { return m_port; }
  const std::string& secret() const { return m_secret; }
  /// A copy of the listening socket, to be closed by whoever asks.
  int socket() const;

private:
  std::filesystem::path m_folder;
  Folder_lock m_lock;
  std::string m_secret;
  int m_socket = -1;
  unsigned short m_port = 0;
};

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_SERVER_DOORWAY_H
