// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Dirichlet_problem.h>
#include <CGAL/Reeb_quadrangulation/Harmonic_field.h>

#include "model_files.h"
#include "tiny_surfaces.h"

#include <Eigen/Dense>

#include <cstring>
#include <fstream>
#include <sstream>

using namespace CGAL::Reeb_quadrangulation;

namespace {

Eigen::MatrixXd dense(const Symmetric_matrix& m) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(m.size, m.size);
  for (int j = 0; j < m.size; ++j)
    for (int k = m.column_begin[j]; k < m.column_begin[j + 1]; ++k)
      a(m.row[k], j) = a(j, m.row[k]) = m.value[k];
  return a;
}

// The Laplacian entry by entry from its definition, with the angles measured by acos.
Eigen::MatrixXd laplacian_by_definition(const Triangle_surface& s) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(s.number_of_vertices(), s.number_of_vertices());
  for (const Triangle& t : s.triangles)
    for (int i = 0; i < 3; ++i) {
      const Point u = s.points[t[(i + 1) % 3]] - s.points[t[i]],
                  v = s.points[t[(i + 2) % 3]] - s.points[t[i]];
      const double w = 0.5 / std::tan(std::acos(u.dot(v) / (u.norm() * v.norm())));
      const int p = t[(i + 1) % 3], q = t[(i + 2) % 3];
      a(p, q) -= w;
      a(q, p) -= w;
      a(p, p) += w;
      a(q, q) += w;
    }
  return a;
}

} // namespace

TEST_CASE("the assembled Laplacian is the one of the definition") {
  for (const Triangle_surface& s :
       {tiny::tetrahedron(), tiny::octahedron(), tiny::torus(5, 4), tiny::open_cylinder(5, 3)}) {
    const Laplace_system system = assemble(s, cotangent_weights(s));
    CHECK(bool(check_pattern(system.matrix)));
    CHECK((dense(system.matrix) - laplacian_by_definition(s)).cwiseAbs().maxCoeff() < 1e-13);
    for (int h = 0; h < s.number_of_halfedges(); ++h)
      CHECK(system.matrix.value[system.entry_of_halfedge[h]] == -cotangent_weights(s).of_halfedge[h]);
  }
}

TEST_CASE("eliminating vertices keeps the other rows and moves the rest to the right-hand side") {
  const Triangle_surface s = tiny::torus(6, 5);
  const Edge_weights weights = clamped_cotangent_weights(s);
  std::vector<char> fixed(s.points.size(), 0);
  std::vector<double> values(s.points.size(), 0.0);
  for (const int v : {3, 4, 17}) {
    fixed[v] = 1;
    values[v] = 0.25 * v;
  }
  const Laplace_system system = assemble(s, weights, fixed);
  const Eigen::MatrixXd full = dense(assemble(s, weights).matrix), reduced = dense(system.matrix);
  const std::vector<double> b = right_hand_side(s, weights, system, values);
  CHECK(bool(check_pattern(system.matrix)));
  REQUIRE(system.matrix.size == int(s.points.size()) - 3);
  for (int i = 0; i < system.matrix.size; ++i) {
    const int u = system.vertex_of_unknown[i];
    CHECK(system.unknown_of_vertex[u] == i);
    double expected = 0;
    for (const int v : {3, 4, 17}) expected -= full(u, v) * values[v];
    CHECK(b[i] == Approx(expected).margin(1e-14));
    for (int j = 0; j < system.matrix.size; ++j)
      CHECK(reduced(i, j) == Approx(full(u, system.vertex_of_unknown[j])).margin(1e-13));
  }
}

TEST_CASE("on an open cylinder the field is the height") {
  const Triangle_surface s = tiny::open_cylinder(7, 6, 2.0);
  Harmonic_field field(s);
  for (int i = 0; i < 7; ++i) {
    REQUIRE(bool(field.set_constraint(i, 0)));
    REQUIRE(bool(field.set_constraint(6 * 7 + i, 1)));
  }
  const auto f = field.solve();
  REQUIRE(bool(f));
  for (std::size_t v = 0; v < s.points.size(); ++v)
    CHECK((*f)[v] == Approx(s.points[v].z() / 2).margin(1e-12));
}

