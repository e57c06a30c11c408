// SPDX-License-Identifier: GPL-3.0-or-later
// The doors for face graphs and the traits concepts, on every kind of mesh that the package promises to take.
#include "concepts/chart_traits_archetype.h"
#include "concepts/texture_traits_archetype.h"
#include "tiny_surfaces.h"

#include "base/pointers_to.h"
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Reeb_quadrangulation/face_graph.h>
#include <CGAL/Reeb_quadrangulation/layout_sampling.h>
#include <CGAL/Reeb_quadrangulation/plane_contour.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <limits>
#include <set>

using namespace CGAL::Reeb_quadrangulation;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Plain = CGAL::Simple_cartesian<double>;
using Inexact_mesh = CGAL::Surface_mesh<Inexact::Point_3>;
using Exact_mesh = CGAL::Surface_mesh<Exact::Point_3>;
using Plain_mesh = CGAL::Surface_mesh<Plain::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Inexact>;

namespace {

// The face graph of a surface. Coordinates are sums of two, so that an exact kernel has something to
// evaluate.
template <class Graph> Graph face_graph(const Triangle_surface& s) {
  Graph graph;
  const auto points = get(CGAL::vertex_point, graph);
  using Graph_point = typename boost::property_traits<std::decay_t<decltype(points)>>::value_type;
  using FT = typename CGAL::Kernel_traits<Graph_point>::type::FT;
  std::vector<typename boost::graph_traits<Graph>::vertex_descriptor> vertex;
  for (const Point& p : s.points) {
    vertex.push_back(add_vertex(graph));
    const auto half = [](double x) { return FT(x) / FT(4); };
    const auto sum = [&](double x) { return half(x) * FT(3) + half(x); };
    put(points, vertex.back(), Graph_point(sum(p.x()), sum(p.y()), sum(p.z())));
  }
  for (const Triangle& t : s.triangles)
    CGAL::Euler::add_face(std::array{vertex[t[0]], vertex[t[1]], vertex[t[2]]}, graph);
  return graph;
}

// Coordinates with few bits, which every number type above represents without rounding.
Triangle_surface short_torus(int m = 30, int n = 16) {
  Triangle_surface s = tiny::torus(m, n);
  for (Point& p : s.points)
    for (int i = 0; i < 3; ++i) p[i] = std::round(p[i] * 4096) / 4096;
  return s;
}

Triangle_surface surface_of(const Inexact_mesh& mesh) {
  auto converted = to_triangle_surface(mesh);
  REQUIRE(bool(converted));
  return converted->surface;
}

std::map<int, int> inner_valences(const Quad_mesh& mesh) {
  std::vector<std::set<int>> neighbours(mesh.points.size());
  for (const Quad& q : mesh.quads)
    for (int i = 0; i < 4; ++i) {
      neighbours[q[i]].insert(q[(i + 1) % 4]);
      neighbours[q[(i + 1) % 4]].insert(q[i]);
    }
  std::map<int, int> valences;
  for (const auto& n : neighbours) ++valences[int(n.size())];
  return valences;
}

Inexact_mesh torus_mesh() {
  return face_graph<Inexact_mesh>(short_torus());
}

} // namespace

TEMPLATE_TEST_CASE("every mesh type gives the same surface", "", Inexact_mesh, Exact_mesh, Plain_mesh,
                   Polyhedron, CGAL::Polyhedron_3<Exact>) {
  const Triangle_surface s = short_torus();
  TestType graph = face_graph<TestType>(s);
  add_vertex(graph); // without a face: left out
  const auto converted = to_triangle_surface(graph);
  REQUIRE(bool(converted));
  CHECK(converted->surface.points == s.points);
  REQUIRE(converted->surface.triangles.size() == s.triangles.size());
  for (std::size_t f = 0; f < s.triangles.size(); ++f) {
    Triangle a = s.triangles[f], b = converted->surface.triangles[f];
    std::rotate(a.begin(), std::min_element(a.begin(), a.end()), a.end());
    std::rotate(b.begin(), std::min_element(b.begin(), b.end()), b.end());
    CHECK(a == b);
  }
  REQUIRE(converted->vertices.size() == s.points.size());
  for (std::size_t v = 0; v < converted->vertices.size(); ++v)
    CHECK(get(converted->vertex_index, converted->vertices[v]) == int(v));
  int left_out = 0;
  for (const auto v : vertices(graph)) left_out += get(converted->vertex_index, v) < 0;
  CHECK(left_out == 1);
}

