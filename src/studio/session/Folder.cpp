// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/Folder.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>

namespace reebquad {
namespace studio {

namespace fs = std::filesystem;
using CGAL::Reeb_quadrangulation::Error_code;
using CGAL::Reeb_quadrangulation::make_error;

namespace {

constexpr std::size_t longest_name = 1000;
constexpr int deepest_level = 3;

bool is_plain(const std::string& name) {
  if (name.empty() || name.size() > longest_name || name.front() == '/') return false;
  for (const char c : name)
    if (static_cast<unsigned char>(c) < 32 || c == 127 || c == '\\') return false;
  std::size_t begin = 0;
  while (begin <= name.size()) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    if (end == begin || name[begin] == '.') return false;
    begin = end + 1;
  }
  return true;
}

bool is_below(const fs::path& path, const fs::path& folder) {
  const auto [rest, unused] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return rest == folder.end() && unused != path.end();
}

/// In lower case.
std::string extension_of(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

bool is_mesh(const fs::path& path) {
  const std::string extension = extension_of(path);
  constexpr std::array<const char*, 4> known{".obj", ".off", ".ply", ".stl"};
  return std::find(known.begin(), known.end(), extension) != known.end();
}

bool is_recipe(const fs::path& path) {
  if (extension_of(path) != ".json") return false;
  std::string begin(200, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(begin.data(), std::streamsize(begin.size()));
  return begin.find("\"reebquad recipe\"") != std::string::npos;
}

} // namespace

Folder::Folder(const fs::path& path) : m_path(fs::canonical(path)) {}

Result<std::string> Folder::resolve(const std::string& name) const {
  const auto refused = make_error(Error_code::unreadable_file,
                                  "only files inside the folder that the studio was started in can be used");
  if (!is_plain(name)) return refused;
  std::error_code failed;
  const fs::path asked = m_path / fs::u8path(name);
  // The file itself if it exists (also as a link), else its folder with the file's name.
  const bool exists = fs::exists(fs::symlink_status(asked, failed));
  const fs::path real =
      exists ? fs::canonical(asked, failed) : fs::canonical(asked.parent_path(), failed) / asked.filename();
  if (failed || !is_below(real, m_path)) return refused;
  return real.string();
}

std::vector<Listed_file> Folder::meshes(std::size_t limit) const {
  return files(is_mesh, limit);
}

std::vector<Listed_file> Folder::recipes(std::size_t limit) const {
  return files(is_recipe, limit);
}

std::vector<Listed_file> Folder::files(bool (*is_wanted)(const fs::path&), std::size_t limit) const {
  std::vector<Listed_file> files;
  std::error_code failed;
  fs::recursive_directory_iterator entry(m_path, fs::directory_options::skip_permission_denied, failed);
  std::size_t looked_at = 0;
  for (const fs::recursive_directory_iterator end; !failed && entry != end; entry.increment(failed)) {
    if (++looked_at > 20 * limit || files.size() >= limit) break;
    const std::string leaf = entry->path().filename().string();
    std::error_code unknown;
    if (leaf.front() == '.' || entry.depth() >= deepest_level) {
      if (entry->is_directory(unknown)) entry.disable_recursion_pending();
      if (leaf.front() == '.') continue;
    }
    if (!entry->is_regular_file(unknown) || !is_wanted(entry->path())) continue;
    const std::string name = entry->path().lexically_relative(m_path).generic_string();
    if (resolve(name)) files.push_back({name, entry->file_size(unknown)});
  }
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return files;
}

} // namespace studio
} // namespace reebquad
