// SPDX-License-Identifier: GPL-3.0-or-later
#include "server/Request.h"

#include "view/Bounded_json.h"

#include <array>

namespace reebquad {
namespace studio {

using CGAL::Reeb_quadrangulation::Error_code;
using CGAL::Reeb_quadrangulation::make_error;
using CGAL::Reeb_quadrangulation::Result;

namespace {

constexpr int deepest_nesting = 16;

/// A member that a command must have.
struct Member {
  const char* name; ///< null: none
  Json::value_t type;
};

struct Command_row {
  const char* name;
  Command command;
  Member member;
};

constexpr Member none{nullptr, Json::value_t::null};
constexpr std::array commands{
    Command_row{"list_files", Command::list_files, none},
    Command_row{"open_file", Command::open_file, {"name", Json::value_t::string}},
    Command_row{"open_recipe", Command::open_recipe, {"name", Json::value_t::string}},
    Command_row{"component", Command::component, {"component", Json::value_t::number_integer}},
    Command_row{"restore", Command::restore, none},
    Command_row{"forget", Command::forget, none},
    Command_row{"keep_picture", Command::keep_picture, {"picture", Json::value_t::string}},
    Command_row{"prefer", Command::prefer, {"preferences", Json::value_t::object}},
    Command_row{"edit", Command::edit, {"edit", Json::value_t::object}},
    Command_row{"preview", Command::preview, {"edit", Json::value_t::object}},
    Command_row{"offer", Command::offer, {"edit", Json::value_t::object}},
    Command_row{"hints", Command::hints, none},
    Command_row{"undo", Command::undo, none},
    Command_row{"redo", Command::redo, none},
    Command_row{"go_to", Command::go_to, {"step", Json::value_t::number_integer}},
    Command_row{"cancel", Command::cancel, none},
    Command_row{"cancel_drag", Command::cancel_drag, {"drag", Json::value_t::number_integer}},
    Command_row{"chart", Command::chart, {"chart", Json::value_t::number_integer}},
    Command_row{"deviation", Command::deviation, none},
    Command_row{"certify", Command::certify, none},
    Command_row{"save_recipe", Command::save_recipe, {"name", Json::value_t::string}},
    Command_row{"export", Command::export_quads, {"name", Json::value_t::string}},
};

bool has_type(const Json& value, Json::value_t type) {
  return type == Json::value_t::number_integer ? value.is_number_integer() : value.type() == type;
}

CGAL::Reeb_quadrangulation::Error malformed(const std::string& sentence) {
  return make_error(Error_code::malformed_file, sentence);
}

} // namespace

Result<Request> parse_request(std::string_view text) {
  if (text.size() > longest_request) return malformed("the message is longer than 1 MiB");
  bool too_deep = false;
  Json body = parse_bounded(text, deepest_nesting, &too_deep);
  if (too_deep) return malformed("the message is nested too deeply");
  if (body.is_discarded() || !body.is_object()) return malformed("the message is not a JSON object");
  const auto id = body.find("id");
  if (id == body.end() || !id->is_number_integer() || *id < 0 || *id > std::int64_t(1) << 53)
    return malformed("the message has no id");
  const auto name = body.find("command");
  if (name == body.end() || !name->is_string()) return malformed("the message has no command");
  for (const Command_row& row : commands) {
    if (*name != row.name) continue;
    if (row.member.name) {
      const auto member = body.find(row.member.name);
      if (member == body.end() || !has_type(*member, row.member.type))
        return malformed(std::string("the command ") + row.name + " needs '" + row.member.name + "'");
    }
    Request request;
    request.id = id->get<std::int64_t>();
    request.command = row.command;
    request.body = std::move(body);
    return request;
  }
  return malformed("there is no command of that name");
}

std::int64_t request_id(std::string_view text) {
  const Json body = parse_bounded(text, deepest_nesting);
  if (!body.is_object()) return -1;
  const auto id = body.find("id");
  return id != body.end() && id->is_number_integer() ? id->get<std::int64_t>() : -1;
}

} // namespace studio
} // namespace reebquad
