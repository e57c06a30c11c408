// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/certificate.h>

#include "certificate/intersections.h"
#include "certificate/outward.h"
#include "certificate/shape_measure.h"
#include "certificate/shared_intersections.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using namespace certification;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr int outward_samples = 1000; // per component: far more than a majority of the area needs

std::string text(std::int64_t n) {
  return std::to_string(n);
}

std::string where(const Point& p) {
  return "(" + std::to_string(p.x()) + ", " + std::to_string(p.y()) + ", " + std::to_string(p.z()) + ")";
}

// "1:2 3:8 8:4" for messages.
std::string text(const std::map<int, int>& histogram) {
  std::string result;
  for (const auto& [valence, count] : histogram)
    result += (result.empty() ? "" : " ") + text(valence) + ":" + text(count);
  return result.empty() ? "none" : result;
}

// Fills one certificate, check by check.
class Certifier {
public:
  Certifier(const Certificate_input& input, const Certificate_options& options)
      : m_mesh(input.quads), m_predicted(input.predicted_valences), m_as_read(input.as_read),
        m_quads_asked(input.quads_asked), m_options(options),
        m_topology(analyse(input.quads.quads, int(input.quads.points.size()), Fans::unknown)) {
    if (input.input) m_input.emplace(read_input(*input.input));
    m_expected = input.predicted_components;
    if (m_expected.empty() && m_input) m_expected = kinds(m_input->topology);
    std::sort(m_expected.begin(), m_expected.end());
  }

  Certificate run() {
    count();
    check_faces();
    check_points();
    check_manifold();
    check_against_input();
    check_valences();
    const Split_quads split = split_quads(m_mesh, m_topology.usable);
    const Triangle_tree tree(m_mesh.points, split.triangles);
    check_outward(split, tree);
    conclude_passed();
    check_inverted();
    check_intersections(split, tree);
    warn_of_input();
    check_distance(split, tree);
    return std::move(m_result);
  }

private:
  // Adds a check that passes if `measured == expected`; `sentence` is called if it does not.
  template <class Sentence>
  void add(const char* name, double measured, double expected, Element_kind element, std::int64_t index,
           Sentence&& sentence) {
    Certificate_check check{name, Check_status::passed, measured, expected, "", Element_kind::none, -1};
    if (measured != expected) {
      check.status = Check_status::failed;
      check.message = sentence();
      check.element = index < 0 ? Element_kind::none : element;
      check.index = index;
    }
    m_result.checks.push_back(std::move(check));
  }

  void skip(const char* name, std::string reason, double measured = unknown) {
    m_result.checks.push_back(
        {name, Check_status::not_checked, measured, unknown, std::move(reason), Element_kind::none, -1});
  }

  void count() {
    m_result.vertices = int(m_mesh.points.size());
    m_result.quads = int(m_mesh.quads.size());
    m_result.edges = m_topology.edges;
    m_result.components = m_topology.components;
    if (m_input) m_result.input_components = m_input->topology.components;
    for (int v = 0; v < int(m_mesh.points.size()); ++v)
      if (m_topology.valence[v] > 0)
        ++(m_topology.on_boundary[v] ? m_result.boundary_valences
                                     : m_result.interior_valences)[m_topology.valence[v]];
  }

  void check_faces() {
    const Finding &range = m_topology.bad_indices, &repeated = m_topology.repeated_vertices,
                  &twice = m_topology.duplicates;
    if (m_mesh.quads.empty()) {
      m_result.checks.push_back(
          {"all_quads", Check_status::failed, 0, 0, "the mesh has no quad", Element_kind::none, -1});
      return;
    }
    const int face = range.count > 0 ? range.element : repeated.count > 0 ? repeated.element : twice.element;
    add("all_quads", range.count + repeated.count + twice.count, 0, Element_kind::face, face, [&] {
      if (range.count > 0) return "quad " + text(face) + " names a vertex that does not exist";
      if (repeated.count > 0) return "quad " + text(face) + " names a vertex twice";
      return "quad " + text(face) + " has the vertices of quad " + text(twice.other);
    });
  }

