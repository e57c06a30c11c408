// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>

#include "io/file_descriptor.h"
#include "io/readers.h"
#include "io/text_cursor.h"

#include <algorithm>
#include <cerrno>
#include <memory>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

bool begins_with(std::string_view text, std::string_view prefix) {
  return text.substr(0, prefix.size()) == prefix;
}

/// What the first bytes say that we do not read; null if they say nothing of the kind.
const char* foreign_content(std::string_view text) {
  if (begins_with(text, "\x1f\x8b")) return "compressed with gzip; decompress it first";
  if (begins_with(text, "BZh")) return "compressed with bzip2; decompress it first";
  if (begins_with(text, "\xfd"
                        "7zXZ"))
    return "compressed with xz; decompress it first";
  if (begins_with(text, "\x28\xb5\x2f\xfd")) return "compressed with zstd; decompress it first";
  if (begins_with(text, "PK\x03\x04"))
    return "a zip archive; extract a mesh first (3MF, which is one, is read if the program is built with "
           "Assimp and "
           "the name ends with .3mf)";
  if (begins_with(text, "# vtk DataFile")) return "VTK legacy, which is written but not read";
  if (begins_with(text, "<?xml") || begins_with(text, "<VTKFile")) return "XML, which is not read";
  if (begins_with(text, "MeshVersionFormatted") || begins_with(text, "$MeshFormat"))
    return "a volume mesh, which is not read";
  if (begins_with(text, "\xff\xfe") || begins_with(text, "\xfe\xff"))
    return "text in UTF-16; save it as UTF-8 or ascii";
  return nullptr;
}

bool is_off_keyword(std::string_view word) {
  const std::size_t off = word.find("OFF");
  return off != std::string_view::npos && off <= 6 &&
         word.substr(0, off).find_first_not_of("STCN4n") == std::string_view::npos;
}

bool is_obj_keyword(std::string_view word) {
  constexpr std::string_view keywords[] = {"v", "vt", "vn",     "vp",     "f", "o",
                                           "g", "s",  "mtllib", "usemtl", "l", "p"};
  return std::find(std::begin(keywords), std::end(keywords), word) != std::end(keywords);
}

/// The format that the content shows, or `automatic`.
Mesh_format format_of_content(const char* data, std::size_t size) {
  const std::string_view text(data, size);
  if (begins_with(text, "glTF")) return Mesh_format::glb;
  if (begins_with(text, "ply") && size > 3 && (text[3] == '\n' || text[3] == '\r' || text[3] == ' '))
    return Mesh_format::ply;
  Text_cursor cursor(data, data + size, '#');
  const std::string_view first = cursor.find_word() ? cursor.peek() : std::string_view();
  if (begins_with(first, "{")) return Mesh_format::glb;
  if (is_off_keyword(first)) return Mesh_format::off;
  if (begins_with(first, "solid") || begins_with(first, "SOLID")) return Mesh_format::stl;
  const auto byte = [data](int i) { return std::uint64_t(static_cast<unsigned char>(data[i])); };
  if (size >= 84 && size == 84 + 50 * (byte(80) | byte(81) << 8 | byte(82) << 16 | byte(83) << 24))
    return Mesh_format::stl;
  return is_obj_keyword(first) ? Mesh_format::obj : Mesh_format::automatic;
}

Error unreadable(const std::string& path, const std::string& why) {
  return make_error(Error_code::unreadable_file, "Cannot read '" + path + "': " + why + ".");
}

Error unreadable(const std::string& path, int error) {
  return unreadable(path, std::generic_category().message(error));
}

/// The last extension of a path, in small letters, without the dot.
std::string extension_of(const std::string& path) {
  const std::size_t dot = path.find_last_of("./");
  if (dot == std::string::npos || path[dot] != '.') return {};
  std::string extension = path.substr(dot + 1);
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return extension;
}

bool is_other_format(const std::string& extension) {
  return !extension.empty() &&
         (' ' + other_mesh_formats() + ' ').find(' ' + extension + ' ') != std::string::npos;
}

