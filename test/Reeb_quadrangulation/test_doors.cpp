// SPDX-License-Identifier: GPL-3.0-or-later
// The functions on face graphs one by one, on Surface_mesh, Polyhedron_3, and a graph without points of its
// own.
#include "pointed_graph.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Reeb_quadrangulation/certify_quads.h>
#include <CGAL/Reeb_quadrangulation/combine_parameters.h>
#include <CGAL/Reeb_quadrangulation/finish_face_graph.h>
#include <CGAL/Reeb_quadrangulation/plane_curves.h>
#include <CGAL/Reeb_quadrangulation/reeb_graph.h>
#include <CGAL/Reeb_quadrangulation/transfer_attribute.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <limits>
#include <set>

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact_mesh = CGAL::Surface_mesh<Exact::Point_3>;

// --- named parameters
// ------------------------------------------------------------------------------------------------------

TEST_CASE("chains of CGAL's parameters and ours become one") {
  std::map<int, int> values{{1, 2}};
  const auto map = boost::make_assoc_property_map(values);
  const auto chain = params::combine(CGAL::parameters::vertex_point_map(map).geom_traits(Inexact()),
                                     params::number_of_quads(7).edge_length(2))
                         .number_of_quads(8);
  using Chain = std::decay_t<decltype(chain)>;
  CHECK(params::has_parameter<CGAL::internal_np::geom_traits_t, Chain>);
  CHECK(params::has_parameter<params::edge_length_t, Chain>);
  CHECK(!params::has_parameter<params::minima_t, Chain>);
  CHECK(params::parameter_or<params::number_of_quads_t>(chain, 0) == 8);
  CHECK(params::parameter_or<params::edge_length_t>(chain, 0.0) == 2);
  CHECK(get(params::vertex_points(chain, map), 1) == 2); // no vertex_point of anything is asked for
  CHECK(params::parameter_or<params::number_of_quads_t>(params::combine(), 5) == 5);
  CHECK(params::parameter_or<params::number_of_quads_t>(CGAL::parameters::default_values(), 6) == 6);
}

TEMPLATE_TEST_CASE("a mesh goes into a graph and comes back", "", Mesh, Polyhedron, Bare) {
  const Triangle_surface s = tiny::torus(9, 6);
  const Pointed<TestType> mesh = pointed<TestType>(s);
  const auto back = to_triangle_surface(mesh.graph, params::vertex_point_map(mesh.map()));
  REQUIRE(bool(back));
  CHECK(back->surface.points == s.points);
  REQUIRE(back->surface.triangles.size() == s.triangles.size());
  for (int h = 0; h < back->surface.number_of_halfedges(); ++h) {
    const auto g = back->halfedges[std::size_t(h)];
    CHECK(source(g, mesh.graph) == back->vertices[std::size_t(back->surface.source(h))]);
    CHECK(target(g, mesh.graph) == back->vertices[std::size_t(back->surface.target(h))]);
  }
}

TEST_CASE("geom_traits reads points that have no x()") {
  struct Triple {
    std::array<double, 3> of;
  };
  struct Traits {
    struct Coordinate {
      int i;
      double operator()(const Triple& p) const { return p.of[std::size_t(i)]; }
    };
    struct Construct {
      Triple operator()(double x, double y, double z) const { return {{x, y, z}}; }
    };
    Coordinate compute_x_3_object() const { return {0}; }
    Coordinate compute_y_3_object() const { return {1}; }
    Coordinate compute_z_3_object() const { return {2}; }
    Construct construct_point_3_object() const { return {}; }
  };
  const Triangle_surface s = tiny::octahedron();
  Bare graph;
  std::map<Bare::Vertex, Triple> points;
  const auto np = params::vertex_point_map(boost::make_assoc_property_map(points)).geom_traits(Traits());
  REQUIRE(bool(to_face_graph(s, graph, np)));
  const auto back = to_triangle_surface(graph, np);
  REQUIRE(bool(back));
  CHECK(back->surface.points == s.points);
}

// --- plane curves
// ----------------------------------------------------------------------------------------------------------

