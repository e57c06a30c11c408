// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Cholmod_solver.h>
#include <CGAL/Reeb_quadrangulation/Dirichlet_problem.h>
#include <CGAL/Reeb_quadrangulation/Eigen_solver.h>
#include <CGAL/Reeb_quadrangulation/Harmonic_field.h>
#include <CGAL/Reeb_quadrangulation/Multifrontal_solver.h>

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

namespace {

// All choices of solver and method; the first is the default.
std::vector<Field_solver_options> all_choices() {
  std::vector<Field_solver_options> choices;
  for (const Constraint_method method : {Constraint_method::elimination, Constraint_method::penalty})
    for (const char* name : {"multifrontal", "cholmod", "eigen"})
      choices.push_back({*linear_solver_named(name), method});
  return choices;
}

std::string name_of(const Field_solver_options& options) {
  return options.solver.name() +
         (options.constraints == Constraint_method::penalty ? ", penalty" : ", elimination");
}

// How far penalties may leave the field from that of elimination: at a constraint by the flux there over the
// penalty, elsewhere by no more (weights are positive).
double penalty_bound(const Triangle_surface& s, const Edge_weights& weights, const std::vector<double>& f,
                     const std::map<int, double>& constraints) {
  const Symmetric_matrix m = assemble(s, weights).matrix;
  std::vector<double> flux(m.size);
  multiply(m, f.data(), flux.data());
  double largest = 0, bound = 0;
  for (int j = 0; j < m.size; ++j) largest = std::max(largest, m.value[m.column_begin[j]]);
  for (const auto& [v, value] : constraints) bound = std::max(bound, std::abs(flux[v]));
  return bound / (1e8 * largest);
}

} // namespace

TEST_CASE("every solver with either method gives the same field, penalties within their theory") {
  for (const double shear : {0.0, 0.3}) {
    const Triangle_surface s = sheared_torus(60, 35, shear);
    const Edge_weights weights = clamped_cotangent_weights(s);
    const std::map<int, double> constraints = {{0, 0.0}, {1012, 1.0}, {1700, 0.75}};
    std::vector<double> expected;
    for (const Field_solver_options& options : all_choices()) {
      INFO(name_of(options));
      Harmonic_field field(s, options);
      field.set_weights(weights);
      for (const auto& [v, value] : constraints) REQUIRE(bool(field.set_constraint(v, value)));
      const auto solved = field.solve();
      REQUIRE(bool(solved));
      CHECK(field.residual() < 1e-13);
      if (expected.empty()) expected = *solved;
      const double difference = largest_difference(*solved, expected);
      if (options.constraints == Constraint_method::elimination) {
        for (const auto& [v, value] : constraints) CHECK((*solved)[v] == value);
        CHECK(difference < 1e-11);
        continue;
      }
      const double bound = penalty_bound(s, weights, expected, constraints);
      CHECK(difference < 1.1 * bound + 1e-11);
      CHECK(difference > 0.3 * bound); // or it would not be the penalty method
      CHECK(bound < 1e-8);
    }
  }
}

TEST_CASE("every solver with either method solves Dirichlet problems alike, with a jump too") {
  const Triangle_surface s = sheared_torus(40, 25, 0.3);
  const Edge_weights weights = clamped_cotangent_weights(s);
  std::vector<char> is_fixed(s.number_of_vertices(), 0);
  std::vector<double> given(s.number_of_vertices(), 0.0);
  for (const auto& [v, value] : {std::pair(0, 0.0), std::pair(512, 1.0), std::pair(700, 0.75)}) {
    is_fixed[v] = 1;
    given[v] = value;
  }
  // Across the edges between the columns 0 and 1 of the torus, values count one more on one side.
  std::vector<signed char> jump(s.number_of_halfedges(), 0);
  for (int h = 0; h < s.number_of_halfedges(); ++h) {
    const int a = s.source(h) / 25, b = s.target(h) / 25;
    jump[h] = a == 0 && b == 1 ? 1 : a == 1 && b == 0 ? -1 : 0;
  }
  for (const std::vector<signed char>& used : {std::vector<signed char>(), jump}) {
    std::vector<double> expected;
    for (const Field_solver_options& options : all_choices())
      for (const std::vector<int>& order : {std::vector<int>(), std::vector<int>{900, 3, 40}}) {
        INFO(name_of(options));
        const auto problem = Dirichlet_problem::factorize(s, weights, is_fixed, order, options);
        REQUIRE(bool(problem));
        std::vector<double> values = given;
        REQUIRE(bool(problem->solve(s, values, used)));
        for (const int v : {0, 512, 700}) CHECK(values[v] == given[v]);
        if (expected.empty()) expected = values;
        const bool penalty = options.constraints == Constraint_method::penalty;
        CHECK(largest_difference(values, expected) < (penalty ? 1e-7 : 1e-11));
      }
  }
  for (const Field_solver_options& options : all_choices()) {
    INFO(name_of(options));
    CHECK(!Dirichlet_problem::factorize(s, weights, std::vector<char>(is_fixed.size(), 0), {}, options));
  }
}

