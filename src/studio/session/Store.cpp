// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/Store.h"

#include <CGAL/Reeb_quadrangulation/IO/atomic_file.h>
#include <CGAL/Reeb_quadrangulation/IO/read_file.h>

namespace reebquad {
namespace studio {

namespace fs = std::filesystem;
using CGAL::Reeb_quadrangulation::Error_code;
using CGAL::Reeb_quadrangulation::make_error;
using CGAL::Reeb_quadrangulation::write_file_atomically;

namespace {

constexpr int format_version = 2;
constexpr std::uint64_t largest_session = std::uint64_t(64) << 20;
constexpr std::uint64_t largest_mesh = std::uint64_t(4) << 30;
const char* const upload_prefix = "mesh-";

/// Throws an exception of Json where it is none of ours.
std::optional<Saved_part> part_of(const Json& json) {
  Saved_part part;
  json.at("component").get_to(part.component);
  part.edits = json.at("edits");
  json.at("applied").get_to(part.applied);
  if (part.component < 1 || !part.edits.is_array() || part.applied < 0 ||
      part.applied > int(part.edits.size()))
    return std::nullopt;
  return part;
}

} // namespace

std::size_t Saved_session::number_of_edits() const {
  std::size_t number = 0;
  for (const Saved_part& part : parts) number += part.edits.size();
  return number;
}

std::string digest(const std::string& bytes) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4) text += "0123456789abcdef"[hash >> shift & 15];
  return text;
}

Result<std::string> read_regular_file(const std::string& path, std::uint64_t limit) {
  std::error_code failed;
  if (!fs::is_regular_file(path, failed))
    return make_error(Error_code::unreadable_file, "the file cannot be read");
  return CGAL::Reeb_quadrangulation::read_file(path, limit);
}

Store::Store(const Folder& folder) : m_user_folder(folder), m_folder(folder.path() / ".reebquad") {}

Result<void> Store::make_folder() const {
  std::error_code failed;
  fs::create_directories(m_folder, failed);
  if (failed || !fs::is_directory(m_folder))
    return make_error(Error_code::unwritable_file,
                      "the folder .reebquad, which keeps the session, cannot be made");
  fs::permissions(m_folder, fs::perms::owner_all, failed);
  return {};
}

fs::path Store::upload_path(const Saved_session& session) const {
  return m_folder / (upload_prefix + session.digest);
}

Result<void> Store::save(const Saved_session& session) const {
  if (Result<void> made = make_folder(); !made) return made;
  Json parts = Json::array();
  for (const Saved_part& part : session.parts)
    parts.push_back({{"component", part.component}, {"edits", part.edits}, {"applied", part.applied}});
  const Json json{{"version", format_version},
                  {"name", session.name},
                  {"file", session.file},
                  {"bytes", session.bytes},
                  {"digest", session.digest},
                  {"component", session.component},
                  {"parts", parts}};
  Result<void> written = write_file_atomically(
      (m_folder / "session.json").string(), json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
  if (!written) return written;
  // Only now nothing refers to the uploads of earlier sessions any more.
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(m_folder, ignored)) {
    const std::string leaf = entry.path().filename().string();
    const bool is_upload = leaf.rfind(upload_prefix, 0) == 0;
    if (is_upload && (!session.file.empty() || entry.path() != upload_path(session)))
      fs::remove(entry.path(), ignored);
  }
  return {};
}

Result<void> Store::save_upload(const Saved_session& session, const std::string& bytes) const {
  if (Result<void> made = make_folder(); !made) return made;
  return write_file_atomically(upload_path(session).string(), bytes);
}

std::optional<Saved_session> Store::load() const {
  Result<std::string> text = read_regular_file((m_folder / "session.json").string(), largest_session);
  if (!text) return std::nullopt;
  const Json json = Json::parse(*text, nullptr, false);
  try {
    if (json.at("version") != format_version) return std::nullopt;
    Saved_session session;
    json.at("name").get_to(session.name);
    json.at("file").get_to(session.file);
    json.at("bytes").get_to(session.bytes);
    json.at("digest").get_to(session.digest);
    json.at("component").get_to(session.component);
    if (!json.at("parts").is_array()) return std::nullopt;
    for (const Json& entry : json.at("parts")) {
      std::optional<Saved_part> part = part_of(entry);
      if (!part) return std::nullopt;
      session.parts.push_back(std::move(*part));
    }
    const bool is_digest = session.digest.size() == 16 &&
                           session.digest.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!is_digest || session.component < 1) return std::nullopt;
    return session;
  } catch (const Json::exception&) {
    return std::nullopt; // not a session of ours: as if there were none
  }
}

Result<std::string> Store::load_mesh(const Saved_session& session) const {
  std::string path = upload_path(session).string();
  if (!session.file.empty()) {
    Result<std::string> resolved = m_user_folder.resolve(session.file);
    if (!resolved) return resolved;
    path = *resolved;
  }
  Result<std::string> bytes = read_regular_file(path, largest_mesh);
  if (!bytes)
    return make_error(Error_code::unreadable_file, session.name + ": the mesh of the last session is gone");
  if (bytes->size() != session.bytes || digest(*bytes) != session.digest)
    return make_error(Error_code::unreadable_file,
                      session.name + ": the mesh was changed since the last session");
  return bytes;
}

void Store::forget() const {
  std::error_code ignored;
  fs::remove(m_folder / "session.json", ignored);
}

} // namespace studio
} // namespace reebquad