TEMPLATE_TEST_CASE("every mesh type gives the same quads", "", Inexact_mesh, Exact_mesh, Plain_mesh,
                   Polyhedron) {
  const Triangle_surface s = surface_of(torus_mesh());
  Quadrangulation_options options;
  options.quads = 600;
  const Result<Quadrangulation> expected = quadrangulate(s, options);
  REQUIRE(bool(expected));

  TestType quads;
  const auto result =
      quadrangulate(face_graph<TestType>(short_torus()), quads, parameters::number_of_quads(600));
  REQUIRE(bool(result));
  CHECK(CGAL::is_closed(quads));
  CHECK(num_faces(quads) == expected->mesh.quads.size());
  for (const auto f : faces(quads)) CHECK(degree(f, quads) == 4);
  CHECK(result->valences == expected->valences);
  // Where Euler operations begin a triangle may differ from one type to another, the quads' connection not.
  CHECK(inner_valences(result->mesh) == expected->valences);
  if (std::is_same<TestType, Exact_mesh>::value || std::is_same<TestType, Plain_mesh>::value) {
    CHECK(result->mesh.quads == expected->mesh.quads);
    CHECK(result->mesh.points == expected->mesh.points);
  }
}

TEST_CASE("planes classify exact and inexact inputs alike, also points on them") {
  const auto inexact = to_triangle_surface(torus_mesh());
  const auto exact = to_triangle_surface(face_graph<Exact_mesh>(short_torus()));
  REQUIRE((inexact && exact));
  const std::vector<Point>& p = inexact->surface.points;
  for (const auto& plane :
       {Cutting_plane::through(p[0], p[100], p[231]), Cutting_plane::at(p[17], Point(0, 0, 1)),
        Cutting_plane::at(p[17], Point(1, 0, 0)), Cutting_plane::through(p[3], p[4], p[20])}) {
    const auto a = plane_curves(inexact->surface, plane), b = plane_curves(exact->surface, plane);
    REQUIRE((a && b));
    CHECK(!a->curves.empty());
    CHECK(a->is_above == b->is_above);
    REQUIRE(a->curves.size() == b->curves.size());
    for (std::size_t i = 0; i < a->curves.size(); ++i) {
      CHECK(a->curves[i].faces == b->curves[i].faces);
      CHECK(a->curves[i].is_closed);
    }
  }
}

TEST_CASE("a lazy number is rounded alike whatever was asked of it before") {
  using FT = Exact::FT;
  const FT fresh = FT(1) / FT(3);
  FT asked = FT(1) / FT(3);
  CGAL::exact(asked);
  CHECK(internal::coordinate(fresh) == internal::coordinate(asked));
  CHECK(internal::coordinate(fresh) == Approx(1.0 / 3).epsilon(1e-16));
}

