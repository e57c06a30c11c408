// SPDX-License-Identifier: GPL-3.0-or-later
// Response times of edits, from the command to all touched charts mapped and meshed, beside a full rebuild and CHOLMOD's
// factorization and solve of the whole surface in the same run: JSON lines, wall seconds.
// Usage: bench_editor [shape [triangles [edits of each kind]]]
#include <CGAL/Reeb_quadrangulation/Cholmod_solver.h>
#include <CGAL/Reeb_quadrangulation/Editor.h>
#include <CGAL/Reeb_quadrangulation/internal/keep_freed_memory.h>
#include <CGAL/Reeb_quadrangulation/laplacian.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <string>

using namespace CGAL::Reeb_quadrangulation;
using Json = nlohmann::ordered_json;

namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

[[noreturn]] void fail(const Error& error) {
  std::cerr << error.message << '\n';
  std::exit(1);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// Numeric factorization and solve; the analysis is not counted.
double cholmod_seconds(const Triangle_surface& surface) {
  std::vector<char> is_fixed(surface.number_of_vertices(), 0);
  is_fixed[0] = 1;
  const Laplace_system system = assemble(surface, cotangent_weights(surface), is_fixed);
  Cholmod_solver solver;
  if (Result<void> done = solver.factorize(system.matrix); !done) fail(done.error());
  std::vector<double> seconds;
  for (int i = 0; i < 3; ++i) {
    std::vector<double> x(system.matrix.size, 1.0);
    const double begin = now();
    if (Result<void> done = solver.factorize(system.matrix); !done) fail(done.error());
    if (Result<void> done = solver.solve(x.data()); !done) fail(done.error());
    seconds.push_back(now() - begin);
  }
  return median(seconds);
}

class Random_elements {
public:
  explicit Random_elements(const Editor& editor) : m_editor(editor) {}

  unsigned below(std::size_t n) { return unsigned(m_engine() % std::max<std::size_t>(n, 1)); }
  Surface_point vertex() { return at(int(below(m_editor.working_surface().points.size()))); }
  Surface_point extremum() {
    const auto& extrema = m_editor.design().extrema;
    return at(extrema[below(extrema.size())].vertex);
  }
  Surface_point saddle() {
    std::vector<int> saddles;
    for (const Contour_node& node : m_editor.design().network.nodes)
      if (node.kind == Node_kind::saddle) saddles.push_back(node.vertex);
    return saddles.empty() ? vertex() : at(saddles[below(saddles.size())]);
  }
  // A point on a contour without saddles, or on any contour.
  Surface_point contour(bool free) {
    const Design& d = m_editor.design();
    std::vector<const Contour_edge*> edges;
    for (const Contour_edge& e : d.network.edges)
      if (!e.vertices.empty() && (!free || d.network.nodes[e.from].kind == Node_kind::regular))
        edges.push_back(&e);
    const std::vector<int>& v = edges[below(edges.size())]->vertices;
    return {d.network.position(m_editor.working_surface(), v[below(v.size())]), -1};
  }
  // Some steps away from a vertex of the surface.
  Surface_point beside(const Surface_point& p, int steps) {
    const Triangle_surface& s = m_editor.working_surface();
    int v = p.vertex;
    for (int i = 0; i < steps; ++i) {
      int h = s.outgoing[v];
      for (unsigned turns = below(6); turns > 0; --turns) h = s.rotate_ccw(h);
      v = s.target(h);
    }
    return at(v);
  }
  Eigen::Vector3d direction() {
    return {double(below(2001)) - 1000, double(below(2001)) - 1000, double(below(2001)) - 1000};
  }

private:
  Surface_point at(int v) const { return {m_editor.working_surface().points[v], v}; }
  const Editor& m_editor;
  std::mt19937 m_engine{1};
};

// The share of the surface in the charts that are new.
double touched(const Editor& editor, const Edit_report& report) {
  double faces = 0, all = 0;
  for (const auto& chart : editor.design().charts) {
    const double n = chart->chart->mesh.number_of_faces();
    all += n;
    const bool is_new = std::binary_search(report.new_charts.begin(), report.new_charts.end(), chart->id);
    if (is_new) faces += n;
  }
  return faces / all;
}

void measure(Editor& editor, const std::string& kind, int wanted, double rebuild, double cholmod,
             const std::function<Edit()>& make) {
  std::vector<double> seconds, shares;
  int refused = 0;
  while (int(seconds.size()) < wanted && refused < 40 * wanted) {
    const Edit edit = make();
    const double begin = now();
    const Result<Edit_report> done = editor.apply(edit);
    if (!done) {
      ++refused;
      continue;
    }
    editor.quads();
    seconds.push_back(now() - begin);
    shares.push_back(touched(editor, *done));
    editor.undo();
  }
  Json line{{"edit", kind}, {"edits", seconds.size()}, {"refused", refused}};
  if (!seconds.empty()) {
    line["median_seconds"] = median(seconds);
    line["longest_seconds"] = *std::max_element(seconds.begin(), seconds.end());
    line["median_touched_share"] = median(shares);
    line["of_rebuild"] = median(seconds) / rebuild;
    line["of_cholmod"] = median(seconds) / cholmod;
  }
  std::cout << line.dump() << std::endl;
}

} // namespace

