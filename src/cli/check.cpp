// SPDX-License-Identifier: GPL-3.0-or-later
// reebquad check FILE: what is wrong with a triangle mesh, what can be mended, and what can not.
#include "Command.h"
#include "Input.h"

#include <CGAL/Reeb_quadrangulation/surface_intersections.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>
#include <iostream>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;
namespace po = boost::program_options;

namespace {

constexpr int printed_per_kind = 5;

struct Findings {
  std::vector<std::string> notes; ///< of the reader
  Surface_check check;
  Mended_surface mended;
  Surface_intersections intersections;
};

/// The method takes what is left after mending if no component had to be refused.
bool accepted(const Findings& findings) {
  return findings.mended.refused.empty() && !findings.mended.components.empty();
}

/// What `reebquad run` would say of the surface.
Exit_code outcome(const Findings& findings) {
  if (findings.mended.components.empty()) return Exit_code::not_a_surface;
  return findings.mended.refused.empty() ? Exit_code::success : Exit_code::in_part;
}

std::string verdict(const Findings& findings) {
  switch (outcome(findings)) {
  case Exit_code::success:
    // Clean is only what is taken exactly as it is.
    return findings.check.is_clean() && findings.mended.mends.empty() && findings.intersections.pairs.empty()
               ? "a clean surface"
               : "a surface that the method takes";
  case Exit_code::in_part:
    return "in part a surface that the method takes: " + std::to_string(findings.mended.components.size()) +
           (findings.mended.components.size() == 1 ? " component is taken, " : " components are taken, ") +
           std::to_string(findings.mended.refused.size()) + " refused";
  default: return "not a surface that the method takes";
  }
}

void print_json(const std::string& file, const Findings& findings) {
  nlohmann::ordered_json out;
  out["file"] = file;
  out["accepted"] = accepted(findings);
  out["in_part"] = outcome(findings) == Exit_code::in_part;
  out["notes"] = findings.notes;
  out["check"] = nlohmann::ordered_json::parse(to_json(findings.check));
  out["mends"] = nlohmann::ordered_json::array();
  for (const Mend& mend : findings.mended.mends)
    out["mends"].push_back({{"count", mend.count}, {"text", mend.text}});
  out["intersections"] = {{"within_components", findings.intersections.within},
                          {"between_components", findings.intersections.between}};
  out["refused"] = nlohmann::ordered_json::array();
  for (const Error& error : findings.mended.refused)
    out["refused"].push_back(
        {{"message", error.message}, {"element", name(error.element)}, {"index", error.index}});
  std::cout << out.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

void print_components(const Surface_check& check) {
  int number = 0;
  for (const Component_check& c : check.components) {
    std::cout << "  component " << number++ << ": " << c.vertices << " vertices, " << c.edges << " edges, "
              << c.faces << " faces, " << c.boundary_loops << " boundary loops, Euler characteristic "
              << c.euler_characteristic;
    if (c.genus() >= 0) std::cout << ", genus " << c.genus();
    std::cout << '\n';
  }
}

void print_defects(const Surface_check& check) {
  std::array<int, number_of_defect_kinds> printed{};
  for (const Defect& defect : check.defects) {
    int& number = printed[std::size_t(defect.kind)];
    if (number++ < printed_per_kind) std::cout << "  " << name(defect.kind) << ": " << defect.text << '\n';
    if (number == printed_per_kind && check.count(defect.kind) > printed_per_kind)
      std::cout << "  " << name(defect.kind) << ": ... and " << check.count(defect.kind) - printed_per_kind
                << " more (--json lists them)\n";
  }
}

void print_intersections(const Surface_intersections& found) {
  if (found.pairs.empty()) return;
  std::cout << "  self-intersections: " << found.within << " pairs of triangles within components, "
            << found.between << " between them" << (found.is_complete ? "" : " or more")
            << "; the quads will intersect there too\n";
}

void print_text(const std::string& file, const Findings& findings) {
  const Surface_check& check = findings.check;
  std::cout << file << ": " << check.points << " points, " << check.faces << " faces (" << check.triangles
            << " triangles), " << check.components.size()
            << (check.components.size() == 1 ? " component\n" : " components\n");
  for (const std::string& note : findings.notes) std::cout << "  note: " << note << '\n';
  print_components(check);
  print_defects(check);
  for (const Mend& mend : findings.mended.mends) std::cout << "  mended: " << mend.text << '\n';
  print_intersections(findings.intersections);
  for (const Error& error : findings.mended.refused) std::cout << "  refused: " << error.message << '\n';
  std::cout << verdict(findings) << '\n';
}

} // namespace

Exit_code execute_check(const Arguments& arguments) {
  Command_line line("check FILE [--json]");
  line.options.add_options()("json", "print everything as JSON")(
      "all", "list all defects, not only the first 100 of each kind (with --json)");
  declare_mending(line);
  line.take("FILE");
  if (!line.parse(arguments)) return Exit_code::success;
  const std::string file = line.required("FILE");

  Findings findings;
  const Polygon_soup soup = read_soup(file, &findings.notes);
  const Mend_options mends = mending(line);
  Check_options options;
  options.weld = mends.weld;
  if (line.has("all")) options.listed_per_kind = -1;
  findings.check = check_surface(soup, options);
  Result<Mended_surface> mended = mend_surface(soup, mends);
  if (mended)
    findings.mended = std::move(*mended);
  else
    findings.mended.refused = {mended.error()};
  findings.intersections = surface_intersections(joined(findings.mended));

  if (line.has("json"))
    print_json(file, findings);
  else
    print_text(file, findings);
  return outcome(findings);
}

} // namespace reebquad
