// SPDX-License-Identifier: GPL-3.0-or-later
// Fields that are constant on closed lines of sharp edges: the surface is designed part by part between them.
#include "atlas/chart_lines.h"
#include "atlas/cut_part.h"
#include "edits/steps.h"
#include "surface/sharp_patches.h"

#include <CGAL/Reeb_quadrangulation/Reeb_layout.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

// How far the field goes on from a curve to the extremum of its cap, of its whole range.
constexpr double depth_of_cap = 0.05;

// A loop turns where its direction in the face changes by more degrees; there it gets samples.
constexpr double turn = 40;

// Two samples that a loop must have are at least so many edges of the quads apart.
constexpr double apart = 1.5;

// A curve as it lies on the surface.
struct Curve {
  Sharp_curve_kind kind = Sharp_curve_kind::maximum;
  Sharp_loop loop;
  std::vector<int> faces;   // that it goes around
  std::vector<int> corners; // positions in the loop; four if the face is a cap itself
  int extremum = -1;        // of its cap

  bool is_cap() const {
    return kind == Sharp_curve_kind::cap_of_minimum || kind == Sharp_curve_kind::cap_of_maximum;
  }
  bool is_high() const {
    return kind == Sharp_curve_kind::maximum || kind == Sharp_curve_kind::cap_of_maximum;
  }
  double value() const {
    const double depth = is_cap() ? depth_of_cap : 0;
    return is_high() ? 1 - depth : depth;
  }
};

// The vertex of a face that is farthest from its loop, along edges; -1 if all its vertices lie on that.
int middle_of(const Triangle_surface& s, const Curve& curve) {
  std::vector<char> inside(std::size_t(s.number_of_faces()), 0);
  for (int f : curve.faces) inside[f] = 1;
  std::vector<double> distance(std::size_t(s.number_of_vertices()), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (int h : curve.loop.halfedges) {
    distance[s.source(h)] = 0;
    queue.push({0, s.source(h)});
  }
  int farthest = -1;
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance[v]) continue;
    if (d > 0 && (farthest < 0 || d > distance[farthest])) farthest = v;
    int h = s.outgoing[v];
    do {
      const int w = s.target(h);
      const double further = d + (s.points[w] - s.points[v]).norm();
      if (inside[h / 3] && further < distance[w]) {
        distance[w] = further;
        queue.push({further, w});
      }
      h = s.rotate_ccw(h);
    } while (h >= 0 && h != s.outgoing[v]);
  }
  return farthest;
}

class Curve_finder {
public:
  explicit Curve_finder(const Draft& draft)
      : m_draft(draft), m_surface(draft.surface()), m_taken(draft.surface().points.size(), 0) {}

  Result<Curve> find(const Set_extrema::Sharp_curve& asked) {
    if (!(asked.feature_angle > 0 && asked.feature_angle < 180))
      return make_error(Error_code::impossible_request,
                        "the angle of sharp edges lies between 0 and 180 degrees");
    if (asked.feature_angle != m_angle) m_patches = sharp_patches(m_surface, asked.feature_angle);
    m_angle = asked.feature_angle;
    const int face = m_draft.face_at(asked.face.point);
    const auto patch = std::find_if(m_patches.begin(), m_patches.end(), [&](const Sharp_patch& p) {
      return std::binary_search(p.faces.begin(), p.faces.end(), face);
    });
    if (patch->loops.empty())
      return refuse("no sharp edges go around that face", {}, Element_kind::face, face);
    Curve curve;
    curve.kind = asked.kind;
    curve.loop = nearest_loop(*patch, asked.at.point);
    curve.faces = patch->faces;
    if (!curve.loop.is_simple)
      return refuse("the sharp edges around that face touch themselves or the boundary", {},
                    Element_kind::face, face);
    if (Result<void> taken = take(curve.loop); !taken) return taken.error();
    if (curve.is_cap()) {
      if (patch->loops.size() > 1)
        return refuse("a cap is a face with one loop of sharp edges", {}, Element_kind::face, face);
      curve.corners = rectangle_in(m_surface, curve.loop);
      curve.extremum = middle_of(m_surface, curve);
      if (curve.extremum < 0)
        return refuse("the face has no vertex inside for an extremum", {}, Element_kind::face, face);
    }
    return curve;
  }

private:
  const Sharp_loop& nearest_loop(const Sharp_patch& patch, const Point& at) const {
    const Sharp_loop* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Sharp_loop& loop : patch.loops)
      for (int h : loop.halfedges)
        if (const double d = (m_surface.points[m_surface.source(h)] - at).squaredNorm(); d < least || !best) {
          least = d;
          best = &loop;
        }
    return *best;
  }

  Result<void> take(const Sharp_loop& loop) {
    for (int h : loop.halfedges) {
      const int v = m_surface.source(h);
      if (m_taken[v] || m_surface.is_boundary(m_surface.outgoing[v]))
        return refuse("curves touch each other or the boundary", {}, Element_kind::vertex, v);
      m_taken[v] = 1;
    }
    return {};
  }

  const Draft& m_draft;
  const Triangle_surface& m_surface;
  std::vector<char> m_taken;
  std::vector<Sharp_patch> m_patches;
  double m_angle = -1;
};

