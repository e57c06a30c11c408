// SPDX-License-Identifier: GPL-3.0-or-later
// Contours enforced by the field alone: what they ask of the vertices around them, and what the field then
// does.
#include "editor_sessions.h"
#include "tiny_surfaces.h"

#include <CGAL/Reeb_quadrangulation/constrained_field.h>
#include <CGAL/Reeb_quadrangulation/plane_contour.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace sessions;

namespace {

// The closed curves in which a surface meets a plane, as contour edges of a network of their own.
Contour_network plane_network(const Triangle_surface& surface, const Cutting_plane& plane, double value) {
  Result<Plane_curves> cut = plane_curves(surface, plane);
  REQUIRE(bool(cut));
  place_crossings(surface, plane, 1e-9, cut->curves);
  Contour_network network;
  network.surface_vertices = surface.number_of_vertices();
  for (const Plane_curve& curve : cut->curves) {
    Contour_edge edge;
    for (std::size_t i = 0; i < curve.crossings.size(); ++i) {
      edge.vertices.push_back(add_crossing(network, curve.crossings[i]));
      edge.faces.push_back(curve.faces[i]);
    }
    edge.vertices.push_back(edge.vertices.front());
    edge.from = edge.to = add_node(network, edge.vertices.front());
    edge.value = value;
    network.edges.push_back(edge);
  }
  return network;
}

std::vector<double> heights(const Triangle_surface& surface) {
  std::vector<double> z;
  for (const Point& p : surface.points) z.push_back(p.z());
  return z;
}

// A loop at a saddle and a plane through the saddle, tilted a little against the loop.
struct Saddle_loop {
  Surface_point at;
  Point saddle;
  Eigen::Vector3d normal;
};

Saddle_loop first_loop(const Editor& editor, const Eigen::Vector3d& tilt) {
  const Contour_network& network = editor.design().network;
  for (const Contour_edge& edge : network.edges) {
    if (network.is_removed(edge) || edge.from != edge.to ||
        network.nodes[edge.from].kind != Node_kind::saddle)
      continue;
    std::vector<Point> points;
    for (int v : edge.vertices) points.push_back(network.position(editor.working_surface(), v));
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    for (std::size_t i = 1; i < points.size(); ++i)
      area += (points[i - 1] - points[0]).cross(points[i] - points[0]);
    return {{points[points.size() / 2], -1}, points[0], area.normalized() + tilt};
  }
  FAIL("no loop at a saddle");
  return {};
}

// The mean distance from a plane of the contour of the design that is nearest to a point.
double distance_from_plane(const Editor& editor, const Saddle_loop& loop) {
  const Contour_network& network = editor.design().network;
  double best = -1, mean = 0;
  for (const Contour_edge& edge : network.edges) {
    if (network.is_removed(edge)) continue;
    double nearest = -1, sum = 0;
    for (int v : edge.vertices) {
      const Point p = network.position(editor.working_surface(), v);
      const double d = (p - loop.at.point).norm();
      if (nearest < 0 || d < nearest) nearest = d;
      sum += std::abs((p - loop.saddle).dot(loop.normal.normalized()));
    }
    if (best >= 0 && nearest >= best) continue;
    best = nearest;
    mean = sum / double(edge.vertices.size());
  }
  return mean;
}

} // namespace

TEST_CASE("a level line asks of the vertices around it what the field has there") {
  for (const Triangle_surface& surface : {tiny::octahedron(), tiny::bipyramid(7), shape("sphere", 800)}) {
    const std::vector<double> z = heights(surface);
    const Contour_network network = plane_network(surface, Cutting_plane::at({0, 0, 0.21}, {0, 0, 1}), 0.21);
    const std::map<int, double> asked = contour_constraints(surface, z, network, {0});
    CHECK(asked.size() >= 5);
    for (const auto& [v, value] : asked) CHECK(value == Approx(z[v]).margin(1e-7));
  }
}

TEST_CASE("a line where the field is not level asks for the field's slope, but through the line") {
  const Triangle_surface surface = shape("sphere", 800);
  const std::vector<double> z = heights(surface);
  const Contour_network network = plane_network(surface, Cutting_plane::at({0, 0, 0}, {0.3, 0, 1}), 0.5);
  const std::map<int, double> asked = contour_constraints(surface, z, network, {0});
  int wrong = 0;
  for (const auto& [v, value] : asked) // above the plane more than the contour's value, below less
    wrong += (value > 0.5) != (surface.points[v].dot(Eigen::Vector3d(0.3, 0, 1)) > 0);
  CHECK(wrong <= int(asked.size()) / 20);
  for (const auto& [v, value] : asked) CHECK(std::abs(value - 0.5) < 0.3);
}

