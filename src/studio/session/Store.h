// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SESSION_STORE_H
#define REEBQUAD_SESSION_STORE_H

#include "session/Folder.h"
#include "view/Json.h"

#include <optional>
#include <vector>

namespace reebquad {
namespace studio {

/// What was done to one connected component of a mesh.
struct Saved_part {
  int component = 1; ///< counted from 1
  Json edits = Json::array();
  int applied = 0; ///< the first so many edits are applied, the others can be redone
};

/// A design as it is kept on disk: where the mesh is, and what was done to it.
struct Saved_session {
  std::string name;              ///< as the page shows it
  std::string file;              ///< in the user's folder; empty if the mesh was uploaded
  std::uint64_t bytes = 0;       ///< of the mesh file
  std::string digest;            ///< of its bytes
  std::vector<Saved_part> parts; ///< those with edits, by increasing component
  int component = 1;             ///< that is worked on
  std::size_t number_of_edits() const;
};

/// Keeps the session in the folder `.reebquad` of the user's folder, so that nothing is lost whenever the process ends:
/// every file is written whole or not at all, and the mesh before what refers to it.
class Store {
public:
  explicit Store(const Folder& folder);

  Result<void> save(const Saved_session& session) const;
  /// Keeps the bytes of a mesh that is not in the user's folder. Call it before `save()`.
  Result<void> save_upload(const Saved_session& session, const std::string& bytes) const;
  /// The session of the last time; nothing if there is none or it is damaged.
  std::optional<Saved_session> load() const;
  /// The bytes of its mesh. Fails with `unreadable_file` if they are gone or were changed since.
  Result<std::string> load_mesh(const Saved_session& session) const;
  void forget() const;

private:
  Result<void> make_folder() const;
  std::filesystem::path upload_path(const Saved_session& session) const;

  Folder m_user_folder;
  std::filesystem::path m_folder;
};

/// 16 hexadecimal digits that tell whether bytes are still the same (FNV-1a; it keeps out accidents, not malice).
std::string digest(const std::string& bytes);

/// The bytes of a regular file of at most `limit` bytes: nothing that whoever reads might wait for. Fails with `unreadable_file`.
Result<std::string> read_regular_file(const std::string& path, std::uint64_t limit);

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_SESSION_STORE_H