  void check_points() {
    Finding infinite;
    for (int v = 0; v < int(m_mesh.points.size()); ++v)
      if (!m_mesh.points[v].allFinite()) infinite.note(v);
    add("finite_points", infinite.count, 0, Element_kind::vertex, infinite.element,
        [&] { return "vertex " + text(infinite.element) + " has a coordinate that is not finite"; });
    const Finding& idle = m_topology.unreferenced;
    add("no_unreferenced_vertices", idle.count, 0, Element_kind::vertex, idle.element,
        [&] { return "vertex " + text(idle.element) + " belongs to no quad"; });
  }

  void check_manifold() {
    const Finding &crowded = m_topology.crowded_edges, &fans = m_topology.several_fans,
                  &turned = m_topology.misdirected_edges;
    add("manifold_edges", crowded.count, 0, Element_kind::edge, crowded.element,
        [&] { return edge(crowded) + " has more than two quads"; });
    add("manifold_vertices", fans.count, 0, Element_kind::vertex, fans.element,
        [&] { return vertex(fans.element) + ": its quads are not one fan"; });
    add("oriented", turned.count, 0, Element_kind::edge, turned.element,
        [&] { return "the two quads of " + edge(turned) + " run along it in the same direction"; });
  }

  // The Euler characteristic and boundary loops of each component, in order.
  static std::vector<std::pair<int, int>> kinds(const Soup_topology& topology) {
    std::vector<std::pair<int, int>> result;
    for (const Component_counts& c : topology.components)
      result.emplace_back(c.euler_characteristic(), c.boundary_loops);
    std::sort(result.begin(), result.end());
    return result;
  }

  void check_against_input() {
    const int loops = m_topology.boundary_loops();
    int expected_loops = 0;
    for (const auto& component : m_expected) expected_loops += component.second;
    const auto first = std::find(m_topology.on_boundary.begin(), m_topology.on_boundary.end(), 1);
    const int v = first == m_topology.on_boundary.end() ? -1 : int(first - m_topology.on_boundary.begin());
    add("watertight", loops, expected_loops, Element_kind::vertex, v, [&] {
      return "boundary loops: " + text(loops) + ", expected: " + text(expected_loops) +
             (v >= 0 ? "; one is at " + vertex(v) : "");
    });
    if (m_expected.empty()) {
      skip("components", "no input to compare with", double(m_topology.components.size()));
      skip("euler_characteristic", "no input to compare with", m_topology.euler_characteristic());
      return;
    }
    const double found = double(m_topology.components.size()), wanted = double(m_expected.size());
    add("components", found, wanted, Element_kind::none, -1, [&] {
      return "components: " + text(std::int64_t(found)) + ", expected: " + text(std::int64_t(wanted));
    });
    check_euler_characteristic();
  }

  // Equal sums are not enough: a sphere and a double torus have that of two tori.
  void check_euler_characteristic() {
    const auto mine = kinds(m_topology);
    const int chi = m_topology.euler_characteristic();
    int expected = 0;
    for (const auto& component : m_expected) expected += component.first;
    add("euler_characteristic", chi, expected, Element_kind::none, -1,
        [&] { return "the Euler characteristic is " + text(chi) + ", not " + text(expected); });
    if (chi != expected || mine == m_expected) return;
    const auto a = std::mismatch(mine.begin(), mine.end(), m_expected.begin(), m_expected.end()).first;
    Certificate_check& check = m_result.checks.back();
    check.status = Check_status::failed;
    check.message = a == mine.end() ? "a component is missing"
                                    : "no component of the input left has the Euler characteristic " +
                                          text(a->first) + " and " + text(a->second) + " boundary loops";
  }