TEST_CASE(
    "a field that is constrained at its own contours stays as it is, and with others' values it follows") {
  const Triangle_surface surface = shape("sphere", 800);
  int top = 0, bottom = 0;
  for (int v = 0; v < surface.number_of_vertices(); ++v) {
    if (surface.points[v].z() > surface.points[top].z()) top = v;
    if (surface.points[v].z() < surface.points[bottom].z()) bottom = v;
  }
  Harmonic_field harmonic(surface);
  harmonic.set_weights(Weight_kind::clamped_cotangent);
  REQUIRE(bool(harmonic.set_constraint(top, 1)));
  REQUIRE(bool(harmonic.set_constraint(bottom, 0)));
  Designed_field field;
  field.values = *harmonic.solve();
  field.minima = {bottom};
  field.maxima = {top};

  const Result<std::vector<double>> alone = constrained_field(surface, field, Contour_network(), {});
  REQUIRE(bool(alone));
  for (std::size_t v = 0; v < alone->size(); ++v) CHECK((*alone)[v] == Approx(field.values[v]).margin(1e-9));

  // The plane through the middle gets a value of 0.6: then it is the contour of 0.6.
  const Contour_network network = plane_network(surface, Cutting_plane::at({0, 0, 0}, {0.2, 0, 1}), 0.6);
  const Result<std::vector<double>> moved = constrained_field(surface, field, network, {0});
  REQUIRE(bool(moved));
  CHECK((*moved)[top] == 1);
  CHECK((*moved)[bottom] == 0);
  double sum = 0;
  for (int v : network.edges[0].vertices) {
    const Edge_crossing& c = network.crossing(v);
    const double a = (*moved)[surface.source(c.halfedge)], b = (*moved)[surface.target(c.halfedge)];
    sum += std::abs(a + c.t * (b - a) - 0.6);
  }
  CHECK(sum / double(network.edges[0].vertices.size()) < 0.01);
}

TEST_CASE("a saddle's loop moved by the field comes near the plane, cut into the surface it lies in it") {
  const Editor before = session(shape("bitorus", 4000), extrema({-1.35, 0, 0}, {{3.35, 0, 0}}), 800);
  const Saddle_loop loop = first_loop(before, {0, 0, 0.15});
  std::array<double, 2> distance{};
  for (Enforcement how : {Enforcement::contour, Enforcement::field}) {
    Editor editor = session(shape("bitorus", 4000), extrema({-1.35, 0, 0}, {{3.35, 0, 0}}), 800);
    const std::map<int, int> old = valences(editor);
    applied(editor, Move_contour{loop.at, loop.saddle, loop.normal, {}, how});
    CHECK(valences(editor) == old);
    CHECK(editor.design().charts.size() == before.design().charts.size());
    distance[int(how)] = distance_from_plane(editor, loop);
  }
  const double unmoved = distance_from_plane(before, loop);
  CHECK(distance[0] < 1e-3);
  CHECK(distance[1] > distance[0]);
  CHECK(distance[1] < 0.5 * unmoved);
}

TEST_CASE("the field alone holds saddles, rings and caps, and nothing else") {
  Editor editor = session(shape("bitorus", 4000), extrema({-1.35, 0, 0}, {{3.35, 0, 0}}), 800);
  const Saddle_loop loop = first_loop(editor, {0, 0, 0.15});
  Move_contour edit{loop.at, loop.saddle, loop.normal, {}, Enforcement::field};
  const auto cap = [&] {
    for (const Contour_edge& edge : editor.design().network.edges)
      if (!edge.vertices.empty() && editor.design().network.nodes[edge.from].kind == Node_kind::regular)
        return Surface_point{editor.design().network.position(editor.working_surface(), edge.vertices[0]),
                             -1};
    return Surface_point();
  }();
  refused(editor, Move_contour{cap, cap.point, {0, 0, 1}, {}, Enforcement::field},
          "a cap goes where the field has it");
  Move_contour part = edit;
  part.anchors = {loop.at, {loop.saddle, -1}};
  refused(editor, part, "the field alone moves no part of a contour");
  applied(editor, Subdivide_chart{at(2, 1, 0.3)});
  const std::size_t contours = contours_of(editor).size();
  applied(editor, edit);
  CHECK(contours_of(editor).size() == contours); // the ring among them
  editor.undo();
  part.enforcement = Enforcement::contour;
  applied(editor, part); // its anchors are no critical points
  refused(editor, edit, "the field alone holds no contours but those of saddles, rings and caps");
}