TEST_CASE("a component without a constraint is refused by a vertex of it") {
  Triangle_surface two = tiny::tetrahedron();
  const Triangle_surface other = tiny::octahedron();
  for (const Point& p : other.points) two.points.push_back(p);
  for (const Triangle& t : other.triangles) two.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
  REQUIRE(bool(two.connect()));
  Harmonic_field field(two);
  CHECK(field.solve().error().index == 0);
  REQUIRE(bool(field.set_constraint(1, 0.5)));
  CHECK(field.solve().error().index == 4);
  CHECK(field.solve().error().code == Error_code::impossible_request);
  REQUIRE(bool(field.set_constraint(9, 2)));
  const auto f = field.solve();
  REQUIRE(bool(f));
  for (int v = 0; v < 10; ++v) CHECK((*f)[v] == Approx(v < 4 ? 0.5 : 2));
  CHECK(!field.set_constraint(10, 0));
  CHECK(!field.set_constraint(0, std::nan("")));
}

namespace {

// A torus whose triangles have obtuse angles, so that cotangents are negative on some edges.
Triangle_surface sheared_torus(int m, int n, double shear) {
  Triangle_surface s = tiny::torus(m, n);
  for (Point& p : s.points) p += shear * Point(p.y() * p.z(), p.z() - p.x(), p.x() * p.y());
  return s;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double d = 0;
  for (std::size_t i = 0; i < a.size(); ++i) d = std::max(d, std::abs(a[i] - b[i]));
  return d;
}

int unconstrained_extrema(const Triangle_surface& s, const std::vector<double>& f,
                          const std::map<int, double>& fixed) {
  std::vector<char> lower(f.size(), 0), higher(f.size(), 0);
  for (int h = 0; h < s.number_of_halfedges(); ++h) {
    const int u = s.source(h), v = s.target(h);
    const bool below = f[v] != f[u] ? f[v] < f[u] : v < u;
    (below ? lower[u] : higher[u]) = 1;
    (below ? higher[v] : lower[v]) = 1;
  }
  int count = 0;
  for (std::size_t v = 0; v < f.size(); ++v) count += lower[v] != higher[v] && !fixed.count(int(v));
  return count;
}

} // namespace

TEST_CASE("weights are half the sum of the opposite cotangents, clamped where asked") {
  const Edge_weights octahedron = cotangent_weights(tiny::octahedron());
  for (const double w : octahedron.of_halfedge) CHECK(w == Approx(1 / std::sqrt(3.0)));
  const Triangle_surface s = sheared_torus(12, 9, 1.0);
  const Edge_weights plain = cotangent_weights(s), clamped = clamped_cotangent_weights(s, 0.1, 2);
  int raised = 0;
  for (int h = 0; h < s.number_of_halfedges(); ++h) {
    CHECK(plain.of_halfedge[h] == plain.of_halfedge[s.opposite[h]]);
    CHECK(clamped.of_halfedge[h] == std::min(2.0, std::max(0.1, plain.of_halfedge[h])));
    raised += plain.of_halfedge[h] < 0;
  }
  CHECK(raised > 0);
}

TEST_CASE("weights stay finite on needles and on triangles without area") {
  Triangle_surface s = tiny::tetrahedron();
  for (const Point& corner : {s.points[1], Point((s.points[1] + s.points[2]) / 2),
                              Point(s.points[1] + 1e-12 * (s.points[2] - s.points[1]))}) {
    s.points[0] = corner;
    for (const double w : cotangent_weights(s).of_halfedge) CHECK(std::isfinite(w));
    Harmonic_field field(s);
    field.set_weights(Weight_kind::clamped_cotangent);
    REQUIRE(bool(field.set_constraint(2, 0)));
    REQUIRE(bool(field.set_constraint(3, 1)));
    const auto f = field.solve();
    REQUIRE(bool(f));
    for (const double value : *f) CHECK((value >= 0 && value <= 1));
  }
}

TEST_CASE("weights do not depend on the scale of the surface") {
  const Triangle_surface s = sheared_torus(9, 8, 0.5);
  for (const double scale : {0x1p-40, 0x1p+40}) {
    Triangle_surface scaled = s;
    for (Point& p : scaled.points) p *= scale;
    CHECK(same_bits(cotangent_weights(scaled).of_halfedge, cotangent_weights(s).of_halfedge));
  }
}

TEST_CASE("a vertex without a face is no obstacle and gets the value zero") {
  Triangle_surface s = tiny::octahedron();
  s.points.insert(s.points.begin(), Point(7, 7, 7));
  for (Triangle& t : s.triangles)
    for (int& v : t) ++v;
  REQUIRE(bool(s.connect()));
  for (const Constraint_method method : {Constraint_method::elimination, Constraint_method::penalty}) {
    Harmonic_field field(s);
    field.set_method(method);
    REQUIRE(bool(field.set_constraint(5, -1)));
    REQUIRE(bool(field.set_constraint(6, 3)));
    const auto f = field.solve();
    REQUIRE(bool(f));
    CHECK((*f)[0] == 0);
    for (int v = 1; v <= 4; ++v) CHECK((*f)[v] == Approx(1));
  }
}

