// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SESSION_FOLDER_H
#define REEBQUAD_SESSION_FOLDER_H

#include <CGAL/Reeb_quadrangulation/Result.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace reebquad {
namespace studio {

template <class T> using Result = CGAL::Reeb_quadrangulation::Result<T>;

/// A file that the page may open.
struct Listed_file {
  std::string name; ///< relative to the folder, with '/'
  std::uint64_t bytes = 0;
};

/// The folder that the program was started in: the page reads and writes files in it and nowhere else.
class Folder {
public:
  /// \pre `path` exists
  explicit Folder(const std::filesystem::path& path);
  const std::filesystem::path& path() const { return m_path; }

  /// The path of a file that the page names. Refused are empty and long names, absolute ones, parts that are
  /// "..", "." or begin with a dot, control characters and backslashes; and, after symbolic links are
  /// followed, everything outside. The file need not exist, its folder must. Fails with `unreadable_file`.
  Result<std::string> resolve(const std::string& name) const;

  /// The mesh files in the folder and below, at most `limit` and three levels deep, by name.
  std::vector<Listed_file> meshes(std::size_t limit = 500) const;
  /// The recipes there, which are told by how they begin.
  std::vector<Listed_file> recipes(std::size_t limit = 500) const;

private:
  std::vector<Listed_file> files(bool (*is_wanted)(const std::filesystem::path&), std::size_t limit) const;

  std::filesystem::path m_path; // canonical
};

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_SESSION_FOLDER_H
