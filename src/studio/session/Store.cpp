// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/Store.h"

#include "view/Bounded_json.h"

#include <CGAL/Reeb_quadrangulation/IO/atomic_file.h>
#include <CGAL/Reeb_quadrangulation/IO/read_file.h>

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace reebquad {
namespace studio {

namespace fs = std::filesystem;
using CGAL::Reeb_quadrangulation::Error_code;
using CGAL::Reeb_quadrangulation::make_error;
using CGAL::Reeb_quadrangulation::read_file;
using CGAL::Reeb_quadrangulation::Symbolic_link;
using CGAL::Reeb_quadrangulation::write_file_atomically;
using CGAL::Reeb_quadrangulation::Written_link;

namespace {

constexpr int format_version = 2;
constexpr int deepest_session = 24;
constexpr std::uint64_t largest_session = std::uint64_t(64) << 20;
constexpr std::size_t most_sessions = 200; // that are looked at
constexpr std::uint64_t largest_picture = std::uint64_t(1) << 18, largest_preferences = std::uint64_t(1)
                                                                                        << 14;
const char* const picture_prefix = "picture-";
const char* const preferences_name = "preferences.json";
const char* const upload_prefix = "mesh-";
const char* const session_prefix = "session-";
const char* const session_suffix = ".json";
const char* const former_name = "session.json"; // when there was one session only

bool is_digest(const std::string& text) {
  return text.size() == 16 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

/// Throws an exception of Json where it is none of ours.
std::optional<Saved_part> part_of(const Json& json) {
  Saved_part part;
  json.at("component").get_to(part.component);
  part.edits = json.at("edits");
  part.base = json.value("base", Json(nullptr));
  json.at("applied").get_to(part.applied);
  if (part.component < 1 || !part.edits.is_array() || part.applied < 0 ||
      part.applied > int(part.edits.size()))
    return std::nullopt;
  return part;
}

/// What a folder holds survives a power failure; the folder itself only when the one around it is flushed.
void flush(const fs::path& folder) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return;
  ::fsync(file);
  ::close(file);
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

std::string to_json(const Saved_session& session) {
  Json parts = Json::array();
  for (const Saved_part& part : session.parts) {
    parts.push_back({{"component", part.component}, {"edits", part.edits}, {"applied", part.applied}});
    if (!part.base.is_null()) parts.back()["base"] = part.base;
  }
  const Json json{{"version", format_version},
                  {"name", session.name},
                  {"file", session.file},
                  {"bytes", session.bytes},
                  {"digest", session.digest},
                  {"component", session.component},
                  {"parts", parts}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<Saved_session> session_from_json(const std::string& text) {
  const Json json = parse_bounded(text, deepest_session);
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
    if (!is_digest(session.digest) || session.component < 1) return std::nullopt;
    return session;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

Store::Store(const Folder& folder) : m_user_folder(folder), m_folder(folder.path() / ".reebquad") {}

// A folder, not a link to one, and ours: what is written there, and removed, lies where the user works.
bool Store::is_trusted() const {
  struct stat status;
  return ::lstat(m_folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == ::geteuid();
}

Result<void> Store::make_folder() const {
  if (::mkdir(m_folder.c_str(), 0700) == 0)
    flush(m_user_folder.path());
  else if (errno != EEXIST)
    return make_error(Error_code::unwritable_file,
                      "the folder .reebquad, which keeps the session, cannot be made: " +
                          std::generic_category().message(errno));
  if (!is_trusted())
    return make_error(Error_code::unwritable_file, ".reebquad, which keeps the session, is a link, a file or "
                                                   "the folder of another user; it is not touched: "
                                                   "move it away");
  return {};
}

fs::path Store::upload_path(const std::string& digest) const {
  return m_folder / (upload_prefix + digest);
}

fs::path Store::session_path(const std::string& digest) const {
  return m_folder / (session_prefix + digest + session_suffix);
}

// The newest first.
std::vector<fs::path> Store::session_files() const {
  std::vector<std::pair<fs::file_time_type, fs::path>> found;
  std::error_code failed;
  if (!is_trusted()) return {};
  for (const fs::directory_entry& entry : fs::directory_iterator(m_folder, failed)) {
    const std::string leaf = entry.path().filename().string();
    const std::size_t first = std::string(session_prefix).size(), rest = std::string(session_suffix).size();
    const bool is_ours = leaf == former_name ||
                         (leaf.size() == first + 16 + rest && leaf.rfind(session_prefix, 0) == 0 &&
                          is_digest(leaf.substr(first, 16)) && leaf.substr(first + 16) == session_suffix);
    std::error_code unknown;
    if (is_ours && fs::is_regular_file(entry.symlink_status(unknown)))
      found.push_back({entry.last_write_time(unknown), entry.path()});
  }
  std::sort(found.begin(), found.end(), std::greater<>());
  std::vector<fs::path> files;
  for (std::size_t i = 0; i < std::min(found.size(), most_sessions); ++i) files.push_back(found[i].second);
  return files;
}

Result<void> Store::save(const Saved_session& session) const {
  if (Result<void> made = make_folder(); !made) return made;
  const fs::path path = session_path(session.digest);
  Result<void> written = write_file_atomically(path.string(), to_json(session), Written_link::replaced);
  if (!written) return written;
  const fs::path former = m_folder / former_name;
  const Result<std::string> text = read_file(former.string(), largest_session, Symbolic_link::refused);
  const auto old = text ? session_from_json(*text) : std::nullopt;
  std::error_code ignored;
  if (old && old->digest == session.digest) fs::remove(former, ignored);
  return {};
}

Result<void> Store::save_upload(const Saved_session& session, const std::string& bytes) const {
  if (Result<void> made = make_folder(); !made) return made;
  return write_file_atomically(upload_path(session.digest).string(), bytes, Written_link::replaced);
}

std::vector<Saved_session> Store::sessions() const {
  std::vector<Saved_session> all;
  for (const fs::path& path : session_files()) {
    const Result<std::string> text = read_file(path.string(), largest_session, Symbolic_link::refused);
    if (!text) continue;
    std::optional<Saved_session> session = session_from_json(*text);
    const auto same = [&](const Saved_session& other) { return other.digest == session->digest; };
    if (!session || std::any_of(all.begin(), all.end(), same)) continue;
    struct stat status;
    if (::lstat(path.c_str(), &status) == 0) session->saved = status.st_mtime;
    all.push_back(std::move(*session));
  }
  return all;
}

std::vector<std::string> Store::unreadable() const {
  std::vector<std::string> names;
  for (const fs::path& path : session_files()) {
    const Result<std::string> text = read_file(path.string(), largest_session, Symbolic_link::refused);
    if (!text || !session_from_json(*text)) names.push_back(".reebquad/" + path.filename().string());
  }
  return names;
}

std::optional<Saved_session> Store::load() const {
  const std::vector<Saved_session> all = sessions();
  for (const Saved_session& session : all)
    if (session.number_of_edits() > 0) return session;
  return all.empty() ? std::nullopt : std::optional<Saved_session>(all.front());
}

std::optional<Saved_session> Store::load(const std::string& wanted) const {
  for (Saved_session& session : sessions())
    if (session.digest == wanted) return std::move(session);
  return std::nullopt;
}

Result<std::string> Store::set_aside(const std::string& wanted) const {
  if (!is_trusted()) return std::string();
  const fs::path path = session_path(wanted);
  std::error_code failed;
  if (!fs::exists(fs::symlink_status(path, failed))) return std::string();
  for (int number = 1; number < 10000; ++number) {
    const std::string leaf = session_prefix + wanted + ".kept-" + std::to_string(number) + session_suffix;
    if (fs::exists(fs::symlink_status(m_folder / leaf, failed))) continue;
    fs::rename(path, m_folder / leaf, failed);
    if (!failed) return ".reebquad/" + leaf;
    break;
  }
  return make_error(Error_code::unwritable_file,
                    "the session " + path.filename().string() + " in .reebquad cannot be renamed");
}

Result<std::string> Store::load_mesh(const Saved_session& session) const {
  std::string path = upload_path(session.digest).string();
  if (!session.file.empty()) {
    Result<std::string> resolved = m_user_folder.resolve(session.file);
    if (!resolved) return resolved;
    path = *resolved;
  } else if (!is_trusted()) {
    return make_error(Error_code::unreadable_file, session.name + ": .reebquad is not a folder of yours");
  }
  Result<std::string> bytes =
      read_file(path, largest_mesh, session.file.empty() ? Symbolic_link::refused : Symbolic_link::followed);
  if (!bytes)
    return make_error(Error_code::unreadable_file, session.name + ": the mesh of the session is gone");
  if (bytes->size() != session.bytes || digest(*bytes) != session.digest)
    return make_error(Error_code::unreadable_file, session.name + ": the mesh was changed since the session");
  return bytes;
}

Result<void> Store::save_picture(const std::string& wanted, const std::string& picture) const {
  if (!is_digest(wanted) || picture.size() > largest_picture || picture.rfind("data:image/", 0) != 0)
    return make_error(Error_code::impossible_request, "this is no small picture of a session");
  if (Result<void> made = make_folder(); !made) return made;
  return write_file_atomically((m_folder / (picture_prefix + wanted)).string(), picture,
                               Written_link::replaced);
}

std::string Store::picture(const std::string& wanted) const {
  if (!is_trusted() || !is_digest(wanted)) return "";
  Result<std::string> text =
      read_file((m_folder / (picture_prefix + wanted)).string(), largest_picture, Symbolic_link::refused);
  return text && text->rfind("data:image/", 0) == 0 ? *text : "";
}

Result<void> Store::save_preferences(const Json& preferences) const {
  const std::string text = preferences.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
  if (!preferences.is_object() || text.size() > largest_preferences)
    return make_error(Error_code::impossible_request, "these are no preferences");
  if (Result<void> made = make_folder(); !made) return made;
  return write_file_atomically((m_folder / preferences_name).string(), text, Written_link::replaced);
}

Json Store::preferences() const {
  if (!is_trusted()) return Json::object();
  const Result<std::string> text =
      read_file((m_folder / preferences_name).string(), largest_preferences, Symbolic_link::refused);
  const Json json = text ? parse_bounded(*text, 4) : Json();
  return json.is_object() ? json : Json::object();
}

void Store::forget(const std::string& wanted) const {
  if (!is_trusted() || !is_digest(wanted)) return;
  std::error_code ignored;
  fs::remove(session_path(wanted), ignored);
  const fs::path former = m_folder / former_name;
  const Result<std::string> text = read_file(former.string(), largest_session, Symbolic_link::refused);
  if (const auto old = text ? session_from_json(*text) : std::nullopt; old && old->digest == wanted)
    fs::remove(former, ignored);
  fs::remove(upload_path(wanted), ignored);
  fs::remove(m_folder / (picture_prefix + wanted), ignored);
}

} // namespace studio
} // namespace reebquad