class Curve_designer {
public:
  Curve_designer(Draft& draft, std::vector<Curve> curves, std::vector<Design_extremum> extrema,
                 const std::vector<bool>& boundary_is_maximum)
      : m_draft(draft), m_surface(draft.surface()), m_curves(std::move(curves)),
        m_extrema(std::move(extrema)), m_boundary_is_maximum(boundary_is_maximum) {
    m_layout.network.surface_vertices = m_surface.number_of_vertices();
    m_layout.network.edges.resize(draft.network.edges.size()); // contours have different numbers for life
  }

  Result<void> run() {
    for (const Curve& curve : m_curves)
      if (curve.is_cap()) m_extrema.push_back({curve.extremum, curve.is_high(), curve.is_high() ? 1.0 : 0.0});
    sort_by_vertex(m_extrema);
    if (Result<void> fine = check(); !fine) return fine;
    add_contours();
    if (Result<void> going_on = m_draft.begin("field"); !going_on) return going_on;
    if (Result<void> solved = solve(); !solved) return solved;
    if (Result<void> going_on = m_draft.begin("layout"); !going_on) return going_on;
    if (Result<void> designed = design_parts(); !designed) return designed;
    return finish();
  }

private:
  Result<void> check() const {
    std::vector<char> on_curve(m_surface.points.size(), 0);
    for (const Curve& curve : m_curves)
      for (int h : curve.loop.halfedges) on_curve[m_surface.source(h)] = 1;
    for (std::size_t i = 0; i < m_extrema.size(); ++i) {
      const int v = m_extrema[i].vertex;
      if (on_curve[v]) return refuse("an extremum on a curve", {}, Element_kind::vertex, v);
      if (m_surface.is_boundary(m_surface.outgoing[v]))
        return refuse("an extremum on the boundary", {}, Element_kind::vertex, v);
      if (i > 0 && m_extrema[i - 1].vertex == v)
        return refuse("two extrema at one vertex", {}, Element_kind::vertex, v);
    }
    return {};
  }

  double edge_length() const {
    return m_draft.target_quads > 0 ? std::sqrt(area(m_surface) / m_draft.target_quads) : m_draft.edge_length;
  }

  // Where the loop must have samples: at its corners, and where it turns, as far as these lie apart.
  std::vector<std::pair<int, Node_kind>> nodes_of(const Curve& curve) const {
    std::vector<std::pair<int, Node_kind>> nodes;
    for (int i : curve.corners) nodes.push_back({i, Node_kind::corner});
    std::vector<double> along(1, 0.0);
    for (int h : curve.loop.halfedges)
      along.push_back(along.back() +
                      (m_surface.points[m_surface.target(h)] - m_surface.points[m_surface.source(h)]).norm());
    const double least = apart * edge_length();
    for (int i : turns_of(m_surface, curve.loop, turn, false)) {
      const bool is_near = std::any_of(nodes.begin(), nodes.end(), [&](const auto& node) {
        const double d = std::abs(along[node.first] - along[i]);
        return std::min(d, along.back() - d) < least;
      });
      if (!is_near) nodes.push_back({i, Node_kind::anchor});
    }
    if (nodes.empty()) nodes.push_back({0, Node_kind::regular});
    std::sort(nodes.begin(), nodes.end());
    return nodes;
  }