  void check_valences() {
    if (m_predicted) {
      std::map<int, int> excess = m_result.interior_valences;
      for (const auto& [valence, count] : *m_predicted) excess[valence] -= count;
      if (m_predicted->count(4) == 0) excess.erase(4);
      int deviation = 0, worst = -1;
      for (const auto& [valence, count] : excess) {
        deviation += std::abs(count);
        if (count > 0 && worst < 0) worst = valence;
      }
      const int v = worst < 0 ? -1 : interior_vertex_of_valence(worst);
      add("valences", deviation, 0, Element_kind::vertex, v, [&] {
        return "the interior valences are " + text(m_result.interior_valences) + ", predicted were " +
               text(*m_predicted) + (v >= 0 ? "; " + vertex(v) + " has valence " + text(worst) : "");
      });
    } else
      skip("valences", "nothing was predicted");

    std::int64_t sum = 0;
    for (const auto& [valence, count] : m_result.interior_valences) sum += std::int64_t(4 - valence) * count;
    for (const auto& [valence, count] : m_result.boundary_valences) sum += std::int64_t(3 - valence) * count;
    const std::int64_t expected = 4 * std::int64_t(m_topology.euler_characteristic());
    add("valence_sum", double(sum), double(expected), Element_kind::none, -1, [&] {
      return "the sum of 4 - valence (3 - valence on the boundary) is " + text(sum) + ", not " +
             text(expected);
    });
  }

  int interior_vertex_of_valence(int valence) const {
    for (int v = 0; v < int(m_mesh.points.size()); ++v)
      if (m_topology.valence[v] == valence && !m_topology.on_boundary[v]) return v;
    return -1;
  }

  // From the input to the quads, because a tree over the quads is small whatever the size of the input.
  void check_outward(const Split_quads& split, const Triangle_tree& tree) {
    if (!m_input) return skip("outward", "no input to compare with");
    if (tree.empty() || m_input->triangles.empty()) return skip("outward", "there is no surface to compare");
    const std::vector<Facing> facing =
        compare_facing(m_mesh, m_topology, split, tree, *m_input, outward_samples);
    double agreeing_area = 0, area = 0;
    Finding turned, known;
    for (int c = 0; c < int(facing.size()); ++c) {
      agreeing_area += facing[c].agreeing;
      area += facing[c].agreeing + facing[c].opposed;
      if (facing[c].is_known) known.note(c);
      if (facing[c].is_turned) turned.note(c);
    }
    const double part = area > 0 ? agreeing_area / area : unknown;
    if (known.count == 0)
      return skip("outward", "front and back are too near to each other to tell them apart", part);
    Certificate_check check{"outward", Check_status::passed, part, 1, "", Element_kind::none, -1};
    if (turned.count > 0) {
      check.status = Check_status::failed;
      check.message = "component " + text(turned.element) + " is turned inside out";
      check.element = Element_kind::component;
      check.index = turned.element;
    }
    m_result.checks.push_back(std::move(check));
  }

  void conclude_passed() {
    m_result.passed =
        std::none_of(m_result.checks.begin(), m_result.checks.end(),
                     [](const Certificate_check& c) { return c.status == Check_status::failed; });
    m_result.strictly_valid = m_result.passed;
  }

  void check_inverted() {
    for (int q = 0; q < int(m_mesh.quads.size()); ++q)
      if (m_topology.usable[q] && !(scaled_jacobian(corners(m_mesh, q)) > 0))
        m_result.inverted_quads.push_back(q);
    const int q = m_result.inverted_quads.empty() ? -1 : m_result.inverted_quads.front();
    add("no_inverted_quads", double(m_result.inverted_quads.size()), 0, Element_kind::face, q, [&] {
      return "quad " + text(q) + " at " + where(m_mesh.points[m_mesh.quads[q][0]]) +
             " is inverted at a corner";
    });
    if (q >= 0) m_result.strictly_valid = false;
  }

  void check_intersections(const Split_quads& split, const Triangle_tree& tree) {
    const char* name = "no_self_intersections";
    auto pairs = m_options.find_self_intersections
                     ? intersecting_quads(m_mesh.points, split, tree, m_options.maximum_intersections,
                                          m_options.observer)
                     : std::nullopt;
    if (!pairs) {
      skip(name, m_options.find_self_intersections ? "cancelled" : "not asked for");
      m_result.strictly_valid = false;
      return;
    }
    m_result.intersecting_quads = std::move(*pairs);
    const auto first = own_intersection();
    if (!first) return cancel_intersections(name);
    const int all = int(m_result.intersecting_quads.size()), n = all - m_result.input_intersections;
    add(name, n, 0, Element_kind::face, first->first, [&] {
      return "quads " + text(first->first) + " and " + text(first->second) + " intersect" +
             (all >= m_options.maximum_intersections
                  ? "; at least " + text(all) + " pairs do, more were not sought"
                  : "");
    });
    m_result.valid_as_input = m_result.strictly_valid && n == 0;
    if (all > 0) m_result.strictly_valid = false;
  }

