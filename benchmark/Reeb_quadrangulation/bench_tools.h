// SPDX-License-Identifier: GPL-3.0-or-later
// What the benchmarks of edits share.
#ifndef REEBQUAD_BENCH_TOOLS_H
#define REEBQUAD_BENCH_TOOLS_H

#include <CGAL/Reeb_quadrangulation/Cholmod_solver.h>
#include <CGAL/Reeb_quadrangulation/Editor.h>
#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/laplacian.h>
#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace bench {

using namespace CGAL::Reeb_quadrangulation;

inline double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Arguments {
  std::string shape = "genus-3";
  int triangles = 400000, wanted = 20; // edits of a kind
};

// SHAPE, TRIANGLES and the number of edits of a kind.
inline Arguments arguments_of(int argc, char** argv) {
  Arguments result;
  if (argc > 1) result.shape = argv[1];
  if (argc > 2) result.triangles = std::atoi(argv[2]);
  if (argc > 3) result.wanted = std::atoi(argv[3]);
  return result;
}

[[noreturn]] inline void fail(const Error& error) {
  std::cerr << error.message << '\n';
  std::exit(1);
}

inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// Numeric factorization and solve of the whole surface, the quickest of five, so that a busy machine flatters
// nobody; the analysis is not counted.
inline double cholmod_seconds(const Triangle_surface& surface) {
  std::vector<char> is_fixed(surface.number_of_vertices(), 0);
  is_fixed[0] = 1;
  const Laplace_system system = assemble(surface, cotangent_weights(surface), is_fixed);
  Cholmod_solver solver;
  if (Result<void> done = solver.factorize(system.matrix); !done) fail(done.error());
  std::vector<double> seconds;
  for (int i = 0; i < 5; ++i) {
    std::vector<double> x(system.matrix.size, 1.0);
    const double begin = now();
    if (Result<void> done = solver.factorize(system.matrix); !done) fail(done.error());
    if (Result<void> done = solver.solve(x.data()); !done) fail(done.error());
    seconds.push_back(now() - begin);
  }
  return *std::min_element(seconds.begin(), seconds.end());
}

// Of a file, mended.
inline Result<Triangle_surface> largest_component(const std::string& file) {
  Result<Polygon_soup> soup = read_polygon_soup(file);
  if (!soup) return soup.error();
  Result<Mended_surface> mended = mend_surface(*soup, {});
  if (!mended) return mended.error();
  const auto largest = std::max_element(mended->components.begin(), mended->components.end(),
                                        [](const Mended_component& a, const Mended_component& b) {
                                          return a.surface.number_of_faces() < b.surface.number_of_faces();
                                        });
  if (largest == mended->components.end()) return make_error(Error_code::not_a_surface, "no surface");
  return std::move(largest->surface);
}

// A session with the suggested design.
inline Editor suggested_session(const Triangle_surface& surface) {
  Result<Editor> editor = Editor::create(surface);
  if (!editor) fail(editor.error());
  if (const Result<Edit_report> done = editor->apply(Suggest{}); !done) fail(done.error());
  return std::move(*editor);
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

} // namespace bench

#endif // REEBQUAD_BENCH_TOOLS_H