TEST_CASE("named parameters reach the pipeline") {
  const Inexact_mesh mesh = torus_mesh();
  std::vector<Inexact_mesh::Vertex_index> low{Inexact_mesh::Vertex_index(0)},
      high{Inexact_mesh::Vertex_index(15 * 16), Inexact_mesh::Vertex_index(5 * 16)};
  Inexact_mesh quads;
  auto chart = quads.add_property_map<Inexact_mesh::Face_index, int>("f:chart", -1).first;
  const auto result = quadrangulate(
      mesh, quads,
      parameters::minima(low).maxima(high).number_of_quads(500).quad_chart_map(chart).number_of_threads(1));
  REQUIRE(bool(result));
  CHECK(result->editor.design().extrema.size() == 3);
  CHECK(std::abs(double(quads.number_of_faces()) - 500) <= 25);
  int number = 0;
  for (const auto f : quads.faces()) CHECK(chart[f] == result->chart_of_quad[number++]);

  // Points from elsewhere, twice as large, with edges twice as long: the same quads.
  std::map<Inexact_mesh::Vertex_index, Inexact::Point_3> doubled;
  for (const auto v : mesh.vertices()) doubled[v] = CGAL::ORIGIN + 2 * (mesh.point(v) - CGAL::ORIGIN);
  const auto points = boost::make_assoc_property_map(doubled);
  Inexact_mesh first, second;
  const auto small = quadrangulate(mesh, first, parameters::edge_length(0.125));
  const auto large = quadrangulate(mesh, second, parameters::edge_length(0.25).vertex_point_map(points));
  REQUIRE((small && large));
  CHECK(small->mesh.quads == large->mesh.quads);
  REQUIRE(small->mesh.points.size() == large->mesh.points.size());
  CHECK((2 * small->mesh.points[7] - large->mesh.points[7]).norm() < 1e-9);
  // CGAL's own parameters do as well.
  const auto converted = to_triangle_surface(mesh, CGAL::parameters::vertex_point_map(points));
  REQUIRE(bool(converted));
  CHECK(converted->surface.points[3] == 2 * surface_of(mesh).points[3]);

  Quadrangulation_options options;
  options.quads = 900;
  options.relax = false;
  Inexact_mesh third;
  const auto unrelaxed = quadrangulate(mesh, third, parameters::options(options).number_of_quads(300));
  REQUIRE(bool(unrelaxed));
  CHECK(std::abs(double(third.number_of_faces()) - 300) <= 15);
}

TEST_CASE("what is no triangle surface is refused and the output stays as it was") {
  Inexact_mesh quads;
  quads.add_vertex(Inexact::Point_3(0, 0, 0));
  const auto refused = [&](const auto& mesh, Error_code code) {
    const auto result = quadrangulate(mesh, quads);
    REQUIRE(!result);
    CHECK(result.error().code == code);
    CHECK(num_vertices(quads) == 1);
    CHECK(num_faces(quads) == 0);
    return result.error();
  };
  refused(Inexact_mesh(), Error_code::not_a_surface);

  Inexact_mesh cube;
  CGAL::make_hexahedron(Inexact::Point_3(0, 0, 0), Inexact::Point_3(1, 0, 0), Inexact::Point_3(1, 1, 0),
                        Inexact::Point_3(0, 1, 0), Inexact::Point_3(0, 1, 1), Inexact::Point_3(0, 0, 1),
                        Inexact::Point_3(1, 0, 1), Inexact::Point_3(1, 1, 1), cube);
  const Error no_triangle = refused(cube, Error_code::not_a_surface);
  CHECK(no_triangle.element == Element_kind::face);
  CHECK(no_triangle.index == 0);

  Plain_mesh nowhere = face_graph<Plain_mesh>(short_torus());
  nowhere.point(Plain_mesh::Vertex_index(5)) = Plain::Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
  const Error not_finite = refused(nowhere, Error_code::not_a_surface);
  CHECK(not_finite.element == Element_kind::vertex);
  CHECK(not_finite.index == 5);

  Inexact_mesh two = torus_mesh();
  CGAL::make_tetrahedron(Inexact::Point_3(5, 0, 0), Inexact::Point_3(6, 0, 0), Inexact::Point_3(5, 1, 0),
                         Inexact::Point_3(5, 0, 1), two);
  refused(two, Error_code::not_a_surface);

  struct Impatient : Observer {
    bool cancelled() const override { return true; }
  } impatient;
  const auto cancelled = quadrangulate(torus_mesh(), quads, parameters::observer(&impatient));
  REQUIRE(!cancelled);
  CHECK(cancelled.error().code == Error_code::cancelled);
  CHECK(num_vertices(quads) == 1);
}

