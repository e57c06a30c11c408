// SPDX-License-Identifier: GPL-3.0-or-later
// What the phases of relax_quads() share: connectivity, constraints, and the measures of a quad.
#ifndef REEBQUAD_RELAX_RELAX_STATE_H
#define REEBQUAD_RELAX_RELAX_STATE_H

#include <CGAL/Reeb_quadrangulation/relax_quads.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace relaxation {

enum class Freedom : char { surface, curve, fixed };

/// Where a vertex is bound: to a place of the surface or of a curve.
struct Site {
  Freedom freedom = Freedom::surface;
  int face = -1;                ///< of the input, near the vertex
  int curve = -1;               ///< for Freedom::curve
  double parameter = 0;         ///< on the curve; unrolled along the chain of vertices
  int previous = -1, next = -1; ///< neighbours on the curve, or -1
};

/// A candidate position.
struct Step {
  Point point;
  Point normal; ///< of the input there
  int face = -1;
  double parameter = 0;
};

class State {
public:
  State(Quad_mesh& mesh, const Surface_projector& projector, const Vertex_constraints& constraints,
        int threads);

  Quad_mesh& mesh;
  const Surface_projector& projector;
  const Triangle_surface& input; ///< the projector's surface
  int threads;
  std::vector<int> first;                              ///< V + 1: range of each vertex in `corners`
  std::vector<int> corners;                            ///< 4 q + i, ascending
  std::vector<std::array<double, 2>> original_lengths; ///< half edge lengths of the quads before relaxation
  std::vector<Site> sites;
  std::vector<Surface_curve> curves;
  std::vector<std::vector<int>> colours; ///< by `colour_vertices()`: vertices that may move at the same time

  /// Parts vertices with a common quad, and neighbours on a curve, which bound each other. After all are
  /// bound.
  void colour_vertices();
  int number_of_vertices() const { return int(mesh.points.size()); }
  /// Unit normal of the input where the vertex is bound.
  Point normal(int v) const { return m_normals[v]; }
  /// Whether v slides along a curve inside the surface.
  bool on_ridge(int v) const {
    return sites[v].freedom == Freedom::curve && !curves[std::size_t(sites[v].curve)].normals.empty();
  }
  /// Mean length of the edges at v.
  double size_around(int v) const;
  /// Scaled Jacobian of quad q with vertex v moved by `step`; less, down to -0.7, if the quad faces away from
  /// the normals of the input at its vertices.
  double quality(int q, int v, const Step& step) const;
  double quality(int q) const { return quality(q, -1, {}); }
  /// The worst quality around v as it is, or after `step`.
  double worst_around(int v, const Step& step) const;
  double worst_around(int v) const { return worst_around(v, here(v)); }
  Step here(int v) const { return {mesh.points[v], m_normals[v], sites[v].face, sites[v].parameter}; }
  /// `target` brought back to where v may be.
  Step constrain(int v, const Point& target) const;
  /// v at another arc length of its curve.
  Step on_curve(int v, double t) const;
  void move(int v, const Step& step);

  /// Where all vertices are, to come back to.
  struct Snapshot {
    std::vector<Point> points, normals;
    std::vector<Site> sites;
  };
  Snapshot snapshot() const { return {mesh.points, m_normals, sites}; }
  void restore(const Snapshot& snapshot, int v) {
    mesh.points[v] = snapshot.points[v];
    m_normals[v] = snapshot.normals[v];
    sites[v] = snapshot.sites[v];
  }

private:
  void place_on_surface();

  std::vector<Point> m_normals;
};

/// Binds the mesh's boundary vertices to the input's boundary loops. Returns how many vertices are on the
/// boundary.
int bind_boundary(State& state);
/// Binds vertices to curves, but for those on the boundary.
void bind_to_curves(State& state, const Vertex_constraints& constraints);

/// What a sweep aims at.
struct Regime {
  double evenness = 0.05;  ///< between the corners of rectangles (0) and the average of the neighbours (1)
  double favour_small = 1; ///< a quad of size d counts d^-favour_small
  double memory = 0.5;     ///< between the quads' present lengths (0) and those before relaxation (1)
};

/// How a sweep takes its steps.
struct Sweep {
  double good_enough = 0.5; ///< a step may make the worst quad around a vertex worse down to this quality
  bool lenient = false;     ///< vertices of inverted quads take any step
  const std::vector<char>* mask = nullptr; ///< only the vertices marked there, or all
  double stride = 1; ///< over-relaxation: so many times the step towards rectangles, below 2
};

/// One sweep of steps towards rectangles. Returns the number of accepted steps.
int smooth(State& state, const Regime& regime, const Sweep& sweep);
/// Optimises the vertices around quads of quality below `wanted`.
void untangle(State& state, double wanted, int rounds, const std::vector<char>* mask, Observer* observer);
/// Pairs i < j of quads that meet in more than their common vertices, ascending; quads are cut along their
/// shorter diagonals. Decided by exact predicates.
std::vector<std::pair<int, int>> intersecting_quads(const Quad_mesh& mesh);
/// Whether two quads meet in more than their common vertices.
bool quads_meet(const Quad_mesh& mesh, int i, int j);
/// Moves single vertices of intersecting quads so that fewer quads intersect. `offset` is how far a vertex
/// may leave the surface along its normal, in units of the quads' size around it; 0 keeps vertices on the
/// surface.
void separate(State& state, double offset, int rounds, Observer* observer);
/// Relaxes the surroundings of inverted and intersecting quads anew, in at most so many other ways, and keeps
/// what helps. `original` is where the vertices were at first. Returns what `count_defects()` then has.
std::vector<int> repair(State& state, const State::Snapshot& original, int attempts, Observer* observer);
/// Raises the quality of the quads below `wanted`, as far as no quad gets more defects than it has. Returns
/// the defects in the end. \pre `defects` are the state's, by `count_defects()`.
std::vector<int> polish(State& state, double wanted, const std::vector<int>& defects, Observer* observer);

} // namespace relaxation
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_RELAX_RELAX_STATE_H
