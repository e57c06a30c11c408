// SPDX-License-Identifier: GPL-3.0-or-later
// Every texture operator on grids of growing size, finding an edge by a point, and resolving T-junctions; and
// on a sphere: placing the vertices of all textures, stitching them, and quads twice as fine where a size
// field asks for it; and fitting the texture of a twisted bar to its sharp edges. Seconds of wall clock, best
// of three.
#include <CGAL/Reeb_quadrangulation/Editor.h>
#include <CGAL/Reeb_quadrangulation/Texture_edit.h>
#include <CGAL/Reeb_quadrangulation/fit_texture.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>
#include <CGAL/Reeb_quadrangulation/t_junctions.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iostream>
#include <map>
#include <string>

using namespace CGAL::Reeb_quadrangulation;

namespace {

double best_of_three(const std::function<bool()>& run) {
  double best = 1e9;
  for (int k = 0; k < 3; ++k) {
    const auto start = std::chrono::steady_clock::now();
    if (!run()) return -1;
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

void print(const std::string& name, std::size_t quads, double seconds) {
  std::cout << nlohmann::json{{"benchmark", "textures"},
                              {"operator", name},
                              {"quads", quads},
                              {"seconds", seconds}}
                   .dump()
            << "\n";
}

// An annulus of n x n quads, its rows of equal height.
Quad_texture grid(int n) {
  std::vector<double> levels;
  for (int r = 0; r <= n; ++r) levels.push_back(double(r) / n);
  return regular_annulus_texture(n, levels);
}

// A grid whose inner vertices are disturbed by a fifth of an edge.
Quad_texture disturbed(Quad_texture t, int n) {
  std::uint64_t state = 1;
  const auto noise = [&] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return 0.2 / n * (double(state >> 33) / double(1u << 30) - 1);
  };
  for (std::size_t i = 0; i < t.v.size(); ++i) {
    if (t.u[i] == 0 || t.u[i] == 1) continue;
    t.v[i] += noise();
    t.v[i] -= std::floor(t.v[i]);
    t.u[i] += noise();
  }
  return t;
}

std::vector<std::pair<Quad_texture, Texture_edit>> edits(const Quad_texture& t, int n) {
  const int middle = n * (n / 2) + n / 3;
  const auto at = [&](int corner) { return Texture_place{0, 0, middle, corner}; };
  std::vector<std::pair<Quad_texture, Texture_edit>> out;
  for (const Texture_edit& e :
       {Texture_edit(Subdivide_texture{}), Texture_edit(Insert_polychord{at(0)}),
        Texture_edit(Insert_polychord{at(1)}), Texture_edit(Delete_polychord{at(0)}),
        Texture_edit(Inset_quads{{at(0)}}), Texture_edit(Open_quad{at(0), at(1)}),
        Texture_edit(Close_quad{at(0)}), Texture_edit(Rotate_edge{at(0)}), Texture_edit(Rotate_vertex{at(0)}),
        Texture_edit(Insert_doublet{at(0)}), Texture_edit(Delete_quads{{at(0)}})})
    out.push_back({t, e});
  Move_vertices move;
  move.vertices = {at(0)};
  move.dv = 0.4 / n;
  move.radius = 10.0 / n;
  move.steps = 5;
  out.push_back({t, move});
  out.push_back({disturbed(t, n), Relax_vertices{{}, 1, {}}});
  out.push_back(
      {edit_texture(t, Insert_doublet{at(0)})->texture, Remove_doublet{{0, 0, int(t.quads.size()), 1}}});
  out.push_back({edit_texture(t, Delete_quads{{at(0)}})->texture, Restore_quads{{at(0)}}});
  return out;
}

// The lower half of a flat grid is half as fine as the upper: n / 2 T-junctions on a line.
double resolve(int n) {
  Quad_mesh mesh;
  std::vector<Hanging_edge> hanging;
  const int coarse = n / 2;
  for (int y = 0; y <= coarse; ++y)
    for (int x = 0; x <= coarse; ++x) mesh.points.emplace_back(2 * x, 2 * (y - coarse), 0);
  for (int y = 0; y < coarse; ++y)
    for (int x = 0; x < coarse; ++x) {
      const int a = y * (coarse + 1) + x, b = a + coarse + 1;
      mesh.quads.push_back({a, a + 1, b + 1, b});
    }
  const int line = coarse * (coarse + 1), fine = int(mesh.points.size());
  for (int x = 0; x < coarse; ++x) {
    mesh.points.emplace_back(2 * x + 1, 0, 0);
    hanging.push_back({(coarse - 1) * coarse + x, 2, {fine + x}});
  }
  const int above = int(mesh.points.size());
  for (int y = 1; y <= n; ++y)
    for (int x = 0; x <= 2 * coarse; ++x) mesh.points.emplace_back(x, y, 0);
  const auto id = [&](int x, int y) {
    return y > 0 ? above + (y - 1) * (2 * coarse + 1) + x : x % 2 == 0 ? line + x / 2 : fine + x / 2;
  };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < 2 * coarse; ++x)
      mesh.quads.push_back({id(x, y), id(x + 1, y), id(x + 1, y + 1), id(x, y + 1)});
  T_junction_options options;
  options.may_end_on_boundary = coarse % 2 == 1;
  const double seconds = best_of_three([&] { return bool(resolve_t_junctions(mesh, hanging, options)); });
  print("resolve_t_junctions", mesh.quads.size(), seconds);
  return seconds;
}

// The stages of the pipeline that fill charts and join them, and a refinement of the northern half.
bool stages(int quads) {
  const Triangle_surface sphere = *make_shape("sphere", 50000);
  Quadrangulation_options options;
  options.quads = quads;
  options.relax = false;
  options.threads = 1;
  std::map<std::string, double> best;
  Result<Quadrangulation> made = make_error(Error_code::internal_error, "");
  for (int k = 0; k < 3; ++k) {
    made = quadrangulate(sphere, options);
    if (!made) return false;
    for (const Stage_time& stage : made->stages) {
      const double before = best.count(stage.name) ? best[stage.name] : 1e9;
      best[stage.name] = std::min(before, stage.seconds);
    }
  }
  print("place", made->mesh.quads.size(), best["textures"]);
  print("stitch", made->mesh.quads.size(), best["stitching"]);
  Adaptive_options north;
  const double edge = std::sqrt(4 * 3.14 / quads);
  north.size = [&](const Point& p) { return p.z() > 0.3 ? 0.5 * edge : 4 * edge; };
  const Surface_projector projector(sphere);
  const double seconds = best_of_three([&] { return bool(adapt_quads(made->mesh, projector, north)); });
  print("adapt", made->mesh.quads.size(), seconds);
  return seconds >= 0;
}

// The texture of the largest chart of a twisted bar onto its sharp edges.
bool fit(int quads) {
  Editor_options options;
  options.quads = quads;
  Result<Editor> editor = Editor::create(*make_shape("twisted-bar", 20000), options);
  if (!editor || !editor->apply(Suggest{})) return false;
  const auto& charts = editor->design().charts;
  const auto& chart = *std::max_element(charts.begin(), charts.end(), [](const auto& a, const auto& b) {
    return a->texture.texture.quads.size() < b->texture.texture.quads.size();
  });
  const Feature_edges features = features_inside(*chart->chart, editor->working_surface(), 45);
  print("fit_texture", chart->texture.texture.quads.size(), best_of_three([&] {
          return fit_texture(chart->texture, *chart->chart, *chart->map, features).vertices > 0;
        }));
  return true;
}

} // namespace

int main() {
  for (int n : {100, 316, 1000}) {
    const Quad_texture t = grid(n);
    for (const auto& [texture, edit] : edits(t, n)) {
      const double seconds = best_of_three([&] { return bool(edit_texture(texture, edit)); });
      print(name(edit), texture.quads.size(), seconds);
      if (seconds < 0) return 1;
    }
    const Quad_texture half = edit_texture(grid(n / 2), Subdivide_texture{})->texture;
    print("coarsen_texture", half.quads.size(),
          best_of_three([&] { return bool(edit_texture(half, Coarsen_texture{})); }));
    print("find_edge", t.quads.size(), best_of_three([&] { return bool(find_edge(t, {0.999, 0.999})); }));
    if (resolve(n) < 0 || !stages(n * n) || !fit(n * n)) return 1;
  }
  return 0;
}
