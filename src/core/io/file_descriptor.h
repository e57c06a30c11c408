// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_IO_FILE_DESCRIPTOR_H
#define REEBQUAD_IO_FILE_DESCRIPTOR_H

#include <unistd.h>
#include <utility>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Closes an open file at the end of its scope.
class File_descriptor {
public:
  explicit File_descriptor(int descriptor) : m_descriptor(descriptor) {}
  File_descriptor(File_descriptor&& other) noexcept : m_descriptor(std::exchange(other.m_descriptor, -1)) {}
  File_descriptor& operator=(File_descriptor&& other) noexcept {
    std::swap(m_descriptor, other.m_descriptor);
    return *this;
  }
  ~File_descriptor() { close(); }

  int get() const { return m_descriptor; }
  bool is_open() const { return m_descriptor >= 0; }
  /// Whether closing succeeded; on some file systems only this shows that writing failed.
  bool close() {
    const int descriptor = m_descriptor;
    m_descriptor = -1;
    return descriptor < 0 || ::close(descriptor) == 0;
  }

private:
  int m_descriptor;
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_IO_FILE_DESCRIPTOR_H
