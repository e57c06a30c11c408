// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Harmonic_field.h>

#include "tiny_surfaces.h"

#include <Eigen/Dense>

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