TEST_CASE("a solver that answers wrongly is found out") {
  class Doubling_solver : public Multifrontal_solver {
  public:
    Result<void> solve(double* x, int right_hand_sides = 1) const {
      const Result<void> solved = Multifrontal_solver::solve(x, right_hand_sides);
      for (int i = 0; i < size() * right_hand_sides; ++i) x[i] *= 1 + 1e-6;
      return solved;
    }
  };
  const Triangle_surface s = tiny::torus(20, 12);
  for (const Constraint_method method : {Constraint_method::elimination, Constraint_method::penalty}) {
    const Field_solver_options options{sparse_linear_solver<Doubling_solver>(), method};
    Harmonic_field field(s, options);
    REQUIRE(bool(field.set_constraint(0, 0)));
    REQUIRE(bool(field.set_constraint(130, 1)));
    const auto refused = field.solve();
    REQUIRE(!refused);
    CHECK(refused.error().code == Error_code::solver_failure);
    std::vector<char> is_fixed(s.number_of_vertices(), 0);
    std::vector<double> values(s.number_of_vertices(), 1.0);
    is_fixed[7] = 1;
    const auto problem = Dirichlet_problem::factorize(s, uniform_weights(s), is_fixed, {}, options);
    REQUIRE(bool(problem));
    CHECK(problem->solve(s, values).error().code == Error_code::solver_failure);
  }
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

TEST_CASE("constraints that come and go leave the field of those that stay, with its bits") {
  const Triangle_surface s = sheared_torus(40, 25, 0.3);
  for (const Field_solver_options& options : all_choices()) {
    INFO(name_of(options));
    Harmonic_field edited(s, options);
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
      Harmonic_field fresh(s, options);
      for (const auto& [v, value] : edited.constraints()) REQUIRE(bool(fresh.set_constraint(v, value)));
      const auto expected = fresh.solve();
      REQUIRE(bool(expected));
      CHECK(same_bits(*f, *expected));
    }
  }
}

TEST_CASE(
    "penalties that come and go need no further factorization, and are as exact as if there had been one") {
  // What is asked of CHOLMOD, in all objects.
  class Counting_solver : public Cholmod_solver {
  public:
    static int& factorizations() {
      static int count = 0;
      return count;
    }
    Result<void> factorize(const Symmetric_matrix& m) {
      if (m.value != m_last) ++factorizations();
      m_last = m.value;
      return Cholmod_solver::factorize(m);
    }

  private:
    std::vector<double> m_last;
  };
  const Triangle_surface s = sheared_torus(40, 25, 0.3);
  Harmonic_field field(s, {sparse_linear_solver<Counting_solver>(), Constraint_method::penalty}), exact(s);
  field.set_incremental(true);
  for (int step = 0; step < 9; ++step) {
    for (Harmonic_field* f : {&field, &exact}) {
      REQUIRE(bool(f->set_constraint(31 * step, step % 3)));
      if (step > 3) f->remove_constraint(31 * (step - 4));
    }
    const auto solved = field.solve();
    REQUIRE(bool(solved));
    CHECK(field.residual() < 1e-14);
    CHECK(largest_difference(*solved, *exact.solve()) < 1e-7);
  }
  CHECK(Counting_solver::factorizations() == 1);
}

TEST_CASE("more constraints than a factor is updated for, and weights that change, are solved anew") {
  const Triangle_surface s = sheared_torus(40, 25, 0.3);
  Harmonic_field field(s, {sparse_linear_solver<Cholmod_solver>(), Constraint_method::penalty}), reference(s);
  field.set_incremental(true);
  for (int v = 0; v < s.number_of_vertices(); v += 3) { // several hundred, then a few
    REQUIRE(bool(field.set_constraint(v, s.points[v].z())));
    REQUIRE(bool(reference.set_constraint(v, s.points[v].z())));
  }
  REQUIRE(field.constraints().size() > 200);
  CHECK(largest_difference(*field.solve(), *reference.solve()) < 1e-7);
  for (int v = 30; v < s.number_of_vertices(); v += 3) {
    field.remove_constraint(v);
    reference.remove_constraint(v);
  }
  for (const Weight_kind kind : {Weight_kind::clamped_cotangent, Weight_kind::uniform}) {
    field.set_weights(kind);
    reference.set_weights(kind);
    CHECK(largest_difference(*field.solve(), *reference.solve()) < 1e-7);
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