TEST_CASE("quads that are no manifold are refused as a face graph") {
  const Quad_mesh two = {
      {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), Point(2, 0, 0), Point(2, 1, 0)},
      {{0, 1, 2, 3}, {1, 4, 5, 2}}};
  Polyhedron polyhedron;
  const auto added = to_face_graph(two, polyhedron);
  REQUIRE(bool(added));
  CHECK(added->faces.size() == 2);
  CHECK(num_vertices(polyhedron) == 6);

  Quad_mesh flipped = two, outside = two;
  flipped.quads[1] = {2, 5, 4, 1};
  outside.quads[1][2] = 6;
  for (const Quad_mesh& bad : {flipped, outside}) {
    const auto refused = to_face_graph(bad, polyhedron);
    REQUIRE(!refused);
    CHECK(refused.error().code == Error_code::not_a_surface);
    CHECK(num_vertices(polyhedron) == 6);
  }
}

TEMPLATE_TEST_CASE("stages write to property maps", "", Inexact_mesh, Polyhedron) {
  const TestType mesh = face_graph<TestType>(short_torus());
  using Vertex = typename boost::graph_traits<TestType>::vertex_descriptor;
  using Face = typename boost::graph_traits<TestType>::face_descriptor;
  std::map<Vertex, float> field;
  const std::vector<Vertex> low{*std::next(vertices(mesh).begin(), 0)},
      high{*std::next(vertices(mesh).begin(), 15 * 16)};
  const auto np = parameters::minima(low).maxima(high);
  const auto designed = reeb_field(mesh, boost::make_assoc_property_map(field), np);
  REQUIRE(bool(designed));
  CHECK(field.size() == num_vertices(mesh));
  CHECK(field[low[0]] == 0);
  CHECK(field[high[0]] == 1);
  for (const auto& [v, value] : field) CHECK((v == low[0] || v == high[0] || (0 < value && value < 1)));

  std::map<Face, int> chart;
  const auto layout = reeb_charts(mesh, boost::make_assoc_property_map(chart), np);
  REQUIRE(bool(layout));
  CHECK(layout->graph.loops() == 1);
  CHECK(chart.size() == num_faces(mesh));
  std::set<int> used;
  for (const auto& [f, c] : chart) used.insert(c);
  CHECK(used.size() == layout->atlas.charts.size()); // every chart is wider than a triangle here
  CHECK(*used.begin() == 0);
  CHECK(*used.rbegin() + 1 == int(used.size()));
}

// --- ReebChartTraits
// -------------------------------------------------------------------------------------------------------

namespace {

struct Constant_traits { // a model of ReebChartTraits for wrong weights
  using FT = double;
  struct Edge_weight {
    double weight;
    FT operator()(const Triangle_surface&, int h) const { return h < 30 ? weight : 1; }
  };
  Edge_weight edge_weight_object(const Chart&) const { return {weight}; }
  double weight;
};

Reeb_layout torus_layout(const Triangle_surface& s) {
  Result<Designed_field> field = choose_extrema(s);
  REQUIRE(bool(field));
  REQUIRE(bool(solve_field(s, {}, *field)));
  Result<Reeb_layout> layout = make_layout(s, *field);
  REQUIRE(bool(layout));
  return std::move(*layout);
}

} // namespace

TEST_CASE("models of ReebChartTraits prepare charts that do not fold") {
  const Reeb_layout layout = torus_layout(short_torus());
  const auto check = [&](const auto& traits) {
    for (const auto& shared_chart : layout.atlas.charts) {
      const Chart& chart = *shared_chart;
      auto map = prepare_chart(chart, traits);
      REQUIRE(bool(map));
      if (chart.kind != Chart_kind::annulus) continue;
      REQUIRE(bool(map->solve_columns(chart, map->natural(Side::low), map->natural(Side::high))));
      CHECK(map->flipped(chart) == 0);
    }
  };
  check(Reeb_chart_traits());
  check(Uniform_chart_traits());
  check(Mean_value_chart_traits());
  check(archetype::Chart_traits(3));
}

