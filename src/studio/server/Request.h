// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SERVER_REQUEST_H
#define REEBQUAD_SERVER_REQUEST_H

#include "view/Json.h"

#include <CGAL/Reeb_quadrangulation/Result.h>

#include <string>
#include <string_view>

namespace reebquad {
namespace studio {

/// What the page asks for.
enum class Command {
  list_files,
  open_file,
  open_recipe,
  component,
  restore,
  forget,
  keep_picture,
  prefer,
  edit,
  preview,
  offer,
  hints,
  undo,
  redo,
  go_to,
  cancel,
  cancel_drag,
  chart,
  deviation,
  certify,
  save_recipe,
  export_quads
};

/// A message of the page, checked as far as that needs no mesh.
struct Request {
  std::int64_t id = 0; ///< chosen by the page; the reply repeats it
  Command command = Command::cancel;
  Json body; ///< the whole message
};

/// The longest text message that is read, in bytes.
constexpr std::size_t longest_request = std::size_t(1) << 20;

/// Parses a message. Fails with `malformed_file` and a sentence where it is not what the protocol describes:
/// no JSON object, nested too deeply, no id, an unknown command, a member of the wrong type, a number that is
/// not finite.
CGAL::Reeb_quadrangulation::Result<Request> parse_request(std::string_view text);

/// The id of a message that could not be parsed as a request, if it can be found; else -1.
std::int64_t request_id(std::string_view text);

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_SERVER_REQUEST_H
