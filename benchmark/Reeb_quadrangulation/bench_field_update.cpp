// SPDX-License-Identifier: GPL-3.0-or-later
// The update of the field alone after an edit, on the touched charts, beside CHOLMOD's numeric factorization
// and solve of the whole surface in the same run: JSON lines, wall seconds. Cutting the surface is not
// counted, everything from the cut mesh to the values is. Then saddles' loops moved to planes, cut into the
// surface or enforced by the field alone, and how near they come to the planes; and the time to look for
// hints. Usage: bench_field_update [shape [triangles [edits of each kind]]]
#include "bench_tools.h"

#include "base/parallel_for.h"
#include "keep_freed_memory.h"
#include <CGAL/Reeb_quadrangulation/Dirichlet_problem.h>
#include <CGAL/Reeb_quadrangulation/Harmonic_field.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>
#include <CGAL/Reeb_quadrangulation/suggest_edits.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <thread>

using namespace bench;
using Json = nlohmann::ordered_json;

namespace {

// Where the whole surface's order of elimination has each vertex: found once a session.
std::vector<int> surface_places(const Editor& editor) {
  Harmonic_field field(editor.working_surface());
  for (const Design_extremum& e : editor.design().extrema)
    if (Result<void> set = field.set_constraint(e.vertex, e.value); !set) fail(set.error());
  if (const auto solved = field.solve(); !solved) fail(solved.error());
  return places_in(field.elimination_order());
}

// A field to update: a mesh with values at its border and its extrema.
struct Field {
  const Chart* chart;
  std::vector<char> is_fixed;
  std::vector<double> values;
  std::vector<int> order; // of elimination, as the whole surface has it

  Field(const Chart& c, const Design& design, const std::vector<int>& places) : chart(&c) {
    is_fixed.assign(c.mesh.number_of_vertices(), 0);
    values.assign(is_fixed.size(), 0);
    for (const Walk& walk : c.walks)
      for (int v : walk.vertices) fix(v, design.network.edges[walk.edges[0].edge].value);
    for (const Design_extremum& e : design.extrema)
      for (std::size_t v = 0; v < c.vertex_origin.size(); ++v)
        if (c.vertex_origin[v] == e.vertex) fix(int(v), e.value);
    order = elimination_order(c, places);
  }

  void fix(int v, double value) {
    is_fixed[v] = 1;
    values[v] = value;
  }

  void update() {
    Result<Dirichlet_problem> problem =
        Dirichlet_problem::factorize(chart->mesh, clamped_cotangent_weights(chart->mesh), is_fixed, order);
    if (!problem) fail(problem.error());
    if (Result<void> solved = problem->solve(chart->mesh, values); !solved) fail(solved.error());
  }
};

struct Measurement {
  std::vector<double> seconds, shares;

  void add(double time, const std::vector<const Chart*>& charts, const Editor& editor) {
    double faces = 0;
    for (const Chart* chart : charts) faces += chart->mesh.number_of_faces();
    seconds.push_back(time);
    shares.push_back(faces / editor.working_surface().number_of_faces());
  }
  void print(const char* kind, double cholmod) const {
    Json line{{"field_update", kind}, {"edits", seconds.size()}};
    if (!seconds.empty()) {
      line["median_seconds"] = median(seconds);
      line["longest_seconds"] = *std::max_element(seconds.begin(), seconds.end());
      line["median_touched_share"] = median(shares);
      line["times_faster_than_cholmod"] = cholmod / median(seconds);
    }
    std::cout << line.dump() << std::endl;
  }
};

// A loop at a saddle, and a plane through the saddle that is tilted a little against it.
struct Saddle_loop {
  Surface_point at;
  Point saddle;
  Eigen::Vector3d normal;
};

std::optional<Saddle_loop> tilted_loop(const Editor& editor, Random_elements& random) {
  const Contour_network& network = editor.design().network;
  const Surface_point at = random.contour(false);
  for (const Contour_edge& edge : network.edges) {
    std::vector<Point> points;
    for (int v : edge.vertices) points.push_back(network.position(editor.working_surface(), v));
    if (edge.from != edge.to || std::find(points.begin(), points.end(), at.point) == points.end() ||
        network.nodes[edge.from].kind != Node_kind::saddle)
      continue;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t i = 1; i < points.size(); ++i)
      normal += (points[i - 1] - points[0]).cross(points[i] - points[0]);
    return Saddle_loop{at, points[0], normal.normalized() + 0.1 * random.direction().normalized()};
  }
  return std::nullopt;
}