TEST_CASE("the default of ReebChartTraits are the weights of the library") {
  const Reeb_layout layout = torus_layout(short_torus());
  for (const auto& shared_chart : layout.atlas.charts) {
    const Chart& chart = *shared_chart;
    CHECK(chart_weights(chart, Reeb_chart_traits()).of_halfedge ==
          clamped_cotangent_weights(chart.mesh).of_halfedge);
    CHECK(chart_weights(chart, Uniform_chart_traits()).of_halfedge ==
          uniform_weights(chart.mesh).of_halfedge);
    const auto a = prepare_chart(chart), b = Chart_parameterization::prepare(chart);
    REQUIRE((a && b));
    CHECK(a->u() == b->u());
  }
}

TEST_CASE("mean value weights of equilateral triangles are alike, also at scales far off") {
  for (const double scale : {1.0, 1e-150, 1e100}) {
    Chart chart;
    chart.mesh = tiny::octahedron();
    for (Point& p : chart.mesh.points) p *= scale;
    for (double w : chart_weights(chart, Mean_value_chart_traits()).of_halfedge)
      CHECK(w == Approx(2 * std::tan(std::acos(-1.0) / 6))); // four angles of 60 degrees, halved
    chart.mesh.points.assign(6, Point(1, 2, 3));             // all in one point: still a weight
    for (double w : chart_weights(chart, Mean_value_chart_traits()).of_halfedge)
      CHECK((w > 0 && std::isfinite(w)));
  }
}

