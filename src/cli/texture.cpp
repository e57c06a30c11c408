// SPDX-License-Identifier: GPL-3.0-or-later
// reebquad texture QUADS --on INPUT: edits patches of a quad mesh of any origin, which stays as it is
// everywhere else.
#include "Command.h"
#include "Input.h"
#include "Interruption.h"
#include "Outputs.h"
#include "Patch_edits.h"
#include "Recipe_input.h"
#include "Stitching.h"
#include "Text_input.h"

#include <CGAL/Reeb_quadrangulation/IO/atomic_file.h>
#include <CGAL/Reeb_quadrangulation/IO/recipe.h>
#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>
#include <CGAL/Reeb_quadrangulation/base_domain.h>
#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>
#include <CGAL/Reeb_quadrangulation/picture_scene.h>
#include <CGAL/Reeb_quadrangulation/render.h>

#include <filesystem>
#include <iostream>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;
namespace po = boost::program_options;

namespace {

struct Texture_options {
  std::string quads, input, output, recipe, written_recipe, pictures;
  std::vector<std::string> operations;
  Base_cut cut = Base_cut::separatrices;
  bool relax = true;
  bool stitch = false;
  bool quiet = false;
};

std::optional<Texture_options> parse_texture_options(const Arguments& arguments) {
  const auto text = [](const char* name) { return po::value<std::string>()->value_name(name); };
  Command_line line(
      "texture QUADS --on INPUT [-o OUT] [--recipe EDITS.json] [--op \"NAME x,y,z ... [at=F]\" ...]\n"
      "Operators: subdivide_texture, coarsen_texture, insert_polychord, delete_polychord, inset_quads, "
      "open_quad,\n"
      "close_quad, rotate_edge, rotate_edge_back, rotate_vertex, insert_doublet, remove_doublet, "
      "delete_quads, restore_quads,\n"
      "move_vertices FROM TO, relax_vertices. Points name the quad, edge or vertex that is nearest");
  line.options.add_options()("on", text("INPUT"), "the triangle surface that the quads stand for")(
      "output,o", text("FILE"), "the edited quad mesh")(
      "recipe", text("FILE"), "apply the edits of this recipe: edit_texture, drag_vertices, relax_texture")(
      "write-recipe", text("FILE"), "write all edits as a recipe")(
      "op", po::value<std::vector<std::string>>()->composing()->value_name("EDIT"),
      "an edit of the patch at its points (repeatable)")("ops", text("FILE"),
                                                         "such edits, one a line, before those of --op")(
      "cut", text("WHERE")->default_value("separatrices"),
      "the patches: between separatrices (the base complex), or every quad: everywhere")(
      "pictures", text("DIR"), "write pictures of the patches and of the result into this folder")(
      "stitch", "QUADS are patches that touch without equal samples: stitch them after the edits")(
      "no-relax", "do not relax the new vertices")("quiet", "print errors only");
  declare_force(line);
  line.take("QUADS");
  if (!line.parse(arguments)) return std::nullopt;
  Texture_options options;
  options.quads = line.required("QUADS");
  options.input = line.required("on");
  if (line.has("output")) options.output = line.text("output");
  if (line.has("pictures")) options.pictures = line.text("pictures");
  if (line.has("recipe")) options.recipe = line.text("recipe");
  if (line.has("write-recipe")) options.written_recipe = line.text("write-recipe");
  keep_inputs(line, {{options.quads, options.input, options.recipe, line.has("ops") ? line.text("ops") : ""},
                     {options.output, options.written_recipe},
                     options.pictures});
  if (line.has("ops"))
    for (Text_line& edit : read_lines(line.text("ops"))) options.operations.push_back(std::move(edit.text));
  if (line.has("op"))
    for (const std::string& edit : line.values["op"].as<std::vector<std::string>>())
      options.operations.push_back(edit);
  if (line.text("cut") != "separatrices" && line.text("cut") != "everywhere")
    throw Usage_error("--cut is one of separatrices, everywhere; it got '" + line.text("cut") + "'");
  if (line.text("cut") == "everywhere") options.cut = Base_cut::everywhere;
  if (options.output.empty() && !(options.operations.empty() && options.recipe.empty()))
    throw Usage_error("edits are given, but no file to write: -o FILE");
  options.relax = !line.has("no-relax");
  options.stitch = line.has("stitch");
  options.quiet = line.has("quiet");
  return options;
}

// The edits of a recipe, of a file of lines and of the command line, in this order.
std::vector<Edit> edits_of(const Texture_options& options) {
  std::vector<Edit> edits;
  if (!options.recipe.empty()) edits = read_recipe(options.recipe).edits;
  for (const std::string& text : options.operations) edits.push_back(parse_patch_edit(text));
  return edits;
}

// How a message calls the i-th edit.
std::string called(const Texture_options& options, const std::vector<Edit>& edits, std::size_t i) {
  const std::size_t of_recipe = edits.size() - options.operations.size();
  if (i >= of_recipe) return "the edit '" + options.operations[i - of_recipe] + "'";
  return options.recipe + ": edit " + std::to_string(i + 1) + " (" + name(edits[i]) + ")";
}

void write_picture(const Scene& scene, const std::string& folder, const std::string& file) {
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  const std::string path = (std::filesystem::path(folder) / file).string();
  succeed_or_fail(write_png(contact_sheet(scene, Up_axis::z, 1600, 1200), path), path);
}

// Joins the patches of a file that do not share their vertices.
void stitch(Textured_base& result, const Texture_options& options, const Triangle_surface& surface,
            const Surface_projector& projector) {
  Stitch_patches_options stitching;
  stitching.may_stay_open = !boundary_loops(surface).empty();
  if (!options.relax) stitching.relaxation = Stitch_relaxation::none;
  const Patch_files patches = patches_of(result.mesh, options.quads);
  Stitched_patches stitched = stitched_or_fail(stitch_patches(result.mesh, stitching, &projector), patches);
  if (!options.quiet) std::cout << stitching_text(stitched);
  std::vector<int> patch_of_quad;
  for (int parent : stitched.parent) patch_of_quad.push_back(result.patch_of_quad[std::size_t(parent)]);
  result.mesh = std::move(stitched.mesh);
  result.patch_of_quad = std::move(patch_of_quad);
}

} // namespace

Exit_code execute_texture(const Arguments& arguments) {
  const std::optional<Texture_options> options = parse_texture_options(arguments);
  if (!options) return Exit_code::success;
  if (!options->output.empty()) require_writable_format(options->output);
  const std::vector<Edit> edits = edits_of(*options);
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

  Patch_edits patches(quads, domain);
  for (std::size_t i = 0; i < edits.size(); ++i) patches.apply(edits[i], called(*options, edits, i));
  Relax_options relaxation;
  if (!options->relax) relaxation = {0, false, 1, 0};
  const Surface_projector projector(surface);
  Textured_base result =
      value_or_fail(apply_textures(quads, domain, patches.textures(), projector, relaxation), options->quads);
  if (options->stitch) stitch(result, *options, surface, projector);
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
  if (!options->written_recipe.empty()) {
    Recipe recipe;
    recipe.edits = edits;
    succeed_or_fail(write_file_atomically(options->written_recipe, to_json(recipe) + "\n"),
                    options->written_recipe);
  }
  return Exit_code::success;
}

} // namespace reebquad
