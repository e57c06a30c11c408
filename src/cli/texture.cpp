// SPDX-License-Identifier: GPL-3.0-or-later
// reebquad texture QUADS --on INPUT: edits patches of a quad mesh of any origin, which stays as it is everywhere else.
#include "Command.h"
#include "Input.h"
#include "Interruption.h"

#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>
#include <CGAL/Reeb_quadrangulation/base_domain.h>
#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>
#include <CGAL/Reeb_quadrangulation/picture_scene.h>
#include <CGAL/Reeb_quadrangulation/render.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <locale>
#include <sstream>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;
namespace po = boost::program_options;

namespace {

struct Texture_options {
  std::string quads, input, output, pictures;
  std::vector<std::string> operations;
  Base_cut cut = Base_cut::separatrices;
  bool relax = true;
  bool quiet = false;
};

// The lines of a file that hold something beside a comment.
std::vector<std::string> read_lines(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw Failure(Exit_code::unreadable_file, file + ": the file cannot be read");
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    line.erase(std::min(line.find('#'), line.size()));
    if (line.find_first_not_of(" \t\r") != std::string::npos) lines.push_back(line);
  }
  return lines;
}

std::optional<Texture_options> parse_texture_options(const Arguments& arguments) {
  const auto text = [](const char* name) { return po::value<std::string>()->value_name(name); };
  Command_line line(
      "texture QUADS --on INPUT [-o OUT] [--op \"NAME x,y,z ... [at=F]\" ...]\n"
      "Operators: subdivide_texture, coarsen_texture, insert_polychord, delete_polychord, inset_quads, "
      "open_quad,\n"
      "close_quad, rotate_edge, rotate_vertex, insert_doublet, remove_doublet, delete_quads, restore_quads,\n"
      "move_vertices FROM TO, relax_vertices. Points name the quad, edge or vertex that is nearest");
  line.options.add_options()("on", text("INPUT"), "the triangle surface that the quads stand for")(
      "output,o", text("FILE"), "the edited quad mesh")(
      "op", po::value<std::vector<std::string>>()->composing()->value_name("EDIT"),
      "an edit of the patch at its points (repeatable)")("ops", text("FILE"),
                                                         "such edits, one a line, before those of --op")(
      "cut", text("WHERE")->default_value("separatrices"),
      "the patches: between separatrices (the base complex), or every quad: everywhere")(
      "pictures", text("DIR"), "write pictures of the patches and of the result into this folder")(
      "no-relax", "do not relax the new vertices")("quiet", "print errors only");
  line.take("QUADS");
  if (!line.parse(arguments)) return std::nullopt;
  Texture_options options;
  options.quads = line.required("QUADS");
  options.input = line.required("on");
  if (line.has("output")) options.output = line.text("output");
  if (line.has("pictures")) options.pictures = line.text("pictures");
  if (line.has("ops")) options.operations = read_lines(line.text("ops"));
  if (line.has("op"))
    for (const std::string& edit : line.values["op"].as<std::vector<std::string>>())
      options.operations.push_back(edit);
  if (line.text("cut") != "separatrices" && line.text("cut") != "everywhere")
    throw Usage_error("--cut is one of separatrices, everywhere; it got '" + line.text("cut") + "'");
  if (line.text("cut") == "everywhere") options.cut = Base_cut::everywhere;
  if (options.output.empty() && !options.operations.empty())
    throw Usage_error("edits are given, but no file to write: -o FILE");
  options.relax = !line.has("no-relax");
  options.quiet = line.has("quiet");
  return options;
}

// "NAME x,y,z ... [at=F]"
struct Operation {
  std::string text, name;
  std::vector<Point> points;
  double at = 0.5;
};

Operation parse_operation(const std::string& text) {
  const auto fail = [&](const std::string& why) { return Usage_error("the edit '" + text + "': " + why); };
  std::istringstream words(text);
  Operation out;
  out.text = text;
  if (!(words >> out.name)) throw fail("it is empty");
  for (std::string word; words >> word;) {
    const bool fraction = word.rfind("at=", 0) == 0;
    std::string numbers = fraction ? word.substr(3) : word;
    for (char& c : numbers)
      if (c == ',') c = ' ';
    std::istringstream stream(numbers);
    stream.imbue(std::locale::classic());
    Point p = Point::Zero();
    const bool read = fraction ? bool(stream >> out.at) : bool(stream >> p.x() >> p.y() >> p.z());
    if (!read || !(stream >> std::ws).eof() || !p.allFinite())
      throw fail("'" + word + "' is neither a point x,y,z nor at=FRACTION");
    if (!fraction) out.points.push_back(p);
  }
  return out;
}

