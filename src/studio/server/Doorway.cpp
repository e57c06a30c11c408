// SPDX-License-Identifier: GPL-3.0-or-later
#include "server/Doorway.h"

#include "server/Gate.h"

#include <cerrno>
#include <fcntl.h>
#include <netinet/in.h>
#include <stdexcept>
#include <sys/socket.h>
#include <system_error>
#include <unistd.h>

namespace reebquad {
namespace studio {

namespace {

Folder_lock locked(const std::filesystem::path& folder) {
  auto lock = Folder_lock::take(folder);
  if (!lock) throw std::runtime_error(lock.error().message);
  return std::move(*lock);
}

} // namespace

Doorway::Doorway(const std::filesystem::path& folder, unsigned short port)
    : m_folder(folder), m_lock(locked(folder)), m_secret(random_secret()) {
  m_socket = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  const int yes = 1;
  if (m_socket < 0 || ::fcntl(m_socket, F_SETFD, FD_CLOEXEC) != 0 ||
      ::setsockopt(m_socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes) != 0 ||
      ::bind(m_socket, any, size) != 0 || ::listen(m_socket, 128) != 0 ||
      ::getsockname(m_socket, any, &size) != 0) {
    const int error = errno;
    if (m_socket >= 0) ::close(m_socket);
    throw std::system_error(error, std::generic_category(),
                            "port " + std::to_string(port) + " cannot be used");
  }
  m_port = ntohs(address.sin_port);
}

Doorway::~Doorway() {
  ::close(m_socket);
}

int Doorway::socket() const {
  const int copy = ::fcntl(m_socket, F_DUPFD_CLOEXEC, 0);
  if (copy < 0) throw std::system_error(errno, std::generic_category(), "the port cannot be used");
  return copy;
}

} // namespace studio
} // namespace reebquad