// The mean distance of the contour at a point from a plane, in edge lengths of the quads.
double distance_from_plane(const Editor& editor, const Saddle_loop& loop) {
  const Contour_network& network = editor.design().network;
  double best = -1, mean = 0;
  for (const Contour_edge& edge : network.edges) {
    double nearest = -1, sum = 0;
    for (int v : edge.vertices) {
      const Point p = network.position(editor.working_surface(), v);
      const double d = (p - loop.at.point).norm();
      if (nearest < 0 || d < nearest) nearest = d;
      sum += std::abs((p - loop.saddle).dot(loop.normal.normalized()));
    }
    if (edge.vertices.empty() || (best >= 0 && nearest >= best)) continue;
    best = nearest;
    mean = sum / double(edge.vertices.size());
  }
  return mean / editor.design().edge_length;
}

// The same loops moved to the same planes in both ways: whole edits, and how near the contours come to the
// planes.
void compare_enforcements(Editor& editor, Random_elements& random, int wanted) {
  std::array<std::vector<double>, 2> seconds, distances;
  std::array<int, 2> refused{{0, 0}};
  for (int tries = 0; int(seconds[0].size()) < wanted && tries < 40 * wanted; ++tries) {
    const std::optional<Saddle_loop> loop = tilted_loop(editor, random);
    if (!loop) continue;
    for (Enforcement how : {Enforcement::contour, Enforcement::field}) {
      const double begin = now();
      if (!editor.apply(Move_contour{loop->at, loop->saddle, loop->normal, {}, how})) {
        ++refused[int(how)];
        break; // only loops that move in the first way are compared
      }
      editor.quads();
      seconds[int(how)].push_back(now() - begin);
      distances[int(how)].push_back(distance_from_plane(editor, *loop));
      editor.undo();
    }
  }
  for (int how : {0, 1}) {
    Json line{{"enforcement", how == 0 ? "contour" : "field"},
              {"edits", seconds[how].size()},
              {"refused", refused[how]}};
    if (!seconds[how].empty()) {
      line["median_seconds"] = median(seconds[how]);
      line["median_distance_from_plane"] = median(distances[how]);
      line["largest_distance_from_plane"] = *std::max_element(distances[how].begin(), distances[how].end());
    }
    std::cout << line.dump() << std::endl;
  }
}

// The charts of an extremum as one: its disc and what is beyond the cap.
Chart polar_region(const Editor& editor, const Design_extremum& extremum) {
  const Design& design = editor.design();
  Contour_network network = design.network;
  std::vector<int> charts, extrema;
  for (const Design_extremum& e : design.extrema) extrema.push_back(e.vertex);
  for (std::size_t c = 0; c < design.charts.size(); ++c) {
    const Chart& chart = *design.charts[c]->chart;
    if (chart.extremum < 0 || chart.vertex_origin[chart.extremum] != extremum.vertex) continue;
    const int cap = chart.walks[0].edges[0].edge;
    for (int side : design.atlas.charts_of_edge[cap]) charts.push_back(side);
    remove_edge(network, cap);
  }
  std::sort(charts.begin(), charts.end());
  const Triangle_surface& surface = editor.working_surface();
  const Result<Embedding> embedding = embed(surface, network, faces_of_charts(surface, design.atlas, charts));
  if (!embedding) fail(embedding.error());
  int face = 0;
  const auto touches = [&](int f) {
    const Triangle& t = embedding->surface.triangles[f];
    return std::find(t.begin(), t.end(), extremum.vertex) != t.end();
  };
  while (!touches(face)) ++face;
  Result<Chart> region = cut_region(*embedding, network, extrema, face);
  if (!region) fail(region.error());
  return std::move(*region);
}