TEST_CASE("the sides of a plane are exact in an exact kernel") {
  // A grid on a cube, turned by a rotation with rational entries, so that its points have no doubles; planes
  // go through many of them.
  const auto turned = [](double x, double y, double z) {
    const Exact::FT a(x), b(y), c(z), n(3);
    return Exact::Point_3((a * 2 - b * 2 + c) / n, (a + b * 2 + c * 2) / n, (a * -2 - b + c * 2) / n);
  };
  Mesh cube;
  CGAL::make_grid(
      12, 12, cube, [](int i, int j) { return Inexact::Point_3(i, j, (i * j) % 5); }, true);
  Exact_mesh mesh;
  CGAL::make_grid(
      12, 12, mesh, [&](int i, int j) { return turned(i, j, (i * j) % 5); }, true);
  int rounded_wrong = 0;
  for (const double height : {1.0, 2.0, 3.0}) {
    const Exact::Plane_3 plane(turned(0, 0, height), turned(1, 0, height), turned(0, 1, height));
    std::vector<Face_graph_curve<Exact_mesh, Exact::Point_3>> curves;
    const auto number = plane_curves(mesh, plane, std::back_inserter(curves));
    REQUIRE(bool(number));
    CHECK(*number == int(curves.size()));
    CHECK(!curves.empty());
    std::set<Exact_mesh::Edge_index> crossed;
    for (const auto& curve : curves) {
      REQUIRE(curve.points.size() == curve.halfedges.size());
      for (std::size_t i = 0; i < curve.halfedges.size(); ++i) {
        const auto h = curve.halfedges[i];
        CHECK(crossed.insert(mesh.edge(h)).second);
        CHECK(plane.has_on_negative_side(mesh.point(mesh.source(h))));
        CHECK(!plane.has_on_negative_side(mesh.point(mesh.target(h))));
        CHECK(plane.has_on(curve.points[i]));
      }
    }
    for (const auto e : mesh.edges()) {
      const auto h = mesh.halfedge(e);
      const bool is_crossed = plane.has_on_negative_side(mesh.point(mesh.source(h))) !=
                              plane.has_on_negative_side(mesh.point(mesh.target(h)));
      CHECK(is_crossed == (crossed.count(e) == 1));
    }
    // The same surface before it was turned says what is right; doubles do not.
    for (const auto v : cube.vertices()) {
      const auto& p = mesh.point(Exact_mesh::Vertex_index(unsigned(v)));
      CHECK(plane.has_on_negative_side(p) == (cube.point(v).z() < height));
      const double a = CGAL::to_double(plane.a()), b = CGAL::to_double(plane.b()),
                   c = CGAL::to_double(plane.c()), d = CGAL::to_double(plane.d());
      rounded_wrong +=
          (a * CGAL::to_double(p.x()) + b * CGAL::to_double(p.y()) + c * CGAL::to_double(p.z()) + d < 0) !=
          plane.has_on_negative_side(p);
    }
  }
  CHECK(rounded_wrong > 0); // else the planes above test nothing
}

TEMPLATE_TEST_CASE("plane curves of every graph", "", Mesh, Polyhedron, Bare) {
  const Triangle_surface s = tiny::torus(30, 16);
  const Pointed<TestType> mesh = pointed<TestType>(s);
  std::vector<Face_graph_curve<TestType, Inexact::Point_3>> curves;
  const auto np = params::vertex_point_map(mesh.map());
  const auto number =
      plane_curves(mesh.graph, Inexact::Plane_3(1, 0, 0, -0.01), std::back_inserter(curves), np);
  REQUIRE(bool(number));
  CHECK(*number == 2); // both sides of the ring
  for (const auto& curve : curves) {
    CHECK(curve.is_closed);
    for (const auto& p : curve.points) CHECK(p.x() == Approx(0.01).margin(1e-12));
  }
  const auto degenerate =
      plane_curves(mesh.graph, Inexact::Plane_3(0, 0, 0, 1), std::back_inserter(curves), np);
  REQUIRE(!degenerate);
  CHECK(degenerate.error().code == Error_code::impossible_request);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(!plane_curves(mesh.graph, Inexact::Plane_3(1, 0, 0, nan), std::back_inserter(curves), np));
}