/// Reads until `size` bytes are there or the file ends; the number of bytes read, or -1.
std::int64_t read_bytes(int file, char* data, std::size_t size) {
  std::size_t done = 0;
  while (done < size) {
    const ssize_t n = ::read(file, data + done, std::min(size - done, std::size_t(1) << 26));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return -1;
    if (n == 0) break;
    done += std::size_t(n);
  }
  return std::int64_t(done);
}

} // namespace

Result<Polygon_soup> parse_polygon_soup(const char* data, std::size_t size, Mesh_format format,
                                        std::vector<std::string>* notes, Mesh_attributes* attributes) {
  Notes ignored;
  Notes& told = notes ? *notes : ignored;
  if (size == 0) return make_error(Error_code::malformed_file, "The file is empty.");
  if (const char* foreign = foreign_content(std::string_view(data, size)))
    return make_error(Error_code::unsupported_format, std::string("The file is ") + foreign + ".");
  if (begins_with(std::string_view(data, size), "\xef\xbb\xbf")) { // a byte order mark before text
    data += 3;
    size -= 3;
  }
  const Mesh_format shown = format_of_content(data, size);
  switch (shown == Mesh_format::automatic ? format : shown) {
  case Mesh_format::off: return parse_off(data, size, told, attributes);
  case Mesh_format::obj: return parse_obj(data, size, told, attributes);
  case Mesh_format::ply: return parse_ply(data, size, attributes);
  case Mesh_format::stl: return parse_stl(data, size, told);
  case Mesh_format::glb: return parse_gltf(data, size, told, attributes);
  case Mesh_format::vtk:
  case Mesh_format::vtu:
  case Mesh_format::inp:
  case Mesh_format::msh:
  case Mesh_format::automatic: break;
  }
  return make_error(Error_code::unsupported_format,
                    "The content is not OFF, OBJ, PLY, STL or glTF; save the mesh as one of these.");
}

Result<Polygon_soup> read_polygon_soup(const std::string& path, std::uint64_t maximum_bytes,
                                       std::vector<std::string>* notes, Mesh_attributes* attributes) {
  // Non-blocking, so that a pipe without a writer does not hang before it is refused.
  const File_descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.is_open()) return unreadable(path, errno);
  struct stat status;
  if (::fstat(file.get(), &status) != 0) return unreadable(path, errno);
  if (S_ISDIR(status.st_mode)) return unreadable(path, "it is a folder");
  if (!S_ISREG(status.st_mode)) return unreadable(path, "it is not a regular file");
  const std::uint64_t size = std::uint64_t(status.st_size);
  if (size > maximum_bytes)
    return unreadable(path, "its " + std::to_string(size) + " bytes are more than the limit of " +
                                std::to_string(maximum_bytes));

  // The first bytes alone show what is refused anyway, before memory for the whole is taken.
  char head[64];
  const std::int64_t head_size =
      read_bytes(file.get(), head, std::size_t(std::min<std::uint64_t>(size, sizeof head)));
  if (head_size < 0) return unreadable(path, errno);
  const std::string extension = extension_of(path);
  const bool other = is_other_format(extension);
  if (const char* foreign = foreign_content(std::string_view(head, std::size_t(head_size)));
      foreign && !other)
    return make_error(Error_code::unsupported_format, "'" + path + "' is " + foreign + ".");
  const std::unique_ptr<char[]> data(new char[std::size_t(size) + 1]);
  std::copy(head, head + head_size, data.get());
  const std::int64_t rest =
      read_bytes(file.get(), data.get() + head_size, std::size_t(size) - std::size_t(head_size));
  if (rest < 0) return unreadable(path, errno);

  Notes ignored;
  Result<Polygon_soup> soup =
      other ? parse_by_assimp(data.get(), std::size_t(head_size + rest), extension, notes ? *notes : ignored)
            : parse_polygon_soup(data.get(), std::size_t(head_size + rest), format_of_extension(path), notes,
                                 attributes);
  if (other) note_other(attributes, "what Assimp knows beside points and faces");
  if (soup) return soup;
  Error error = soup.error();
  error.message = "'" + path + "': " + error.message;
  return error;
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