int main(int argc, char** argv) {
  internal::keep_freed_memory();
  const std::string shape = argc > 1 ? argv[1] : "genus-3";
  const int triangles = argc > 2 ? std::atoi(argv[2]) : 400000, wanted = argc > 3 ? std::atoi(argv[3]) : 20;
  const Result<Triangle_surface> surface = make_shape(shape, triangles);
  if (!surface) fail(surface.error());
  Result<Editor> made = Editor::create(*surface);
  if (!made) fail(made.error());
  Editor& editor = *made;
  std::vector<double> rebuilds; // from nothing: a session keeps the surface's factorization
  for (int i = 0; i < 3; ++i) {
    Result<Editor> fresh = Editor::create(*surface);
    if (!fresh) fail(fresh.error());
    const double begin = now();
    if (const Result<Edit_report> done = fresh->apply(Suggest{}); !done) fail(done.error());
    fresh->quads();
    rebuilds.push_back(now() - begin);
  }
  if (const Result<Edit_report> done = editor.apply(Suggest{}); !done) fail(done.error());
  const double rebuild = median(rebuilds), cholmod = cholmod_seconds(editor.working_surface());
  std::cout << Json{{"shape", shape},
                    {"triangles", editor.working_surface().number_of_faces()},
                    {"charts", editor.design().charts.size()},
                    {"rebuild_seconds", rebuild},
                    {"cholmod_factor_and_solve_seconds", cholmod}}
                   .dump()
            << std::endl;
  Random_elements random(editor);
  const auto run = [&](const char* kind, const std::function<Edit()>& make) {
    measure(editor, kind, wanted, rebuild, cholmod, make);
  };
  run("subdivide_chart", [&] { return Subdivide_chart{random.vertex()}; });
  run("move_contour", [&] {
    const Surface_point c = random.contour(true);
    return Move_contour{c, c.point, random.direction(), {}};
  });
  run("drag_contour", [&] { return Drag_contour{random.contour(true), random.vertex()}; });
  run("straighten_contour", [&] { return Straighten_contour{random.contour(true)}; });
  run("move_extremum", [&] {
    const Surface_point e = random.extremum();
    return Move_extremum{e, random.beside(e, 10), Edit_scope::chart};
  });
  run("add_extremum", [&] { return Add_extremum{random.vertex(), random.below(2) == 0}; });
  run("remove_extremum", [&] { return Remove_extremum{random.extremum()}; });
  run("move_extremum on the whole surface", [&] {
    const Surface_point e = random.extremum();
    return Move_extremum{e, random.beside(e, 10), Edit_scope::surface};
  });
  run("collapse_chart", [&] { return Collapse_chart{random.vertex()}; });
  run("split_saddle half", [&] { return Split_saddle{random.saddle(), Saddle_kind::half, {}, 0}; });
  run("split_saddle quarter", [&] { return Split_saddle{random.saddle(), Saddle_kind::quarter, {}, 0}; });
  run("split_pole half", [&] { return Split_pole{random.extremum(), Pole_kind::half, {}}; });
  run("move_corner", [&] { return Move_corner{random.extremum(), random.contour(true)}; });
  run("set_rows", [&] { return Set_rows{random.vertex(), 4 + int(random.below(20))}; });
  run("set_columns", [&] { return Set_columns{random.vertex(), 8 + 2 * int(random.below(20))}; });
  run("set_shift", [&] { return Set_shift{random.vertex(), 1 + int(random.below(5))}; });
  run("set_target", [&] { return Set_target{2000 + int(random.below(2000)), 0}; });
}