// The field of `region` again with what the last solve left: an extremum at `target` that is dragged further.
double drag_further_seconds(const Chart& region, const Field& field, int target, double value) {
  Harmonic_field kept(region.mesh);
  kept.set_weights(Weight_kind::clamped_cotangent);
  kept.set_incremental(true);
  int at = -1;
  for (int v = 0; v < region.mesh.number_of_vertices(); ++v) {
    if (region.vertex_origin[v] == target) at = v;
    if (field.is_fixed[v])
      if (Result<void> set = kept.set_constraint(v, field.values[v]); !set) fail(set.error());
  }
  if (const auto solved = kept.solve(); !solved) fail(solved.error());
  const double begin = now();
  kept.remove_constraint(at);
  if (Result<void> set = kept.set_constraint(region.mesh.target(region.mesh.outgoing[at]), value); !set)
    fail(set.error());
  if (const auto solved = kept.solve(); !solved) fail(solved.error());
  return now() - begin;
}

void measure_extrema(Editor& editor, Random_elements& random, const std::vector<int>& places, int wanted,
                     double cholmod) {
  Measurement extremum, dragged;
  const Design design = editor.design();
  for (int i = 0; i < wanted; ++i) {
    const Design_extremum& e = design.extrema[i % design.extrema.size()];
    const Chart region = polar_region(editor, e);
    const int target = random.beside({editor.working_surface().points[e.vertex], e.vertex}, 10).vertex;
    Design moved = design;
    moved.extrema[i % design.extrema.size()].vertex = target;
    Field field(region, moved, places);
    const double begin = now();
    field.update();
    extremum.add(now() - begin, {&region}, editor);
    dragged.add(drag_further_seconds(region, field, target, e.value), {&region}, editor);
  }
  extremum.print("extremum moved, contours fixed", cholmod);
  dragged.print("extremum dragged further, contours fixed", cholmod);
}

void measure_contours(Editor& editor, Random_elements& random, const std::vector<int>& places, int wanted,
                      double cholmod) {
  const int threads = std::max(1u, std::thread::hardware_concurrency());
  Measurement contour;
  for (int refused = 0; int(contour.seconds.size()) < wanted && refused < 40 * wanted;) {
    const Surface_point c = random.contour(false);
    const Result<Edit_report> done =
        editor.apply(Move_contour{c, c.point, random.direction(), {}, Enforcement::contour});
    if (!done) {
      ++refused;
      continue;
    }
    std::vector<const Chart*> charts;
    std::vector<Field> fields;
    for (const auto& chart : editor.design().charts)
      if (std::binary_search(done->new_charts.begin(), done->new_charts.end(), chart->id)) {
        charts.push_back(chart->chart.get());
        fields.emplace_back(*chart->chart, editor.design(), places);
      }
    const double begin = now();
    internal::parallel_for(int(fields.size()), threads, [&](int i) { fields[i].update(); });
    contour.add(now() - begin, charts, editor);
    editor.undo();
  }
  contour.print("contour moved", cholmod);
}

} // namespace

int main(int argc, char** argv) {
  internal::keep_freed_memory();
  const Arguments arguments = arguments_of(argc, argv);
  const Result<Triangle_surface> surface = make_shape(arguments.shape, arguments.triangles);
  if (!surface) fail(surface.error());
  Editor editor = suggested_session(*surface);
  const double cholmod = cholmod_seconds(editor.working_surface());
  std::cout << Json{{"shape", arguments.shape},
                    {"triangles", editor.working_surface().number_of_faces()},
                    {"cholmod_factor_and_solve_seconds", cholmod}}
                   .dump()
            << std::endl;
  const std::vector<int> places = surface_places(editor);
  Random_elements random(editor);

  measure_extrema(editor, random, places, arguments.wanted, cholmod);
  measure_contours(editor, random, places, arguments.wanted, cholmod);
  compare_enforcements(editor, random, arguments.wanted);
  const double begin = now();
  const Result<std::vector<Hint>> hints = suggest_edits(editor);
  if (!hints) fail(hints.error());
  std::cout << Json{{"suggest_edits_seconds", now() - begin}, {"hints", hints->size()}}.dump() << std::endl;
}