TEST_CASE("elimination is exact, penalties err by about 1e-8") {
  const Triangle_surface s = sheared_torus(40, 25, 0.3);
  Harmonic_field field(s);
  std::map<int, double> constraints = {{0, 0.0}, {512, 1.0}, {700, 0.75}};
  for (const auto& [v, value] : constraints) REQUIRE(bool(field.set_constraint(v, value)));
  const auto eliminated = field.solve();
  REQUIRE(bool(eliminated));
  CHECK(field.residual() < 1e-14);
  for (const auto& [v, value] : constraints) CHECK((*eliminated)[v] == value);
  field.set_method(Constraint_method::penalty);
  const auto penalized = field.solve();
  REQUIRE(bool(penalized));
  const double difference = largest_difference(*eliminated, *penalized);
  CHECK(difference < 1e-7);
  CHECK(difference > 1e-12);
}

TEST_CASE(
    "a Dirichlet problem gives the field of elimination for any values, and leaves the given ones alone") {
  const Triangle_surface s = sheared_torus(40, 25, 0.3);
  const Edge_weights weights = clamped_cotangent_weights(s);
  std::vector<char> is_fixed(s.number_of_vertices(), 0);
  for (int v : {0, 512, 700}) is_fixed[v] = 1;
  std::vector<int> order(s.number_of_vertices() / 2); // and the others after these
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = int(order.size() - i);
  for (const std::vector<int>& asked : {std::vector<int>(), order}) {
    const auto problem = Dirichlet_problem::factorize(s, weights, is_fixed, asked);
    REQUIRE(bool(problem));
    for (const double top : {1.0, -2.0}) {
      Harmonic_field field(s);
      field.set_weights(weights);
      std::vector<double> values(s.number_of_vertices(), 99.0);
      for (const auto& [v, value] : {std::pair(0, 0.0), std::pair(512, top), std::pair(700, 0.75)}) {
        REQUIRE(bool(field.set_constraint(v, value)));
        values[v] = value;
      }
      REQUIRE(bool(problem->solve(s, values)));
      CHECK(values[512] == top);
      CHECK(largest_difference(values, *field.solve()) < 1e-12);
    }
  }
  const auto without = Dirichlet_problem::factorize(s, weights, std::vector<char>(is_fixed.size(), 0));
  REQUIRE(!without);
  CHECK(without.error().code == Error_code::solver_failure);
}

TEST_CASE("constraints that come and go leave the field of those that stay") {
  const Triangle_surface s = sheared_torus(40, 25, 0.3);
  for (const Constraint_method method : {Constraint_method::elimination, Constraint_method::penalty}) {
    Harmonic_field edited(s);
    edited.set_method(method);
    edited.set_incremental(true);
    REQUIRE(bool(edited.set_constraint(0, 0)));
    REQUIRE(bool(edited.set_constraint(999, 1)));
    REQUIRE(bool(edited.solve()));
    for (int step = 0; step < 12; ++step) {
      REQUIRE(bool(edited.set_constraint(37 * step + 20, 0.1 * step)));
      if (step > 2) CHECK(edited.remove_constraint(37 * (step - 2) + 20));
      CHECK(!edited.remove_constraint(1));
      const auto f = edited.solve();
      REQUIRE(bool(f));
      Harmonic_field fresh(s);
      fresh.set_method(method);
      for (const auto& [v, value] : edited.constraints()) REQUIRE(bool(fresh.set_constraint(v, value)));
      const auto expected = fresh.solve();
      REQUIRE(bool(expected));
      if (method == Constraint_method::elimination)
        CHECK(same_bits(*f, *expected));
      else
        CHECK(largest_difference(*f, *expected) < 1e-6);
    }
  }
}

TEST_CASE("threads do not change a bit of the field") {
  const Triangle_surface s = sheared_torus(130, 90, 0.2);
  std::vector<double> expected;
  for (const int threads : {1, 2, 2}) {
    Harmonic_field field(s);
    field.set_threads(threads);
    REQUIRE(bool(field.set_constraint(0, 0)));
    REQUIRE(bool(field.set_constraint(5000, 1)));
    const auto f = field.solve();
    REQUIRE(bool(f));
    if (expected.empty()) expected = *f;
    CHECK(same_bits(*f, expected));
  }
}