// --- Reeb graphs of functions
// ----------------------------------------------------------------------------------------------

namespace {

template <class Graph> struct Reeb {
  Face_graph_reeb_graph<Graph> graph;
  std::map<Vertex_of<Graph>, int> vertex_arc;
  std::map<typename boost::graph_traits<Graph>::face_descriptor, int> face_arc;
};

template <class Graph, class Function> Reeb<Graph> reeb_of(const Pointed<Graph>& mesh, const Function& f) {
  std::map<Vertex_of<Graph>, double> values;
  for (const auto v : vertices(mesh.graph)) values[v] = f(mesh.points.at(v));
  Reeb<Graph> result;
  const auto graph = reeb_graph(mesh.graph, boost::make_assoc_property_map(values),
                                params::vertex_point_map(mesh.map())
                                    .vertex_arc_map(boost::make_assoc_property_map(result.vertex_arc))
                                    .face_arc_map(boost::make_assoc_property_map(result.face_arc)));
  REQUIRE(bool(graph));
  result.graph = *graph;
  // Every arc rises; a regular vertex lies between the ends of its arc.
  std::vector<std::array<double, 2>> range;
  for (const auto& arc : graph->arcs)
    range.push_back({values[graph->nodes[std::size_t(arc.low)].vertex],
                     values[graph->nodes[std::size_t(arc.high)].vertex]});
  std::set<Vertex_of<Graph>> critical;
  for (const auto& node : graph->nodes) critical.insert(node.vertex);
  for (const auto& [v, arc] : result.vertex_arc) {
    CHECK((arc < 0) == (critical.count(v) == 1));
    if (arc < 0) continue;
    CHECK(range[std::size_t(arc)][0] <= values[v]);
    CHECK(values[v] <= range[std::size_t(arc)][1]);
  }
  return result;
}

int number_of(const std::vector<Critical_kind>& kinds, Critical_kind kind) {
  return int(std::count(kinds.begin(), kinds.end(), kind));
}
template <class Graph> std::vector<Critical_kind> kinds_of(const Reeb<Graph>& reeb) {
  std::vector<Critical_kind> kinds;
  for (const auto& node : reeb.graph.nodes) kinds.push_back(node.kind);
  return kinds;
}

Triangle_surface grid(int m, int n) {
  Triangle_surface s;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= m; ++i) s.points.push_back(Point(double(i) / m, double(j) / n, 0));
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < m; ++i) {
      const int a = j * (m + 1) + i;
      s.triangles.push_back({a, a + 1, a + m + 2});
      s.triangles.push_back({a, a + m + 2, a + m + 1});
    }
  REQUIRE(bool(s.connect()));
  return s;
}

} // namespace

TEMPLATE_TEST_CASE("the Reeb graph of heights on a torus has one loop", "", Mesh, Polyhedron, Bare) {
  const Pointed<TestType> mesh = pointed<TestType>(tiny::torus(30, 16));
  const auto reeb = reeb_of(mesh, [](const auto& p) { return p.x() + 0.01 * p.y() + 0.001 * p.z(); });
  CHECK(reeb.graph.loops() == 1);
  CHECK(reeb.graph.components == 1);
  CHECK(reeb.graph.nodes.size() == 4);
  CHECK(reeb.graph.arcs.size() == 4);
  CHECK(reeb.graph.nodes.front().kind == Critical_kind::minimum);
  CHECK(reeb.graph.nodes.back().kind == Critical_kind::maximum);
  CHECK(number_of(kinds_of(reeb), Critical_kind::saddle) == 2);
  // The lowest and the highest point are a pair; the saddles open and close the loop.
  REQUIRE(reeb.graph.pairs.size() == 1);
  CHECK(reeb.graph.pairs[0] == std::array<int, 2>{0, 3});
  CHECK(std::isinf(reeb.graph.nodes[1].persistence));
  std::set<int> arcs;
  for (const auto& [f, arc] : reeb.face_arc) arcs.insert(arc);
  CHECK(arcs == std::set<int>{0, 1, 2, 3});
}