  void add_contours() {
    const std::vector<std::vector<int>> loops = boundary_loops(m_surface);
    for (std::size_t i = 0; i < loops.size(); ++i)
      add_boundary_contour(m_surface, loops[i], m_boundary_is_maximum[i], m_boundary_is_maximum[i],
                           m_layout.network);
    for (const Curve& curve : m_curves) add_contour(curve);
  }

  // From node to node. The face is on the left, which is the upper side of a cap of a maximum.
  void add_contour(const Curve& curve) {
    Contour_network& network = m_layout.network;
    const std::vector<std::pair<int, Node_kind>> nodes = nodes_of(curve);
    const std::vector<int>& halfedges = curve.loop.halfedges;
    const std::size_t n = halfedges.size(), first = network.nodes.size();
    for (const auto& [at, kind] : nodes)
      add_node(network, m_surface.source(halfedges[std::size_t(at)]), kind);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const std::size_t next = (i + 1) % nodes.size(), begin = std::size_t(nodes[i].first);
      std::size_t steps = (std::size_t(nodes[next].first) + n - begin) % n;
      if (steps == 0) steps = n;
      Contour_edge edge;
      edge.from = int(first + i);
      edge.to = int(first + next);
      for (std::size_t k = 0; k <= steps; ++k)
        edge.vertices.push_back(m_surface.source(halfedges[(begin + k) % n]));
      edge.faces.assign(steps, -1);
      edge.value = curve.value();
      if (curve.kind == Sharp_curve_kind::cap_of_minimum) reverse(edge);
      if (curve.kind == Sharp_curve_kind::maximum) edge.left = Side::high;
      if (curve.kind == Sharp_curve_kind::minimum) edge.right = Side::low;
      network.edges.push_back(std::move(edge));
    }
  }

  Result<void> solve() {
    m_field.boundary_is_maximum = m_boundary_is_maximum;
    for (const Design_extremum& e : m_extrema) {
      (e.is_maximum ? m_field.maxima : m_field.minima).push_back(e.vertex);
      m_field.extremal_values[e.vertex] = e.value;
    }
    for (const Curve& curve : m_curves)
      for (int h : curve.loop.halfedges) m_field.curve_values[m_surface.source(h)] = curve.value();
    if (Result<void> solved = m_draft.solver().solve(m_field); !solved)
      return refuse("the field cannot be solved", solved.error().message);
    return {};
  }

  Result<void> design_parts() {
    const Contour_network curves = m_layout.network; // without the contours of the parts before
    const Result<Embedding> embedding = embed(m_surface, curves);
    if (!embedding) return refuse("curves touch each other", embedding.error().message);
    std::vector<char> done(std::size_t(m_surface.number_of_faces()), 0);
    for (int f = 0; f < m_surface.number_of_faces(); ++f) {
      if (done[f]) continue;
      Result<Chart> part = cut_part(*embedding, curves, f);
      if (!part) return refuse("the regions between the curves cannot be designed", part.error().message);
      for (int g : part->face_origin) done[g] = 1;
      if (is_rectangle(*part)) continue;
      if (Result<void> designed = design(*part); !designed) return designed;
    }
    return {};
  }

  // A face that is its extremum's cap as it is.
  bool is_rectangle(const Chart& part) const {
    return std::any_of(m_curves.begin(), m_curves.end(), [&](const Curve& curve) {
      return curve.corners.size() == 4 && part.face_origin.front() == curve.faces.front() &&
             part.walks.size() == 1;
    });
  }

  // The field on a part. A vertex in the middle of a chord lies a little inside of its ends.
  Designed_field field_of(const Chart& part) const {
    const Triangle_surface& mesh = part.mesh;
    Designed_field field;
    const std::size_t known = part.vertex_origin.size() - part.split_chords.size();
    for (std::size_t v = 0; v < known; ++v)
      field.values.push_back(m_field.values[std::size_t(part.vertex_origin[v])]);
    for (std::size_t v = known; v < part.vertex_origin.size(); ++v) {
      double sum = 0;
      int number = 0;
      const int first = mesh.outgoing[v];
      int h = first;
      do {
        if (const std::size_t w = std::size_t(mesh.target(h)); w < field.values.size()) {
          sum += field.values[w];
          ++number;
        }
        h = mesh.rotate_ccw(h);
      } while (h >= 0 && h != first);
      field.values.push_back(sum / std::max(1, number));
    }
    for (std::size_t v = 0; v < known; ++v)
      if (const Design_extremum* e = extremum_at(part.vertex_origin[v]))
        (e->is_maximum ? field.maxima : field.minima).push_back(int(v));
    std::vector<bool> high(part.vertex_origin.size(), false);
    for (const Walk& walk : part.walks)
      for (int v : walk.vertices) high[std::size_t(v)] = walk.side == Side::high;
    for (const std::vector<int>& loop : boundary_loops(mesh))
      field.boundary_is_maximum.push_back(high[std::size_t(mesh.source(loop[0]))]);
    return field;
  }

  const Design_extremum* extremum_at(int vertex) const {
    const auto found = std::lower_bound(m_extrema.begin(), m_extrema.end(), vertex,
                                        [](const Design_extremum& e, int v) { return e.vertex < v; });
    return found != m_extrema.end() && found->vertex == vertex ? &*found : nullptr;
  }

  Result<void> design(const Chart& part) {
    Result<Reeb_layout> layout = make_layout(part.mesh, field_of(part));
    if (!layout) return refuse("a region between curves cannot be designed", layout.error().message);
    if (!layout->lost_extrema.empty())
      return refuse("the field does not have an extremum there", {}, Element_kind::vertex,
                    part.vertex_origin[std::size_t(layout->lost_extrema[0])]);
    std::vector<int> fresh;
    for (std::size_t e = 0; e < layout->network.edges.size(); ++e)
      if (layout->network.nodes[layout->network.edges[e].from].kind != Node_kind::boundary)
        fresh.push_back(int(e));
    m_layout.cleanup_rounds += layout->cleanup_rounds;
    for (std::size_t v = 0; v < part.vertex_origin.size(); ++v)
      if (const int origin = part.vertex_origin[v]; origin >= 0)
        m_field.values[std::size_t(origin)] = layout->values[v];
    const Result<std::vector<int>> added =
        transfer_contours(m_surface, part, layout->network, fresh, m_layout.network);
    if (!added) return added.error();
    return {};
  }

  Result<void> finish() {
    Result<Embedding> embedding = embed(m_surface, m_layout.network);
    if (!embedding) return refuse("contours come too near to curves", embedding.error().message);
    std::vector<int> vertices;
    for (const Design_extremum& e : m_extrema) vertices.push_back(e.vertex);
    Result<Atlas> atlas = build_atlas(*embedding, m_layout.network, vertices);
    if (!atlas)
      return refuse("the regions between the contours would not all be charts", atlas.error().message);
    m_layout.atlas = std::move(*atlas);
    m_layout.values = std::move(m_field.values);
    m_draft.adopt(std::move(m_layout));
    m_draft.extrema = std::move(m_extrema);
    return {};
  }

  Draft& m_draft;
  const Triangle_surface& m_surface;
  std::vector<Curve> m_curves;
  std::vector<Design_extremum> m_extrema;
  std::vector<bool> m_boundary_is_maximum;
  Designed_field m_field;
  Reeb_layout m_layout;
};

} // namespace

Result<void> design_on_curves(Draft& draft, std::vector<Design_extremum> extrema,
                              const std::vector<Set_extrema::Sharp_curve>& asked,
                              const std::vector<bool>& boundary_is_maximum) {
  Curve_finder finder(draft);
  std::vector<Curve> curves;
  for (const Set_extrema::Sharp_curve& one : asked) {
    Result<Curve> curve = finder.find(one);
    if (!curve) return curve.error();
    curves.push_back(std::move(*curve));
  }
  return Curve_designer(draft, std::move(curves), std::move(extrema), boundary_is_maximum).run();
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