Texture_edit texture_edit(const Operation& o, const std::vector<Texture_place>& p) {
  using Make = std::function<Texture_edit()>;
  struct Entry {
    const char* name;
    std::size_t least, most; ///< points
    Make make;
  };
  const std::size_t any = 1000000;
  const std::vector<Entry> table{{"subdivide_texture", 1, 1, [&] { return Subdivide_texture{}; }},
                                 {"coarsen_texture", 1, 1, [&] { return Coarsen_texture{}; }},
                                 {"insert_polychord", 1, 1,
                                  [&] {
                                    return Insert_polychord{p[0], o.at};
                                  }},
                                 {"delete_polychord", 1, 1,
                                  [&] {
                                    return Delete_polychord{p[0], o.at};
                                  }},
                                 {"inset_quads", 1, any,
                                  [&] {
                                    return Inset_quads{p, o.at};
                                  }},
                                 {"open_quad", 2, 2,
                                  [&] {
                                    return Open_quad{p[0], p[1], o.at};
                                  }},
                                 {"close_quad", 1, 1,
                                  [&] {
                                    return Close_quad{p[0], o.at};
                                  }},
                                 {"rotate_edge", 1, 1, [&] { return Rotate_edge{p[0]}; }},
                                 {"rotate_vertex", 1, 1, [&] { return Rotate_vertex{p[0]}; }},
                                 {"insert_doublet", 1, 1, [&] { return Insert_doublet{p[0]}; }},
                                 {"remove_doublet", 1, 1, [&] { return Remove_doublet{p[0]}; }},
                                 {"delete_quads", 1, any, [&] { return Delete_quads{p}; }},
                                 {"restore_quads", 1, any, [&] { return Restore_quads{p}; }},
                                 {"move_vertices", 2, 2,
                                  [&] {
                                    Move_vertices move;
                                    move.vertices = {p[0]};
                                    move.dv = p[1].v - p[0].v;
                                    move.du = p[1].u - p[0].u;
                                    move.steps = 3;
                                    return move;
                                  }},
                                 {"relax_vertices", 1, 1, [&] { return Relax_vertices{}; }}};
  for (const Entry& entry : table) {
    if (o.name != entry.name) continue;
    if (p.size() < entry.least || p.size() > entry.most)
      throw Usage_error("the edit '" + o.text + "': it takes " + std::to_string(entry.least) +
                        (entry.most == any ? " or more points"
                         : entry.most == 1 ? " point"
                                           : " points"));
    return entry.make();
  }
  throw Usage_error("the edit '" + o.text + "': there is no operator '" + o.name + "'");
}

void apply(const Operation& operation, const Base_domain& domain, const Base_locator& locator,
           std::map<int, Patch_texture>& textures) {
  int patch = -1;
  std::vector<Texture_place> places;
  for (const Point& point : operation.points) {
    const Base_locator::Place place = locator.locate(point);
    if (patch >= 0 && place.patch != patch)
      throw Failure(Exit_code::usage,
                    "the edit '" + operation.text + "': its points lie in different patches");
    patch = place.patch;
    places.push_back({place.v, place.u});
  }
  const Texture_edit edit = texture_edit(operation, places);
  const auto entry = textures.try_emplace(patch, patch_texture(domain.patches[patch])).first;
  Result<Patch_texture> edited = edit_texture(entry->second, edit);
  if (!edited)
    throw Failure(exit_code(edited.error().code),
                  "the edit '" + operation.text + "' does not apply: " + edited.error().message);
  entry->second = std::move(*edited);
}

// Patches in colours that neighbours do not share.
Scene patch_scene(const Quad_mesh& mesh, const std::vector<int>& patch_of_quad) {
  Triangle_surface halves;
  std::vector<int> region;
  halves.points = mesh.points;
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
    const Quad& v = mesh.quads[q];
    halves.triangles.push_back({v[0], v[1], v[2]});
    halves.triangles.push_back({v[0], v[2], v[3]});
    region.insert(region.end(), 2, patch_of_quad[q]);
  }
  const Scene coloured = face_colour_scene(halves, region);
  Scene scene = quad_scene(mesh);
  scene.face_colours.clear();
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
    scene.face_colours.push_back(coloured.face_colours[2 * q]);
  return scene;
}

void write_picture(const Scene& scene, const std::string& folder, const std::string& file) {
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  const std::string path = (std::filesystem::path(folder) / file).string();
  succeed_or_fail(write_png(contact_sheet(scene, Up_axis::z, 1600, 1200), path), path);
}

} // namespace

Exit_code execute_texture(const Arguments& arguments) {
  const std::optional<Texture_options> options = parse_texture_options(arguments);
  if (!options) return Exit_code::success;
  if (!options->output.empty()) require_writable_format(options->output);
  watch_for_interruption();
  const Quad_mesh quads = quads_of(read_soup(options->quads), options->quads);
  Triangle_surface surface = joined(value_or_fail(mend_surface(read_soup(options->input)), options->input));
  succeed_or_fail(surface.connect(), options->input);
  const Base_domain domain = value_or_fail(base_domain(quads, options->cut), options->quads);
  if (!options->quiet)
    std::cout << options->quads << ": " << quads.quads.size() << " quads in " << domain.patches.size()
              << " patches\n";
  if (!options->pictures.empty())
    write_picture(patch_scene(quads, domain.patch_of_quad), options->pictures, "patches.png");
  if (options->output.empty()) return Exit_code::success;

  const Base_locator locator(quads, domain);
  std::map<int, Patch_texture> textures;
  for (const std::string& text : options->operations) apply(parse_operation(text), domain, locator, textures);
  Relax_options relaxation;
  if (!options->relax) relaxation = {0, false, 1, 0};
  const Textured_base result = value_or_fail(
      apply_textures(quads, domain, textures, Surface_projector(surface), relaxation), options->quads);
  if (interrupted()) return Exit_code::interrupted;
  const Certificate certificate = certify({result.mesh, &surface});
  if (!options->quiet)
    std::cout << to_text(certificate) << '\n' << to_text(quad_statistics(result.mesh, &surface));
  if (!certificate.passed) {
    std::cerr << "reebquad: the certificate failed; nothing is written to " << options->output << '\n';
    return Exit_code::certificate_failed;
  }
  if (!options->pictures.empty())
    write_picture(patch_scene(result.mesh, result.patch_of_quad), options->pictures, "quads.png");
  const Uninterruptible whole;
  for (const std::string& warning : value_or_fail(write_mesh(options->output, result.mesh), options->output))
    std::cerr << "reebquad: " << options->output << ": " << warning << '\n';
  return Exit_code::success;
}

} // namespace reebquad