  // The first pair that intersects where the input does not, or (-1, -1); counts those where it does.
  std::optional<std::pair<int, int>> own_intersection() {
    const auto& pairs = m_result.intersecting_quads;
    std::pair<int, int> first(-1, -1);
    if (!m_input || pairs.empty()) return pairs.empty() ? first : pairs.front();
    const auto shared = are_in_input(pairs, m_mesh, m_topology, *m_input, m_options.observer);
    if (!shared) return std::nullopt;
    m_result.input_intersections = int(std::count(shared->begin(), shared->end(), 1));
    const auto own = std::find(shared->begin(), shared->end(), 0);
    return own == shared->end() ? first : pairs[std::size_t(own - shared->begin())];
  }

  void cancel_intersections(const char* name) {
    skip(name, "cancelled");
    m_result.strictly_valid = false;
  }

  void warn_of_input() {
    const int n = m_result.input_intersections;
    if (n == 0) return;
    m_result.warnings.push_back({"input_intersections", double(n), 0,
                                 "the input intersects itself: " + text(n) + (n == 1 ? " pair" : " pairs") +
                                     " of quads meet where its triangles do"});
  }

  // Against the surface as it was read, if there is that.
  void check_distance(const Split_quads& split, const Triangle_tree& tree) {
    if (!m_input && !m_as_read) return skip("distance", "no input to compare with");
    if (!m_options.measure_shape) return skip("distance", "not asked for");
    const Input_surface& input = m_as_read ? m_input.emplace(read_soup(*m_as_read)) : *m_input;
    if (tree.empty() || input.triangles.empty()) return skip("distance", "there is no surface to compare");
    m_result.shape = measure_shape(m_mesh, m_topology.usable, split, tree, input, m_options);
    if (!m_result.shape) return skip("distance", "cancelled");
    m_result.shape->quads = m_topology.faces;
    m_result.shape->quads_asked = m_quads_asked;
    const auto warnings = shape_warnings(*m_result.shape, m_options.limits);
    m_result.warnings.insert(m_result.warnings.end(), warnings.begin(), warnings.end());
    const double distance = m_result.shape->bound(), limit = m_options.maximum_distance;
    if (std::isinf(limit)) return skip("distance", "measured, without a limit", distance);
    Certificate_check check{"distance", Check_status::passed, distance, limit, "", Element_kind::none, -1};
    if (!(distance <= limit)) {
      check.status = Check_status::failed;
      check.message = "the quads and the input are up to " + std::to_string(distance) + " diagonals apart";
    }
    m_result.checks.push_back(std::move(check));
  }

  std::string vertex(int v) const { return "vertex " + text(v) + " at " + where(m_mesh.points[v]); }
  std::string edge(const Finding& f) const {
    return "the edge from vertex " + text(f.element) + " to vertex " + text(f.other);
  }

  const Quad_mesh& m_mesh;
  const std::optional<std::map<int, int>>& m_predicted;
  const Triangle_surface* m_as_read;
  int m_quads_asked;
  const Certificate_options& m_options;
  Soup_topology m_topology;
  std::optional<Input_surface> m_input;
  std::vector<std::pair<int, int>> m_expected; ///< Euler characteristic and boundary loops of each component
  Certificate m_result;
};

} // namespace

const Certificate_check& Certificate::check(const std::string& name) const {
  const auto found =
      std::find_if(checks.begin(), checks.end(), [&](const Certificate_check& c) { return c.name == name; });
  CGAL_precondition(found != checks.end());
  return *found;
}

Certificate certify(const Certificate_input& input, const Certificate_options& options) {
  return Certifier(input, options).run();
}

const char* name(Check_status status) {
  switch (status) {
  case Check_status::passed: return "passed";
  case Check_status::failed: return "failed";
  case Check_status::not_checked: return "not_checked";
  }
  return "unknown";
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