TEST_CASE("contours that end on the boundary are arcs of a Reeb graph") {
  // Heights of a plain square: one arc from corner to corner, which are the only critical vertices.
  const Pointed<Mesh> square = pointed<Mesh>(grid(8, 8));
  const auto plain = reeb_of(square, [](const auto& p) { return p.y() + 0.1 * p.x(); });
  CHECK(plain.graph.arcs.size() == 1);
  CHECK(plain.graph.nodes.size() == 2);
  CHECK(plain.graph.pairs == std::vector<std::array<int, 2>>{{0, 1}});

  // Two hills between three edges of the square: the lower one is in a pair with the pass between them.
  const auto hills = reeb_of(pointed<Mesh>(grid(40, 10)), [](const auto& p) {
    const double x = p.x() - 0.5, y = p.y() - 0.5;
    return std::cos(12.6 * x) * -1 + 0.3 * x - 4 * y * y;
  });
  CHECK(hills.graph.loops() == 0);
  const auto kinds = kinds_of(hills);
  CHECK(number_of(kinds, Critical_kind::maximum) == 2);
  int finite = 0;
  for (const auto& pair : hills.graph.pairs) {
    const auto &a = hills.graph.nodes[std::size_t(pair[0])], &b = hills.graph.nodes[std::size_t(pair[1])];
    if (a.kind == Critical_kind::saddle && b.kind == Critical_kind::maximum) ++finite;
    CHECK(std::isfinite(a.persistence));
  }
  CHECK(finite <= 1);
}

TEST_CASE("a ring cut from a plane has a loop whose contours are arcs") {
  Triangle_surface s;
  const int n = 24, m = 5;
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::acos(-1.0) * (i + 0.5 * j) / n, r = 1 + 0.25 * j;
      s.points.push_back(Point(r * std::cos(angle), r * std::sin(angle), 0));
    }
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * n + i, b = j * n + (i + 1) % n;
      s.triangles.push_back({a, a + n, b});
      s.triangles.push_back({b, a + n, b + n});
    }
  REQUIRE(bool(s.connect()));
  const auto reeb = reeb_of(pointed<Mesh>(s), [](const auto& p) { return p.y() + 0.01 * p.x(); });
  CHECK(reeb.graph.loops() == 1); // on both sides of the hole
  CHECK(reeb.graph.nodes.size() == 4);
  CHECK(reeb.graph.arcs.size() == 4);

  // Around the hole: closed contours, then arcs where they meet the outer edge, which is no circle here.
  for (Point& p : s.points) p.x() *= 1.3;
  const auto radial = reeb_of(pointed<Mesh>(s), [](const auto& p) {
    return p.x() * p.x() + p.y() * p.y() + 1e-3 * p.x() + 1e-4 * p.y();
  });
  CHECK(number_of(kinds_of(radial), Critical_kind::maximum) >= 2);
  CHECK(radial.graph.loops() <= 1);
}

