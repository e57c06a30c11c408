// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/certificate.h>

#include "certificate/distance.h"
#include "certificate/geometry.h"
#include "certificate/intersections.h"
#include "certificate/topology.h"
#include "certificate/tree.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using namespace certification;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr int outward_samples = 4000; // per component: far more than a majority of the area needs

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
      : m_mesh(input.quads), m_predicted(input.predicted_valences), m_options(options),
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
    check_distance(tree);
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
    std::vector<double> agreeing(m_topology.components.size(), 0), opposed = agreeing;
    int last = -1;
    for (const Input_sample& sample : sample_triangles(*m_input, outward_samples)) {
      last = tree.nearest(sample.centre, last).triangle;
      const int quad = split.quad[last];
      const double cosine = sample.vector_area.dot(vector_area(corners(m_mesh, quad)));
      const int component = m_topology.component[m_mesh.quads[quad][0]];
      if (cosine > 0) agreeing[component] += sample.vector_area.norm();
      if (cosine < 0) opposed[component] += sample.vector_area.norm();
    }
    double agreeing_area = 0, area = 0;
    Finding turned;
    for (int c = 0; c < int(agreeing.size()); ++c) {
      agreeing_area += agreeing[c];
      area += agreeing[c] + opposed[c];
      if (opposed[c] > 0 && opposed[c] >= agreeing[c]) turned.note(c);
    }
    Certificate_check check{"outward", Check_status::passed, agreeing_area / area, 1, "", Element_kind::none,
                            -1};
    if (turned.count > 0 || !(area > 0)) {
      check.status = Check_status::failed;
      check.message = turned.count == 0 ? "no quad has a normal to compare with the input's"
                                        : "component " + text(turned.element) + " is turned inside out";
      check.element = turned.count == 0 ? Element_kind::none : Element_kind::component;
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
    const int n = int(m_result.intersecting_quads.size());
    const auto first = n > 0 ? m_result.intersecting_quads.front() : std::pair<int, int>(-1, -1);
    add(name, n, 0, Element_kind::face, first.first, [&] {
      return "quads " + text(first.first) + " and " + text(first.second) + " intersect" +
             (n >= m_options.maximum_intersections
                  ? "; at least " + text(n) + " pairs do, more were not sought"
                  : "");
    });
    if (n > 0) m_result.strictly_valid = false;
  }

  void check_distance(const Triangle_tree& tree) {
    if (!m_input) return skip("distance", "no input to compare with");
    if (!m_options.measure_distance) return skip("distance", "not asked for");
    if (tree.empty() || m_input->triangles.empty()) return skip("distance", "there is no surface to compare");
    m_result.distance = measure_distance(m_mesh, m_topology.usable, tree, *m_input, m_options);
    if (!m_result.distance) return skip("distance", "cancelled");
    const double distance = m_result.distance->maximum(), limit = m_options.maximum_distance;
    if (std::isinf(limit)) return skip("distance", "measured, without a limit", distance);
    Certificate_check check{"distance", Check_status::passed, distance, limit, "", Element_kind::none, -1};
    if (!(distance <= limit)) {
      check.status = Check_status::failed;
      check.message = "the quads and the input are " + std::to_string(distance) + " diagonals apart";
    }
    m_result.checks.push_back(std::move(check));
  }

  std::string vertex(int v) const { return "vertex " + text(v) + " at " + where(m_mesh.points[v]); }
  std::string edge(const Finding& f) const {
    return "the edge from vertex " + text(f.element) + " to vertex " + text(f.other);
  }

  const Quad_mesh& m_mesh;
  const std::optional<std::map<int, int>>& m_predicted;
  const Certificate_options& m_options;
  Soup_topology m_topology;
  std::optional<Input_surface> m_input;
  std::vector<std::pair<int, int>> m_expected; ///< Euler characteristic and boundary loops of each component
  Certificate m_result;
};

} // namespace

double Certificate_distance::maximum() const {
  return std::max({vertices.maximum, centres.maximum, input_vertices.maximum});
}

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
