// SPDX-License-Identifier: GPL-3.0-or-later
#include "Run_options.h"

#include "Guides_input.h"
#include "Input.h"
#include "Mirror_output.h"
#include "Number_list.h"
#include "Outputs.h"
#include "Solver_options.h"
#include "Text_input.h"
#include "Weights_option.h"

#include <cmath>
#include <sstream>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;
namespace po = boost::program_options;

namespace {

using Texts = std::vector<std::string>;

Point point_option(const char* option, const std::string& text) {
  const std::optional<Point> p = parse_point(text, ',');
  if (!p)
    throw Usage_error(std::string(option) + " takes three numbers as in 0,0.5,1; it got '" + text + "'");
  return *p;
}

/// The value that stands for `text` in a list of names.
template <class T>
T choice(const char* option, const std::string& text, const std::vector<std::pair<const char*, T>>& choices) {
  std::string names;
  for (const auto& [name, value] : choices) {
    if (text == name) return value;
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  throw Usage_error(std::string(option) + " is one of " + names + "; it got '" + text + "'");
}

template <class T> T in_range(const Command_line& line, const char* option, T low, T high) {
  const T value = line.values[option].as<T>();
  if (!(value >= low && value <= high)) {
    std::ostringstream text;
    text << "--" << option << " lies between " << low << " and " << high << "; it got " << value;
    throw Usage_error(text.str());
  }
  return value;
}

template <class T> po::typed_value<T>* value(const char* name) {
  return po::value<T>()->value_name(name);
}

void declare_sizes_and_outputs(Command_line& line) {
  line.options.add_options() //
      ("output,o", value<std::string>("FILE"),
       "the quad mesh: OBJ, OFF, PLY, VTK, VTU, INP or MSH by its extension "
       "(STL and GLB hold triangles)")                                                          //
      ("quads", value<int>("N")->default_value(3000), "about how many quads")                   //
      ("edge-length", value<double>("L"), "the length of the quads' edges, instead of --quads") //
      ("sizes", value<std::string>("FILE"),
       "lengths of edges, instead of --quads: a number for each point, or a PLY file with their 'size'") //
      ("adaptive", value<int>("RATIO")->implicit_value(2),
       "finer quads where the surface bends: up to RATIO times, 2 (if not given), 4 or 8")             //
      ("report", value<std::string>("FILE"), "write all numbers as JSON")                              //
      ("html", value<std::string>("FILE"), "write a report with an interactive view as one HTML file") //
      ("pictures", value<std::string>("DIR"), "write PNG pictures into this folder")                   //
      ("thumbnail", value<std::string>("FILE"), "write one small PNG picture");
}

void declare_search(Command_line& line) {
  const double default_persistence = Suggestion_options().persistence;
  line.options.add_options() //
      ("effort", value<std::string>("EFFORT")->default_value("default"),
       "fast: suggested extrema; default, best: search better ones, so that quads keep the shape") //
      ("extra-vertices", value<int>("N"),
       "the search may spend N extraordinary vertices; default: as many as pay") //
      ("budget", value<double>("SECONDS"),
       "search so long, instead of as many designs as --effort tries; the outcome depends on the machine") //
      ("weights", value<std::string>("NAME=X,..."),
       ("what the search looks for: weights of " + names_of_weights()).c_str()) //
      ("dislocations", value<int>("N"),
       "columns may end inside of charts, in N places of two extraordinary vertices, for sizes more alike; "
       "default: 0, with --sizes 16") //
      ("write-recipe", value<std::string>("FILE"),
       "write the run as a recipe: 'replay' makes the same bytes of it, the studio edits it")        //
      ("component", value<int>("K"), "mesh the connected component K only, counted from 1")          //
      ("extrema", value<std::string>("FILE"), "place the extrema: lines 'min x y z' or 'max x y z'") //
      ("min", value<Texts>("x,y,z")->composing(), "place a minimum near that point (repeatable)")    //
      ("max", value<Texts>("x,y,z")->composing(), "place a maximum near that point (repeatable)")    //
      ("axis", value<std::string>("x,y,z")->default_value("0,0,1"),
       "up: suggested extrema below the middle become minima, those above maxima") //
      ("persistence", value<double>("P")->default_value(default_persistence),
       "how prominent a protrusion must be to get an extremum, 0 to 1");
}

void declare_ways(Command_line& line) {
  line.options.add_options()                                                                            //
      ("threads", value<int>("N")->default_value(0), "how many threads; 0: as many as the machine has") //
      ("align", "bring extraordinary vertices in line, where quads keep their shape: the default")      //
      ("no-align", "leave extraordinary vertices where they are: many patches in the base complex")     //
      ("mirror", value<std::string>("PLANE")->default_value("none"),
       "mesh one half of a symmetric shape and reflect it: auto, x, y, z (across that axis; =-x keeps the "
       "other half), PX,PY,PZ,NX,NY,NZ or none") //
      ("mirror-positions", value<std::string>("WAY")->default_value("exact"),
       "of the other half: exact reflections, or projected onto the surface") //
      ("mirror-tolerance", value<double>("PERCENT")->default_value(1),
       "a shape is symmetric if it lies no farther from its mirror image, in percent of its diagonal") //
      ("no-collapse", "keep charts that are thinner than half a quad")                                 //
      ("no-relax", "do not relax the quads on the surface")                                            //
      ("feature-angle", value<double>("DEGREES")->default_value(45),
       "quads keep edges whose faces' normals differ by more; 0: none")     //
      ("feature-lines", "lay whole lines of quads' edges onto sharp edges") //
      ("boundary-value", value<Texts>("x,y,z=KIND")->composing(),
       "what the field is on the boundary loop nearest to a point: min, max, or with a value from 0 to 1 as "
       "min:0.2 (repeatable)") //
      ("boundaries", value<std::string>("WAY")->default_value("keep"),
       "keep: boundary loops are contours; fill: they are filled, and these quads left out in the end") //
      ("field", value<std::string>("WEIGHTS")->default_value("cotangent"),
       "weights of the field: cotangent or clamped") //
      ("validate",
       "demand strict validity: also no inverted quad, and no self-intersection but the input's own") //
      ("strict", "warnings fail: write nothing and end with 5 where the shape is not kept")           //
      ("all-or-nothing",
       "write nothing if a component cannot be meshed, instead of the others (exit code 6)")     //
      ("charts", "write charts as groups, and as texture coordinates of a square each")          //
      ("no-attributes", "do not carry over texture coordinates, colours and names of the input") //
      ("timings", "print the seconds and the memory of every stage")                             //
      ("quiet", "print errors only");
}

void declare_run_options(Command_line& line) {
  declare_sizes_and_outputs(line);
  declare_search(line);
  declare_ways(line);
  declare_solver(line, "multifrontal and elimination");
  declare_mending(line);
  declare_marks(line);
  declare_guides(line);
  declare_force(line);
  line.take("FILE");
}

// "x,y,z=min", "x,y,z=max" or "x,y,z=min:0.2".
Boundary_value boundary_value(const std::string& text) {
  const std::size_t equals = text.find('=');
  const auto fail = [&] {
    return Usage_error("--boundary-value takes a point and a kind as in 0,0,1=max, with a value as in "
                       "0,0,1=max:0.8; it got '" +
                       text + "'");
  };
  if (equals == std::string::npos) throw fail();
  Boundary_value out;
  out.at.point = point_option("--boundary-value", text.substr(0, equals));
  std::string kind = text.substr(equals + 1);
  if (const std::size_t colon = kind.find(':'); colon != std::string::npos) {
    const std::optional<Point> parsed = parse_point(kind.substr(colon + 1) + ",0,0", ',');
    if (!parsed || !(parsed->x() >= 0 && parsed->x() <= 1)) throw fail();
    out.value = parsed->x();
    kind.resize(colon);
  }
  if (kind != "min" && kind != "max") throw fail();
  out.is_maximum = kind == "max";
  return out;
}

std::vector<Placed_extremum> placed_extrema(const Command_line& line) {
  std::vector<Placed_extremum> extrema;
  if (line.has("extrema"))
    extrema = value_or_fail(parse_extrema(read_lines(line.text("extrema"))), line.text("extrema"));
  for (const char* option : {"min", "max"}) {
    if (!line.has(option)) continue;
    for (const std::string& text : line.values[option].as<Texts>())
      extrema.push_back({point_option(option, text), std::string(option) == "max"});
  }
  return extrema;
}

void set_search(const Command_line& line, Quadrangulation_options& pipeline) {
  pipeline.effort =
      choice<Effort>("--effort", line.text("effort"),
                     {{"fast", Effort::fast}, {"default", Effort::normal}, {"best", Effort::best}});
  if (line.has("extra-vertices")) pipeline.extra_vertices = in_range(line, "extra-vertices", 0, 1000000);
  if (line.has("budget")) {
    pipeline.budget = line.values["budget"].as<double>();
    if (!(pipeline.budget > 0) || !std::isfinite(pipeline.budget))
      throw Usage_error("--budget is a positive number of seconds");
    if (pipeline.effort == Effort::fast)
      throw Usage_error("--budget is for a search, and --effort fast has none");
  }
  if (line.has("weights")) pipeline.energy = energy_weights(line.text("weights"));
}

void set_mirror(const Command_line& line, Quadrangulation_options& pipeline) {
  pipeline.mirror = mirror_request(line.text("mirror"));
  const auto positions = choice<Mirror_positions>(
      "--mirror-positions", line.text("mirror-positions"),
      {{"exact", Mirror_positions::exact}, {"projected", Mirror_positions::projected}});
  const double tolerance = in_range(line, "mirror-tolerance", 0.0, 100.0) / 100;
  if (pipeline.mirror) {
    pipeline.mirror->positions = positions;
    pipeline.mirror->tolerance = tolerance;
  }
}

void set_pipeline(const Command_line& line, Quadrangulation_options& pipeline) {
  pipeline.quads = in_range(line, "quads", 1, 100000000);
  if (line.has("edge-length")) {
    if (!line.values["quads"].defaulted()) throw Usage_error("--quads and --edge-length exclude each other");
    pipeline.edge_length = line.values["edge-length"].as<double>();
    if (!(pipeline.edge_length > 0) || !std::isfinite(pipeline.edge_length))
      throw Usage_error("--edge-length is a positive length");
  }
  if (line.has("adaptive")) {
    const int ratio = pipeline.adaptive.ratio = line.values["adaptive"].as<int>();
    if (ratio != 2 && ratio != 4 && ratio != 8)
      throw Usage_error("--adaptive is 2, 4 or 8; it got " + std::to_string(ratio));
  }
  set_search(line, pipeline);
  constexpr int dislocations_for_sizes = 16;
  if (line.has("dislocations"))
    pipeline.dislocations = in_range(line, "dislocations", 0, 10000);
  else if (line.has("sizes"))
    pipeline.dislocations = dislocations_for_sizes;
  pipeline.extrema = placed_extrema(line);
  if (line.has("boundary-value"))
    for (const std::string& text : line.values["boundary-value"].as<Texts>())
      pipeline.boundary_values.push_back(boundary_value(text));
  pipeline.suggestion.axis = point_option("--axis", line.text("axis"));
  if (pipeline.suggestion.axis.isZero()) throw Usage_error("--axis has no direction");
  pipeline.suggestion.persistence = in_range(line, "persistence", 0.0, 1.0);
  pipeline.threads = in_range(line, "threads", 0, 1024);
  if (line.has("align") && line.has("no-align"))
    throw Usage_error("--align and --no-align exclude each other");
  pipeline.align = !line.has("no-align");
  set_mirror(line, pipeline);
  pipeline.collapse_thin = !line.has("no-collapse");
  pipeline.relax = !line.has("no-relax");
  pipeline.features.feature_angle = in_range(line, "feature-angle", 0.0, 180.0);
  pipeline.features.lines = line.has("feature-lines");
  pipeline.keep_features = pipeline.features.feature_angle > 0;
  pipeline.boundaries = choice<Boundaries>("--boundaries", line.text("boundaries"),
                                           {{"keep", Boundaries::keep}, {"fill", Boundaries::fill}});
  pipeline.weights = choice<Weight_kind>(
      "--field", line.text("field"),
      {{"cotangent", Weight_kind::cotangent}, {"clamped", Weight_kind::clamped_cotangent}});
  solver_options(line).apply_to(pipeline);
}

} // namespace

std::optional<Run_options> parse_run_options(const Arguments& arguments) {
  Command_line line("run FILE -o QUADS [options]");
  declare_run_options(line);
  if (!line.parse(arguments)) return std::nullopt;
  Run_options options;
  options.input = line.required("FILE");
  options.output = line.required("output");
  if (line.has("report")) options.report = line.text("report");
  if (line.has("html")) options.html = line.text("html");
  if (line.has("component")) options.component = in_range(line, "component", 1, 1000000000);
  if (line.has("write-recipe")) options.recipe = line.text("write-recipe");
  if (line.has("pictures")) options.pictures = line.text("pictures");
  if (line.has("thumbnail")) options.thumbnail = line.text("thumbnail");
  keep_inputs(line,
              {{options.input, line.has("extrema") ? line.text("extrema") : "",
                line.has("marks") ? line.text("marks") : "", line.has("guides") ? line.text("guides") : "",
                line.has("sizes") ? line.text("sizes") : ""},
               {options.output, options.report, options.html, options.recipe, options.thumbnail},
               options.pictures});
  if (line.has("sizes")) {
    options.sizes = line.text("sizes");
    if (!line.values["quads"].defaulted() || line.has("edge-length") || line.has("adaptive"))
      throw Usage_error("--sizes excludes --quads, --edge-length and --adaptive");
  }
  options.mending = mending(line);
  options.marks = marks_request(line);
  if (line.has("guides")) options.guides = line.text("guides");
  for (const char* option : {"weld", "drop-components-below", "refuse-non-manifold"})
    if (!options.recipe.empty() && line.has(option))
      throw Usage_error(std::string("a recipe does not keep --") + option +
                        ": mend the mesh into a file first, or leave --write-recipe out");
  options.all_or_nothing = line.has("all-or-nothing");
  options.charts = line.has("charts");
  options.attributes = !line.has("no-attributes");
  options.timings = line.has("timings");
  options.quiet = line.has("quiet");
  options.validate = line.has("validate");
  options.strict = line.has("strict");
  set_pipeline(line, options.pipeline);
  return options;
}

} // namespace reebquad