TEST_CASE("Reeb graphs of components, exact values, plateaus, and values that are none") {
  Triangle_surface two = tiny::octahedron();
  const int n = two.number_of_vertices();
  const Triangle_surface one = two;
  for (const Point& p : one.points) two.points.push_back(p + Point(5, 0, 0));
  for (const Triangle& t : one.triangles) two.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  REQUIRE(bool(two.connect()));
  const auto reeb = reeb_of(pointed<Mesh>(two), [](const auto& p) { return p.z() + 0.1 * p.x(); });
  CHECK(reeb.graph.components == 2);
  CHECK(reeb.graph.loops() == 0);
  CHECK(reeb.graph.pairs.size() == 2);

  // Values that doubles cannot tell apart are told apart.
  const Pointed<Mesh> torus = pointed<Mesh>(tiny::torus(12, 8));
  std::map<Mesh::Vertex_index, Exact::FT> near;
  for (const auto v : torus.graph.vertices())
    near[v] = Exact::FT(1) + Exact::FT(torus.points.at(v).x() + 0.01 * torus.points.at(v).y() +
                                       0.001 * torus.points.at(v).z()) *
                                 Exact::FT(1e-30);
  const auto exact =
      reeb_graph(torus.graph, boost::make_assoc_property_map(near), params::vertex_point_map(torus.map()));
  const auto far = reeb_of(torus, [](const auto& p) { return p.x() + 0.01 * p.y() + 0.001 * p.z(); });
  REQUIRE(bool(exact));
  REQUIRE(exact->nodes.size() == far.graph.nodes.size());
  for (std::size_t i = 0; i < exact->nodes.size(); ++i)
    CHECK(exact->nodes[i].vertex == far.graph.nodes[i].vertex);

  const auto flat = reeb_of(torus, [](const auto&) { return 1.0; }); // by the vertices' numbers
  CHECK(flat.graph.loops() == 1);
  for (const auto& pair : flat.graph.pairs) CHECK(flat.graph.nodes[std::size_t(pair[0])].persistence == 0);

  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    std::map<Mesh::Vertex_index, double> values;
    for (const auto v : torus.graph.vertices()) values[v] = double(unsigned(v));
    values[Mesh::Vertex_index(7)] = bad;
    const auto refused = reeb_graph(torus.graph, boost::make_assoc_property_map(values),
                                    params::vertex_point_map(torus.map()));
    REQUIRE(!refused);
    CHECK(refused.error().code == Error_code::impossible_request);
    CHECK(refused.error().index == 7);
  }
}

// --- attributes and locations
// ----------------------------------------------------------------------------------------------

TEMPLATE_TEST_CASE("attributes of vertices, faces and corners go over to quads", "", Mesh, Polyhedron, Bare) {
  const Pointed<TestType> mesh = pointed<TestType>(tiny::torus(30, 16));
  const Pointed<TestType> quads = pointed_quads<TestType>(quads_of_torus(30, 16));
  const auto np1 = params::vertex_point_map(mesh.map()), np2 = params::vertex_point_map(quads.map());
  using Traits = boost::graph_traits<TestType>;

  std::map<Vertex_of<TestType>, double> x, x_of_quads; // a linear function stays what it is
  for (const auto v : vertices(mesh.graph)) x[v] = mesh.points.at(v).x();
  REQUIRE(bool(transfer_attribute(mesh.graph, quads.graph, boost::make_assoc_property_map(x),
                                  boost::make_assoc_property_map(x_of_quads), np1, np2)));
  for (const auto v : vertices(quads.graph))
    CHECK(x_of_quads[v] == Approx(quads.points.at(v).x()).margin(1e-12));

  // Two patches, of a type without arithmetic; corners that jump between them.
  std::map<typename Traits::face_descriptor, std::string> patch, patch_of_quads;
  std::map<typename Traits::halfedge_descriptor, double> corner, corner_of_quads;
  const auto is_right = [](const Pointed<TestType>& m, auto f) {
    double sum = 0;
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, m.graph), m.graph))
      sum += m.points.at(target(h, m.graph)).x();
    return sum > 0;
  };
  for (const auto f : faces(mesh.graph)) {
    patch[f] = is_right(mesh, f) ? "right" : "left";
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, mesh.graph), mesh.graph))
      corner[h] = is_right(mesh, f) ? 10 : 20;
  }
  REQUIRE(bool(transfer_attribute(mesh.graph, quads.graph, boost::make_assoc_property_map(patch),
                                  boost::make_assoc_property_map(patch_of_quads), np1, np2)));
  REQUIRE(bool(transfer_attribute(mesh.graph, quads.graph, boost::make_assoc_property_map(corner),
                                  boost::make_assoc_property_map(corner_of_quads), np1, np2)));
  int compared = 0;
  for (const auto f : faces(quads.graph)) {
    bool is_near_border = false;
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, quads.graph), quads.graph))
      is_near_border = is_near_border || std::abs(quads.points.at(target(h, quads.graph)).x()) < 0.4;
    if (is_near_border) continue;
    ++compared;
    const bool right = is_right(quads, f);
    CHECK(patch_of_quads[f] == (right ? "right" : "left"));
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, quads.graph), quads.graph))
      CHECK(corner_of_quads[h] == Approx(right ? 10 : 20));
  }
  CHECK(compared > 200);

  TestType empty;
  CHECK(!transfer_attribute(empty, quads.graph, boost::make_assoc_property_map(x),
                            boost::make_assoc_property_map(x_of_quads), np1, np2));
}

