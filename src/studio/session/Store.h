// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SESSION_STORE_H
#define REEBQUAD_SESSION_STORE_H

#include "session/Folder.h"
#include "view/Json.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace reebquad {
namespace studio {

/// Files of meshes are read up to this size, in bytes.
constexpr std::uint64_t largest_mesh = std::uint64_t(4) << 30;

/// What was done to one connected component of a mesh.
struct Saved_part {
  int component = 1; ///< counted from 1
  Json edits = Json::array();
  int applied = 0;     ///< the first so many edits are applied, the others can be redone
  Json base = nullptr; ///< of a recipe that was opened here: all but its edits
};

/// A design as it is kept on disk: where the mesh is, and what was done to it.
struct Saved_session {
  std::string name;              ///< as the page shows it
  std::string file;              ///< in the user's folder; empty if the mesh was uploaded
  std::uint64_t bytes = 0;       ///< of the mesh file
  std::string digest;            ///< of its bytes
  std::vector<Saved_part> parts; ///< those with edits, by increasing component
  int component = 1;             ///< that is worked on
  std::int64_t saved = 0;        ///< when its file was written, in seconds since 1970; read only
  std::size_t number_of_edits() const;
};

/// Keeps one session for each mesh in the folder `.reebquad` of the user's folder, as `session-DIGEST.json`,
/// so that nothing is lost whenever the process ends: every file is written whole or not at all, and a mesh
/// before what refers to it. A session is replaced by later ones of the same mesh only; one that cannot be
/// read, as that of a later program, never.
///
/// The folder may come from anyone, in an archive say: if it is a link or another user's it is not used, and
/// links in it are not followed.
class Store {
public:
  explicit Store(const Folder& folder);

  Result<void> save(const Saved_session& session) const;
  /// Keeps the bytes of a mesh that is not in the user's folder. Call it before `save()`.
  Result<void> save_upload(const Saved_session& session, const std::string& bytes) const;
  /// The sessions that can be read, the newest first.
  std::vector<Saved_session> sessions() const;
  /// The newest one that has edits, or the newest; nothing if there is none.
  std::optional<Saved_session> load() const;
  /// That of the mesh with this digest.
  std::optional<Saved_session> load(const std::string& digest) const;
  /// The names of the files of sessions that cannot be read: damaged, or of another version.
  std::vector<std::string> unreadable() const;
  /// Renames the file of a session, so that no other takes its place; the new name, relative to the user's
  /// folder. Empty if there is no such file.
  Result<std::string> set_aside(const std::string& digest) const;
  /// The bytes of its mesh. Fails with `unreadable_file` if they are gone or were changed since.
  Result<std::string> load_mesh(const Saved_session& session) const;
  /// \name What pages keep
  /// A small picture of a session as the text of a `data:` address, and what a user prefers.
  /// @{
  Result<void> save_picture(const std::string& digest, const std::string& picture) const;
  /// Empty if there is none.
  std::string picture(const std::string& digest) const;
  Result<void> save_preferences(const Json& preferences) const;
  /// An object; empty if nothing is kept.
  Json preferences() const;
  /// @}
  /// Removes a session with its picture and, if it was uploaded, its mesh.
  void forget(const std::string& digest) const;

private:
  bool is_trusted() const;
  Result<void> make_folder() const;
  std::filesystem::path upload_path(const std::string& digest) const;
  std::filesystem::path session_path(const std::string& digest) const;
  std::vector<std::filesystem::path> session_files() const;

  Folder m_user_folder;
  std::filesystem::path m_folder;
};

/// 16 hexadecimal digits that tell whether bytes are still the same (FNV-1a; it keeps out accidents, not
/// malice).
std::string digest(const std::string& bytes);

/// A session from the text of its file; nothing if it is none of this version, or nested deeper than any
/// session.
std::optional<Saved_session> session_from_json(const std::string& text);
std::string to_json(const Saved_session& session);

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_SESSION_STORE_H
