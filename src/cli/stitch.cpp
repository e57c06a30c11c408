// SPDX-License-Identifier: GPL-3.0-or-later
// reebquad stitch PATCHES... -o OUT: one mesh of quads of patches that were made elsewhere.
#include "Command.h"
#include "Input.h"
#include "Interruption.h"
#include "Outputs.h"
#include "Stitching.h"
#include "Terminal_observer.h"

#include <CGAL/Reeb_quadrangulation/IO/atomic_file.h>
#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>
#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>
#include <CGAL/Reeb_quadrangulation/picture_scene.h>
#include <CGAL/Reeb_quadrangulation/render.h>
#include <CGAL/Reeb_quadrangulation/surface_as_read.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>
#include <optional>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;
namespace po = boost::program_options;
using Json = nlohmann::ordered_json;

namespace {

struct Stitch_request {
  std::vector<std::string> files;
  std::string output, report, picture, surface;
  Stitch_patches_options options;
  bool strict = false, validate = false, quiet = false;
};

double number_in(const Command_line& line, const char* option, double low, double high) {
  const double value = line.values[option].as<double>();
  if (!(value >= low && value <= high))
    throw Usage_error(std::string("--") + option + " is out of range; see reebquad stitch --help");
  return value;
}

void declare_stitch_options(Command_line& line) {
  const auto text = [](const char* name) { return po::value<std::string>()->value_name(name); };
  line.options.add_options()                      //
      ("output,o", text("FILE"), "the quad mesh") //
      ("surface", text("FILE"),
       "the triangle surface that the patches stand for: all vertices are relaxed on it, and the certificate "
       "compares with it")                                                                       //
      ("open", "rims that meet no other stay as the boundary; without it the result must close") //
      ("alpha", po::value<double>()->value_name("A")->default_value(0.25),
       "vertices of two rims merge if they lie nearer than A times their distance to their neighbours on the "
       "rims, 0.01 to 0.5") //
      ("turn-cost", po::value<double>()->value_name("N")->default_value(4),
       "how many quads a line of new edges may rather cross than turn, which makes extraordinary vertices") //
      ("no-relax", "leave new vertices where the quads that they split have them")                          //
      ("report", text("FILE"), "write all numbers as JSON")                                                 //
      ("picture", text("FILE"), "draw the patches of the result as PNG")                                    //
      ("validate",
       "demand strict validity: also no inverted quad, and no self-intersection but the surface's own") //
      ("strict", "warnings about the shape fail: nothing is written, and the end is with 5")            //
      ("quiet", "print errors only");
  declare_force(line);
  line.hidden.add_options()("PATCHES", po::value<std::vector<std::string>>());
  line.positional.add("PATCHES", -1);
}

std::optional<Stitch_request> parse_stitch_options(const Arguments& arguments) {
  Command_line line("stitch PATCHES... -o OUT [--surface INPUT] [--open] [--report FILE]\n"
                    "PATCHES: all-quad meshes with boundaries, in one file or in several");
  declare_stitch_options(line);
  if (!line.parse(arguments)) return std::nullopt;
  if (!line.has("PATCHES")) throw Usage_error("PATCHES is missing\nUsage: reebquad " + line.usage);
  Stitch_request request;
  request.files = line.values["PATCHES"].as<std::vector<std::string>>();
  request.output = line.required("output");
  require_writable_format(request.output);
  if (line.has("report")) request.report = line.text("report");
  if (line.has("picture")) request.picture = line.text("picture");
  if (line.has("surface")) request.surface = line.text("surface");
  std::vector<std::string> inputs = request.files;
  inputs.push_back(request.surface);
  keep_inputs(line, {inputs, {request.output, request.report, request.picture}, ""});
  request.options.alpha = number_in(line, "alpha", 0.01, 0.5);
  request.options.t_junctions.turn_cost = number_in(line, "turn-cost", 0, 1e6);
  request.options.may_stay_open = line.has("open");
  if (!request.surface.empty()) request.options.relaxation = Stitch_relaxation::all;
  if (line.has("no-relax")) request.options.relaxation = Stitch_relaxation::none;
  request.strict = line.has("strict");
  request.validate = line.has("validate");
  request.quiet = line.has("quiet");
  return request;
}

Json patches_json(const Patch_files& patches, const Stitched_patches& stitched) {
  std::vector<int> quads(stitched.turned.size(), 0);
  for (int p : stitched.patch_of_quad) ++quads[std::size_t(p)];
  Json list = Json::array();
  for (std::size_t p = 0; p < patches.patches.size(); ++p)
    list.push_back({{"file", patches.files[patches.patches[p].file]},
                    {"number", patches.patches[p].number},
                    {"quads_before", patches.patches[p].quads},
                    {"quads", quads[p]},
                    {"turned", stitched.turned[p] != 0}});
  return list;
}

std::string report_json(const Stitch_request& request, const Patch_files& patches,
                        const Stitched_patches& stitched, const Certificate& certificate,
                        const Mesh_statistics& statistics, Exit_code status) {
  Json out;
  out["schema"] = 1;
  out["version"] = REEBQUAD_VERSION;
  out["status"] = static_cast<int>(status);
  out["output"] = status == Exit_code::success ? Json(request.output) : Json(nullptr);
  out["patches"] = patches_json(patches, stitched);
  out["stitching"] = stitching_json(stitched);
  out["certificate"] = Json::parse(to_json(certificate));
  out["statistics"] = Json::parse(to_json(statistics));
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

// What a result is certified against: the surface, or the number of rims that stay open.
struct Against {
  std::optional<Triangle_surface> surface, as_read;
  std::optional<Surface_projector> projector;
};

void read_surface(const std::string& file, Against& against) {
  const Polygon_soup soup = read_soup(file);
  against.surface = joined(value_or_fail(mend_surface(soup), file));
  succeed_or_fail(against.surface->connect(), file);
  against.as_read = surface_as_read(soup);
  against.projector.emplace(*against.surface);
}

Exit_code finish(const Stitch_request& request, const Patch_files& patches, const Stitched_patches& stitched,
                 const Against& against) {
  Certificate_input input{stitched.mesh};
  if (against.surface) {
    input.input = &*against.surface;
    input.as_read = &*against.as_read;
  } else if (request.options.may_stay_open)
    input.predicted_components = stitched.components;
  const Certificate certificate = certify(input);
  Mesh_statistics statistics = quad_statistics(stitched.mesh);
  if (certificate.shape) add_shape(statistics, *certificate.shape);
  if (interrupted()) return Exit_code::interrupted;
  if (!request.quiet)
    std::cout << stitching_text(stitched) << '\n' << to_text(certificate) << '\n' << to_text(statistics);
  const bool good = request.validate ? certificate.valid_as_input : certificate.passed;
  const bool warned = request.strict && !certificate.warnings.empty();
  const Exit_code status = good && !warned ? Exit_code::success : Exit_code::certificate_failed;
  const Uninterruptible whole;
  if (status == Exit_code::success) {
    if (!request.picture.empty())
      succeed_or_fail(
          write_png(contact_sheet(patch_scene(stitched.mesh, stitched.patch_of_quad), Up_axis::z, 1600, 1200),
                    request.picture),
          request.picture);
    for (const std::string& warning :
         value_or_fail(write_mesh(request.output, stitched.mesh), request.output))
      std::cerr << "reebquad: " << request.output << ": " << warning << '\n';
  } else
    std::cerr << "reebquad: the certificate failed" << (good ? " by a warning" : "")
              << "; nothing is written to " << request.output << '\n';
  if (!request.report.empty())
    succeed_or_fail(write_file_atomically(request.report, report_json(request, patches, stitched, certificate,
                                                                      statistics, status)),
                    request.report);
  return status;
}

} // namespace

Exit_code execute_stitch(const Arguments& arguments) {
  const std::optional<Stitch_request> request = parse_stitch_options(arguments);
  if (!request) return Exit_code::success;
  watch_for_interruption();
  const Patch_files patches = read_patches(request->files);
  Against against;
  if (!request->surface.empty()) read_surface(request->surface, against);
  Stitch_patches_options options = request->options;
  // The rims of a surface that is open are the patches' too.
  if (against.surface && !boundary_loops(*against.surface).empty()) options.may_stay_open = true;
  const Stitched_patches stitched = stitched_or_fail(
      stitch_patches(patches.mesh, options, against.projector ? &*against.projector : nullptr), patches);
  if (interrupted()) return Exit_code::interrupted;
  return finish(*request, patches, stitched, against);
}

} // namespace reebquad