TEST_CASE("weights that could fold a chart are refused") {
  const Reeb_layout layout = torus_layout(short_torus());
  const Chart& chart = *layout.atlas.charts[0];
  for (const double bad :
       {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    const auto map = prepare_chart(chart, Constant_traits{bad});
    REQUIRE(!map);
    CHECK(map.error().code == Error_code::impossible_request);
    CHECK(map.error().element == Element_kind::edge);
  }
  Edge_weights one_sided = uniform_weights(chart.mesh);
  int inside = 0;
  while (chart.mesh.is_boundary(inside)) ++inside;
  one_sided.of_halfedge[inside] = 2;
  CHECK(!Chart_parameterization::prepare(chart, one_sided));
  one_sided.of_halfedge.pop_back();
  CHECK(!Chart_parameterization::prepare(chart, one_sided));
}

TEST_CASE("the pipeline takes chart traits") {
  Inexact_mesh a, b, c;
  const auto cotangent = quadrangulate(torus_mesh(), a, parameters::chart_traits(Reeb_chart_traits()));
  const auto standard = quadrangulate(torus_mesh(), b);
  const auto tutte = quadrangulate(torus_mesh(), c, parameters::chart_traits(archetype::Chart_traits(3)));
  REQUIRE((cotangent && standard && tutte));
  CHECK(cotangent->mesh.points == standard->mesh.points);
  CHECK(tutte->mesh.points != standard->mesh.points);
  CHECK(inner_valences(tutte->mesh) == tutte->valences);
  CHECK(!quadrangulate(torus_mesh(), c, parameters::chart_traits(Constant_traits{-1})));
}

// --- QuadTextureTraits
// -----------------------------------------------------------------------------------------------------

namespace {

// A smaller quad in the middle of quad `q`: two extraordinary vertices more for each corner.
void inset(Quad_texture& texture, std::size_t q) {
  const Quad outer = texture.quads[q];
  double v = 0, u = 0, turn = texture.v[outer[0]];
  std::array<double, 4> lifted{};
  for (int i = 0; i < 4; ++i) {
    lifted[i] = texture.v[outer[i]] + (texture.v[outer[i]] < turn - 0.5 && texture.sides.size() == 2 ? 1 : 0);
    v += lifted[i] / 4;
    u += texture.u[outer[i]] / 4;
  }
  Quad inner{};
  for (int i = 0; i < 4; ++i) {
    inner[i] = int(texture.v.size());
    const double middle = 0.5 * (lifted[i] + v);
    texture.v.push_back(texture.sides.size() == 2 && middle >= 1 ? middle - 1 : middle);
    texture.u.push_back(0.5 * (texture.u[outer[i]] + u));
  }
  texture.quads[q] = inner;
  for (int i = 0; i < 4; ++i)
    texture.quads.push_back({outer[i], outer[(i + 1) % 4], inner[(i + 1) % 4], inner[i]});
}

struct Inset_traits : Quad_texture_traits {
  struct Make_annulus_texture {
    Quad_texture operator()(int columns, const std::vector<double>& levels) const {
      Quad_texture texture = regular_annulus_texture(columns, levels);
      inset(texture, texture.quads.size() - 1); // over V = 1
      return texture;
    }
  };
  struct Make_disc_texture {
    Quad_texture operator()(int a, int b, bool clockwise) const {
      Quad_texture texture = regular_disc_texture(a, b, clockwise);
      inset(texture, 0);
      return texture;
    }
  };
  Make_annulus_texture make_annulus_texture_object() const { return {}; }
  Make_disc_texture make_disc_texture_object() const { return {}; }
};

// Spoils the textures of the discs in one of several ways.
struct Spoiled_traits : Quad_texture_traits {
  struct Make_disc_texture {
    int way;
    Quad_texture operator()(int a, int b, bool clockwise) const {
      Quad_texture t = regular_disc_texture(a, b, clockwise);
      switch (way) {
      case 0: t.quads.pop_back(); break;
      case 1: t.sides[0].pop_back(); break;
      case 2: t.sides.clear(); break;
      case 3: t.u.pop_back(); break;
      case 4: t.v[0] = std::numeric_limits<double>::quiet_NaN(); break;
      case 5: t.quads[0][0] = int(t.v.size()); break;
      case 6: std::reverse(t.quads[0].begin(), t.quads[0].end()); break;
      case 7: t.sides[0][0] = t.sides[0][1]; break;
      case 8: std::reverse(t.sides[0].begin(), t.sides[0].end()); break;
      case 9: t.v.push_back(0.5), t.u.push_back(0.5); break;
      case 10: t.sides[0][0] = -1; break;
      default:
        t = regular_annulus_texture(2 * (a + b), {0, 1});
        t.sides.pop_back();
        break;
      }
      return t;
    }
  };
  Make_disc_texture make_disc_texture_object() const { return {way}; }
  int way = 0;
};

struct Level_traits : Quad_texture_traits {
  struct Compute_row_levels {
    std::vector<double> levels;
    std::vector<double> operator()(const Height_profile&, int) const { return levels; }
  };
  Compute_row_levels compute_row_levels_object() const { return {levels}; }
  std::vector<double> levels;
};

} // namespace

TEST_CASE("the default of QuadTextureTraits are regular grids") {
  Inexact_mesh a, b;
  const auto standard = quadrangulate(torus_mesh(), a);
  const auto given = quadrangulate(torus_mesh(), b, parameters::texture_traits(Quad_texture_traits()));
  REQUIRE((standard && given));
  CHECK(standard->mesh.points == given->mesh.points);
  CHECK(standard->mesh.quads == given->mesh.quads);
}

TEST_CASE("textures are free inside: their valences are predicted, their rows need not be those asked for") {
  Inexact_mesh a, b, c, d;
  const auto standard = quadrangulate(torus_mesh(), a, parameters::number_of_quads(600));
  const auto inset_quads =
      quadrangulate(torus_mesh(), b, parameters::number_of_quads(600).texture_traits(Inset_traits()));
  const auto rows = quadrangulate(
      torus_mesh(), c, parameters::number_of_quads(600).texture_traits(archetype::Texture_traits(2)));
  Level_traits two_rows;
  two_rows.levels = {0, 0.25, 1};
  const auto flat = quadrangulate(torus_mesh(), d, parameters::number_of_quads(600).texture_traits(two_rows));
  for (const auto* result : {&standard, &inset_quads, &rows, &flat}) {
    INFO((*result ? std::string() : result->error().message));
    REQUIRE(bool(*result));
  }
  const int charts = int(standard->editor.design().charts.size());
  CHECK(inset_quads->mesh.quads.size() == standard->mesh.quads.size() + 4 * charts);
  CHECK(inset_quads->valences != standard->valences);
  std::size_t in_annuli = 0;
  for (int q : standard->chart_of_quad)
    in_annuli += standard->editor.design().charts[q]->chart->kind == Chart_kind::annulus;
  CHECK(rows->mesh.quads.size() == standard->mesh.quads.size() + in_annuli);
  CHECK(flat->mesh.quads.size() < standard->mesh.quads.size());
  for (const Inexact_mesh* mesh : {&a, &b, &c, &d}) CHECK(CGAL::is_closed(*mesh));
  for (const auto* result : {&standard, &inset_quads, &rows, &flat})
    CHECK(inner_valences((*result)->mesh) == (*result)->valences);
}

TEST_CASE("textures that cannot be stitched are refused") {
  const Inexact_mesh torus = torus_mesh();
  Inexact_mesh quads;
  Spoiled_traits spoiled;
  for (spoiled.way = 0; spoiled.way < 12; ++spoiled.way) {
    CAPTURE(spoiled.way);
    const auto result = quadrangulate(torus, quads, parameters::number_of_quads(300).texture_traits(spoiled));
    REQUIRE(!result);
    CHECK(result.error().code == Error_code::impossible_request);
  }
  for (const std::vector<double>& levels :
       {std::vector<double>{0}, {0, 1}, {0, 0.5}, {0, 0.5, 0.5, 1}, {0, 0.7, 0.3, 1}, {}}) {
    Level_traits traits;
    traits.levels = levels;
    const auto result = quadrangulate(torus, quads, parameters::number_of_quads(300).texture_traits(traits));
    REQUIRE(!result);
    CHECK(result.error().code == Error_code::impossible_request);
  }
  CHECK(num_faces(quads) == 0);
}

TEST_CASE("one chart is filled by the textures of a traits class") {
  const Reeb_layout layout = torus_layout(short_torus());
  std::vector<Chart_parameterization> maps;
  std::vector<double> heights;
  for (const auto& shared_chart : layout.atlas.charts) {
    const Chart& chart = *shared_chart;
    auto map = prepare_chart(chart);
    REQUIRE(bool(map));
    heights.push_back(chart.kind == Chart_kind::annulus ? map->profile().total() : 0);
    maps.push_back(std::move(*map));
  }
  const Layout_sampling_problem problem = sampling_problem(layout, heights);
  const auto sampling = sample_for_quads(problem.problem, 400);
  REQUIRE(bool(sampling));
  Contour_samples samples;
  samples.counts.assign(layout.network.edges.size(), 0);
  for (std::size_t i = 0; i < problem.edges.size(); ++i)
    samples.counts[problem.edges[i]] = sampling->counts[i];
  samples.parameter = contour_parameters(layout.embedding.surface.points, layout.network, layout.atlas,
                                         internal::pointers_to(maps), 0.5);
  for (std::size_t c = 0; c < maps.size(); ++c) {
    const Chart& chart = *layout.atlas.charts[c];
    const auto placed =
        place_texture(chart, samples, sampling->grid[c], maps[c], archetype::Texture_traits(1));
    REQUIRE(bool(placed));
    CHECK(int(placed->texture.quads.size()) == sampling->grid[c][0] * sampling->grid[c][1]);
    CHECK(placed->location.size() == placed->texture.v.size());
  }
}