TEST_CASE("positive weights obey the maximum principle where cotangents do not") {
  const Triangle_surface s = sheared_torus(30, 16, 1.6);
  Harmonic_field field(s);
  REQUIRE(bool(field.set_constraint(0, 0)));
  REQUIRE(bool(field.set_constraint(250, 1)));
  const auto plain = field.solve();
  REQUIRE(bool(plain));
  REQUIRE(unconstrained_extrema(s, *plain, field.constraints()) > 0); // else this surface shows nothing
  for (const Weight_kind kind : {Weight_kind::clamped_cotangent, Weight_kind::uniform}) {
    field.set_weights(kind);
    const auto f = field.solve();
    REQUIRE(bool(f));
    CHECK(unconstrained_extrema(s, *f, field.constraints()) == 0);
    for (const double value : *f) CHECK((value >= 0 && value <= 1));
  }
}

TEST_CASE("local clamping removes spurious extrema and moves the field less than clamping everywhere") {
  const Triangle_surface s = sheared_torus(30, 16, 1.6);
  Harmonic_field field(s);
  REQUIRE(bool(field.set_constraint(0, 0)));
  REQUIRE(bool(field.set_constraint(250, 1)));
  const auto plain = field.solve();
  const auto local = field.solve_with_local_clamping({0, 250}, 20);
  field.set_weights(Weight_kind::clamped_cotangent);
  const auto clamped = field.solve();
  REQUIRE((bool(plain) && bool(local) && bool(clamped)));
  CHECK(local->rounds > 0);
  CHECK(local->raised_edges > 0);
  CHECK(local->spurious_extrema == 0);
  CHECK(unconstrained_extrema(s, local->values, field.constraints()) == 0);
  if (!local->clamped_everywhere)
    CHECK(largest_difference(local->values, *plain) < largest_difference(*clamped, *plain));
}

TEST_CASE("local clamping leaves a field without spurious extrema as it is") {
  const Triangle_surface s = tiny::torus(20, 12);
  Harmonic_field field(s);
  REQUIRE(bool(field.set_constraint(0, 0)));
  REQUIRE(bool(field.set_constraint(130, 1)));
  const auto f = field.solve();
  const auto local = field.solve_with_local_clamping({0, 130});
  REQUIRE((bool(f) && bool(local)));
  CHECK(local->rounds == 0);
  CHECK(!local->clamped_everywhere);
  CHECK(same_bits(local->values, *f));
}

TEST_CASE("a wanted extremum that is lost makes the weights positive everywhere") {
  const Triangle_surface s = tiny::torus(20, 12);
  Harmonic_field field(s);
  for (const int v : {0, 130, 7}) REQUIRE(bool(field.set_constraint(v, v == 130 ? 1 : v == 7 ? 0.02 : 0)));
  const auto f = field.solve();
  REQUIRE(bool(f));
  field.remove_constraint(7);
  const auto local = field.solve_with_local_clamping({0, 130, 7}); // 7 is no extremum of anything now
  REQUIRE(bool(local));
  CHECK(local->clamped_everywhere);
}

TEST_CASE("real surfaces: positive weights give no spurious extremum, local clamping no more than cotangents",
          "[models]") {
  for (const std::string file : {"rocker_arm_2500.obj", "bunny_low.off", "fandisk.obj", "kitten_6k.obj"}) {
    const std::optional<Triangle_surface> found = model(file);
    if (!found) continue;
    const Triangle_surface& s = *found;
    INFO(file);
    int low = 0, high = 0;
    for (int v = 0; v < s.number_of_vertices(); ++v) {
      if (s.points[v].z() < s.points[low].z()) low = v;
      if (s.points[v].z() > s.points[high].z()) high = v;
    }
    Harmonic_field field(s);
    REQUIRE(bool(field.set_constraint(low, 0)));
    REQUIRE(bool(field.set_constraint(high, 1)));
    const auto plain = field.solve();
    const auto local = field.solve_with_local_clamping({low, high});
    field.set_weights(Weight_kind::clamped_cotangent);
    const auto clamped = field.solve();
    REQUIRE((bool(plain) && bool(local) && bool(clamped)));
    CHECK(unconstrained_extrema(s, *clamped, field.constraints()) == 0);
    CHECK(local->spurious_extrema <= unconstrained_extrema(s, *plain, field.constraints()));
    CHECK(local->spurious_extrema == unconstrained_extrema(s, local->values, field.constraints()));
  }
}