TEST_CASE("weights of a point are those of its triangle, also where that has no area") {
  Triangle_surface s;
  s.points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 0, 0}};
  s.triangles = {{0, 1, 2}, {0, 1, 3}, {3, 0, 1}};
  const auto at = [&](int f, const Point& p) { return internal::barycentric_coordinates(s, f, p); };
  CHECK(at(0, Point(1, 2, 7)) == std::array<double, 3>{0.25, 0.25, 0.5});
  const std::array<double, 3> outside = at(0, Point(-1, 2, 0)); // 3/4, -1/4, 1/2, brought in
  CHECK(outside[0] == Approx(0.6));
  CHECK(outside[1] == 0);
  CHECK(outside[2] == Approx(0.4));
  for (int f : {1, 2}) { // flat: along the longest edge
    const std::array<double, 3> w = at(f, Point(3, 0, 0));
    Point p = Point::Zero();
    for (int i = 0; i < 3; ++i) {
      CHECK(w[std::size_t(i)] >= 0);
      p += w[std::size_t(i)] * s.points[std::size_t(s.triangles[std::size_t(f)][std::size_t(i)])];
    }
    CHECK((p - Point(3, 0, 0)).norm() < 1e-12);
  }
}

// --- the last stages
// -------------------------------------------------------------------------------------------------------

TEMPLATE_TEST_CASE("quads of any origin are relaxed, finished and certified in their graph", "", Mesh,
                   Polyhedron, Bare) {
  const Pointed<TestType> mesh = pointed<TestType>(tiny::torus(60, 32));
  Quad_mesh crooked = quads_of_torus(24, 12);
  for (std::size_t v = 1; v < crooked.points.size();
       v += 2) // every other ring is turned by a third of a quad
    crooked.points[v] = Eigen::AngleAxisd(0.09, Point(0, 0, 1)) * crooked.points[v];
  const Pointed<TestType> before = pointed_quads<TestType>(crooked);
  Pointed<TestType> quads = pointed_quads<TestType>(crooked);
  const auto np2 = params::vertex_point_map(mesh.map());

  std::map<Vertex_of<TestType>, bool> held;
  for (const auto v : vertices(quads.graph)) held[v] = false;
  const auto first = *vertices(quads.graph).begin();
  held[first] = true;
  const auto np1 = params::vertex_point_map(quads.map());
  const auto relaxed =
      relax_quads(quads.graph, mesh.graph,
                  params::combine(np1).vertex_is_constrained_map(boost::make_assoc_property_map(held)), np2);
  REQUIRE(bool(relaxed));
  CHECK(relaxed->mean_after > relaxed->mean_before);
  CHECK(quads.points.at(first).x() == before.points.at(*vertices(before.graph).begin()).x());

  const auto finished = finish_quads(quads.graph, mesh.graph, np1, np2);
  REQUIRE(bool(finished));
  std::size_t i = 0;
  for (const auto v : vertices(quads.graph)) CHECK(quads.points.at(v).x() == finished->mesh.points[i++].x());

  const auto certificate = certify(quads.graph, mesh.graph, np1, np2);
  REQUIRE(bool(certificate));
  CHECK(certificate->passed);

  const auto no_quads = certify(mesh.graph, mesh.graph, np2, np2);
  REQUIRE(!no_quads);
  CHECK(no_quads.error().element == Element_kind::face);
  CHECK(!relax_quads(quads.graph, mesh.graph, params::combine(np1).options([] {
    Relax_options bad;
    bad.iterations = -1;
    return bad;
  }()),
                     np2));
}
