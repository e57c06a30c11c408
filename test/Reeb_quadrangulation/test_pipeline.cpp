// SPDX-License-Identifier: GPL-3.0-or-later
// From a surface to certified quads in one call: real models, placed extrema, scales, threads.
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>

#include "layout_stages.h"
#include "model_files.h"

using namespace CGAL::Reeb_quadrangulation;

namespace {

Quadrangulation quads_of(const Triangle_surface& s, const Quadrangulation_options& options) {
  Result<Quadrangulation> result = quadrangulate(s, options);
  INFO((result ? std::string() : result.error().message));
  REQUIRE(bool(result));
  return std::move(*result);
}

std::vector<int> extremal_vertices(const Quadrangulation& q, bool maxima) {
  std::vector<int> vertices;
  for (const Design_extremum& e : q.editor.design().extrema)
    if (e.is_maximum == maxima) vertices.push_back(e.vertex);
  return vertices;
}

std::vector<int> saddles(const Design& design) {
  std::vector<int> vertices;
  for (const Contour_node& node : design.network.nodes)
    if (node.kind == Node_kind::saddle) vertices.push_back(node.vertex);
  return vertices;
}

// Of the saddles: one less than half of the contours' ends there.
std::vector<int> multiplicities(const Design& design) {
  std::map<int, int> ends;
  for (const Contour_edge& e : design.network.edges)
    if (!design.network.is_removed(e))
      for (int node : {e.from, e.to})
        if (design.network.nodes[node].kind == Node_kind::saddle) ++ends[node];
  std::vector<int> result;
  for (const auto& [node, number] : ends) result.push_back(number / 2 - 1);
  return result;
}

Quadrangulation_options unrelaxed(int quads) {
  Quadrangulation_options options;
  options.quads = quads;
  options.relax = false;
  return options;
}

// Without the search of alignments: of those that are worth the same, rounding decides.
Quadrangulation_options in_place(int quads) {
  Quadrangulation_options options = unrelaxed(quads);
  options.align = false;
  return options;
}

Triangle_surface moved(Triangle_surface s, double scale, const Point& shift) {
  for (Point& p : s.points) p = scale * p + shift;
  return s;
}

double diagonal(const Triangle_surface& s) {
  Point low = s.points[0], high = low;
  for (const Point& p : s.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

const std::vector<std::string> small_models{
    "eight_low.off",   "helmet_g3.off", "elk.off",  "rocker_arm_2500.obj",
    "coupling_g9.off", "goathead.obj",  "knot.off", "wingnut.obj"};
const std::vector<std::string> open_models{"punctured_torus.obj", "annulus.obj", "aqua_center_open.off"};

} // namespace

TEST_CASE("real closed models: certified quads, 4 E vertices of valence 3 and S of valence 8, about as many "
          "as asked",
          "[models]") {
  for (const std::string& file : small_models) {
    const std::optional<Triangle_surface> found = model(file);
    if (!found) continue;
    const Triangle_surface& s = *found;
    INFO(file);
    const Quadrangulation q = quads_of(s, unrelaxed(2000));
    CHECK(stages::faults(q.mesh, s, q.valences) == "");
    CHECK(q.flipped_triangles == 0);
    const Design& design = q.editor.design();
    std::map<int, int> wanted;
    wanted[3] = 4 * int(design.extrema.size());
    const std::vector<int> multiplicity = multiplicities(design);
    for (int k : multiplicity) ++wanted[4 * (k + 1)];
    std::map<int, int> predicted = q.valences;
    predicted.erase(4);
    CHECK(predicted == wanted);
    if (q.editor.design().counts.target_met) CHECK(std::abs(int(q.mesh.quads.size()) - 2000) <= 100);
    CHECK(q.mesh.quads.size() == q.chart_of_quad.size());
    CHECK(q.mesh.quads.size() == std::size_t(design.counts.quads));
    if (multiplicity == std::vector<int>(multiplicity.size(), 1) && q.collapsed_charts == 0)
      CHECK(reeb_graph(design.atlas, design.network).loops() == q.genus);
  }
}

TEST_CASE("real open models: certified quads, boundary loops kept, as many quads as asked", "[models]") {
  for (const std::string& file : open_models) {
    const std::optional<Triangle_surface> found = model(file);
    if (!found) continue;
    const Triangle_surface& s = *found;
    INFO(file);
    const Quadrangulation q = quads_of(s, unrelaxed(2000));
    CHECK(stages::faults(q.mesh, s, q.valences) == "");
    CHECK(q.flipped_triangles == 0);
    CHECK((!q.editor.design().counts.target_met || std::abs(int(q.mesh.quads.size()) - 2000) <= 100));
  }
}

TEST_CASE("collapsing thin charts changes no extraordinary vertex", "[models]") {
  const std::optional<Triangle_surface> found = model("coupling_g9.off");
  if (!found) return;
  const Triangle_surface& s = *found;
  Quadrangulation_options options = unrelaxed(2000);
  const Quadrangulation thick = quads_of(s, options);
  options.collapse_thin = false;
  const Quadrangulation thin = quads_of(s, options);
  CHECK(thick.collapsed_charts > 0);
  CHECK(thin.collapsed_charts == 0);
  CHECK(int(thin.editor.design().charts.size()) ==
        int(thick.editor.design().charts.size()) + thick.collapsed_charts);
  std::map<int, int> a = thick.valences, b = thin.valences;
  a.erase(4);
  b.erase(4);
  CHECK(a == b);
  CHECK(stages::faults(thin.mesh, s, thin.valences) == "");
}

TEST_CASE("scale and place of the surface do not matter to the connectivity", "[models]") {
  for (const std::string file : {"rocker_arm_2500.obj", "eight_low.off", "elk.off"}) {
    const std::optional<Triangle_surface> found = model(file);
    if (!found) continue;
    const Triangle_surface& s = *found;
    const Quadrangulation q = quads_of(s, in_place(1000));
    const double d = diagonal(s);
    const std::pair<const char*, Triangle_surface> others[] = {
        {"100 times larger", moved(s, 100, Point(0, 0, 0))},
        {"1000 times smaller", moved(s, 1e-3, Point(0, 0, 0))},
        {"1000 diagonals away", moved(s, 1, 1000 * d * Point(1, 1, 1).normalized())}};
    for (const auto& [what, other] : others) {
      INFO(file << ", " << what);
      const Quadrangulation r = quads_of(other, in_place(1000));
      CHECK(extremal_vertices(r, false) == extremal_vertices(q, false));
      CHECK(extremal_vertices(r, true) == extremal_vertices(q, true));
      CHECK(saddles(r.editor.design()) == saddles(q.editor.design()));
      CHECK(r.editor.design().samples.counts == q.editor.design().samples.counts);
      CHECK(r.mesh.quads == q.mesh.quads);
    }
  }
}

TEST_CASE("one thread and two give the same bytes", "[models]") {
  for (const std::string file : {"eight_low.off", "goathead.obj"}) {
    const std::optional<Triangle_surface> found = model(file);
    if (!found) continue;
    const Triangle_surface& s = *found;
    Quadrangulation_options options;
    options.quads = 1000;
    options.threads = 1;
    const Quadrangulation one = quads_of(s, options);
    options.threads = 2;
    const Quadrangulation two = quads_of(s, options);
    CHECK(one.mesh.quads == two.mesh.quads);
    CHECK(one.mesh.points == two.mesh.points);
  }
}

TEST_CASE("relaxation moves vertices and keeps the connectivity") {
  const Triangle_surface s = tiny::subdivided(tiny::torus(24, 16));
  Quadrangulation_options options = unrelaxed(800);
  const Quadrangulation raw = quads_of(s, options);
  options.relax = true;
  const Quadrangulation relaxed = quads_of(s, options);
  CHECK(raw.mesh.quads == relaxed.mesh.quads);
  CHECK(raw.mesh.points != relaxed.mesh.points);
  const Certificate certificate = certify({relaxed.mesh, &s, relaxed.valences});
  CHECK(certificate.passed);
  CHECK(certificate.inverted_quads.empty());
}

TEST_CASE("a fold that is narrower than the quads is cut off, so that they do not meet; no two vertices come "
          "together",
          "[models]") {
  for (const std::string file : {"cow.off", "coupling_g9.off"}) {
    const std::optional<Triangle_surface> found = model(file);
    if (!found) continue;
    const Triangle_surface& s = *found;
    INFO(file);
    Quadrangulation_options options;
    options.quads = 3000;
    const Quadrangulation q = quads_of(s, options);
    CHECK(certify({q.mesh, &s, q.valences}).strictly_valid);
    if (file == "cow.off") CHECK(!q.relaxation.off_surface.empty());
    const Mesh_statistics statistics = quad_statistics(q.mesh, &s);
    CHECK(statistics.edge_length.minimum > 1e-3 * statistics.edge_length.mean);
  }
}

TEST_CASE("extrema placed by hand replace the suggested ones") {
  const Triangle_surface s = tiny::subdivided(tiny::double_torus(12, 9));
  Quadrangulation_options options = unrelaxed(600);
  options.prepare = false;
  options.extrema = {{s.points[3], false}, {s.points[50], true}, {s.points[90], true}};
  const Quadrangulation q = quads_of(s, options);
  CHECK(extremal_vertices(q, false) == std::vector<int>{3});
  CHECK(extremal_vertices(q, true) == std::vector<int>{50, 90});
  CHECK(q.genus == 2);
  CHECK(stages::faults(q.mesh, s, q.valences) == "");
  CHECK(q.valences.at(3) == 12);
}

TEST_CASE("the edge length rules where it is given") {
  const Triangle_surface s = tiny::subdivided(tiny::torus(16, 12));
  Quadrangulation_options options = unrelaxed(1);
  options.edge_length = 0.1;
  const Quadrangulation q = quads_of(s, options);
  CHECK(q.editor.design().edge_length == Approx(0.1));
  options.edge_length = 0.05;
  CHECK(quads_of(s, options).mesh.quads.size() > 3 * q.mesh.quads.size());
}

TEST_CASE("what cannot be done is refused with a reason") {
  const Triangle_surface s = tiny::torus(8, 7);
  const auto code = [](const Triangle_surface& surface, const Quadrangulation_options& options) {
    const auto result = quadrangulate(surface, options);
    REQUIRE_FALSE(result);
    CHECK_FALSE(result.error().message.empty());
    return result.error().code;
  };
  CHECK(code(Triangle_surface(), {}) == Error_code::not_a_surface);
  Triangle_surface two = s;
  for (const Point& p : s.points) two.points.push_back(p + Point(5, 0, 0));
  const int n = s.number_of_vertices();
  for (const Triangle& t : s.triangles) two.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  CHECK(code(tiny::connected(two), {}) == Error_code::not_a_surface);
  CHECK(code(s, unrelaxed(0)) == Error_code::impossible_request);
  Quadrangulation_options options = unrelaxed(500);
  options.extrema = {{s.points[0], false}};
  CHECK(code(s, options) == Error_code::impossible_request);
  options.extrema = {{s.points[0], false}, {s.points[0], true}};
  CHECK(code(s, options) == Error_code::refused_edit);
}

namespace {

class Impatient : public Observer {
public:
  void progress(const std::string& stage, double) override { m_stop = stage == "charts"; }
  bool cancelled() const override { return m_stop; }

private:
  bool m_stop = false;
};

} // namespace

TEST_CASE("a run can be cancelled in the middle") {
  Impatient observer;
  const auto result = quadrangulate(tiny::subdivided(tiny::torus(16, 12)), {}, &observer);
  REQUIRE_FALSE(result);
  CHECK(result.error().code == Error_code::cancelled);
}

TEST_CASE("random placed extrema: the call gives certified quads") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    tiny::Random random(seed);
    const Triangle_surface s = seed % 3 == 0   ? tiny::torus(8, 7)
                               : seed % 3 == 1 ? tiny::boxes({"#####", "#.#.#", "#####"})
                                               : tiny::subdivided(tiny::octahedron());
    Quadrangulation_options options = unrelaxed(300);
    std::vector<int> used;
    for (int i = 2 + random.below(5); i > 0; --i) {
      const int v = random.below(s.number_of_vertices());
      if (std::find(used.begin(), used.end(), v) != used.end()) continue;
      used.push_back(v);
      options.extrema.push_back({s.points[v], used.size() == 2 || (used.size() > 2 && random.below(2) == 1)});
    }
    if (used.size() < 2) continue;
    INFO("seed " << seed);
    const Quadrangulation q = quads_of(s, options);
    CHECK(stages::faults(q.mesh, s, q.valences) == "");
    CHECK(q.flipped_triangles == 0);
  }
}
