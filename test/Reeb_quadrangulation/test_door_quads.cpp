// SPDX-License-Identifier: GPL-3.0-or-later
// Quads of face graphs by quadrangulate() and an editing session: what the user asks to be kept, sizes,
// components, maps.
#include "pointed_graph.h"

#include <CGAL/Reeb_quadrangulation/create_editor.h>
#include <CGAL/Reeb_quadrangulation/quadrangulate_components.h>

#include <algorithm>
#include <limits>
#include <set>

TEMPLATE_TEST_CASE("quads with points beside their graph tell where they lie", "", Mesh, Bare) {
  const Pointed<TestType> mesh = pointed<TestType>(tiny::torus(30, 16));
  Pointed<TestType> quads;
  std::map<Vertex_of<TestType>, Face_location<TestType>> place;
  const auto result = quadrangulate(mesh.graph, quads.graph,
                                    params::combine(CGAL::parameters::vertex_point_map(mesh.map()))
                                        .number_of_quads(300)
                                        .vertex_location_map(boost::make_assoc_property_map(place)),
                                    params::vertex_point_map(quads.map()));
  REQUIRE(bool(result));
  REQUIRE(place.size() == num_vertices(quads.graph));
  for (const auto& [v, at] : place) {
    const auto h = halfedge(at.first, mesh.graph);
    const std::array<Vertex_of<TestType>, 3> corners{source(h, mesh.graph), target(h, mesh.graph),
                                                     target(next(h, mesh.graph), mesh.graph)};
    Inexact::Vector_3 p(0, 0, 0);
    for (std::size_t c = 0; c < 3; ++c) p = p + at.second[c] * (mesh.points.at(corners[c]) - CGAL::ORIGIN);
    CHECK(CGAL::squared_distance(CGAL::ORIGIN + p, quads.points.at(v)) < 1e-18);
  }
}

// --- constrained edges and vertices, patches, sizes, components
// ------------------------------------------------------------

namespace {

using Segment_list = std::vector<std::array<Point, 2>>;

double distance_to(const Segment_list& segments, const Point& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : segments) {
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    least = std::min(least, (a + t * (b - a) - p).norm());
  }
  return least;
}

// The part of the segments' length that sides and diagonals of quads run along.
double covered(const Segment_list& segments, const Quad_mesh& mesh) {
  double total = 0, along = 0;
  for (const auto& [a, b] : segments) total += (b - a).norm();
  std::set<std::array<int, 2>> done;
  for (const Quad& q : mesh.quads)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        const Point &a = mesh.points[std::size_t(q[i])], &b = mesh.points[std::size_t(q[j])];
        const double length = (b - a).norm();
        if (distance_to(segments, a) > 1e-6 || distance_to(segments, b) > 1e-6) continue;
        if (distance_to(segments, 0.5 * (a + b)) > 0.1 * length) continue;
        if (done.insert({std::min(q[i], q[j]), std::max(q[i], q[j])}).second) along += length;
      }
  return along / total;
}

} // namespace

TEMPLATE_TEST_CASE("edges, vertices and patches of the user are kept by the quads", "", Mesh, Polyhedron,
                   Bare) {
  const int m = 40, n = 20;
  const Pointed<TestType> mesh = pointed<TestType>(tiny::torus(m, n));
  std::map<Vertex_of<TestType>, int> number;
  for (const auto v : vertices(mesh.graph)) number.emplace(v, int(number.size()));
  const auto column = [&](auto v) { return number[v] / n; };
  const auto np = params::vertex_point_map(mesh.map()).number_of_quads(800);

  // Two rings around the tube, which no sharp edge marks, and one vertex aside of them.
  std::map<typename boost::graph_traits<TestType>::edge_descriptor, bool> is_constrained;
  std::map<typename boost::graph_traits<TestType>::face_descriptor, int> patch;
  std::map<Vertex_of<TestType>, bool> is_kept;
  Segment_list rings;
  for (const auto e : edges(mesh.graph)) {
    const auto h = halfedge(e, mesh.graph);
    const auto u = source(h, mesh.graph), v = target(h, mesh.graph);
    is_constrained[e] = column(u) == column(v) && (column(u) == 7 || column(u) == 22);
    if (is_constrained[e]) rings.push_back({at(mesh, u), at(mesh, v)});
  }
  REQUIRE(rings.size() == 2 * std::size_t(n));
  for (const auto f : faces(mesh.graph)) {
    int least = m, most = 0;
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, mesh.graph), mesh.graph)) {
      least = std::min(least, column(target(h, mesh.graph)));
      most = std::max(most, column(target(h, mesh.graph)));
    }
    patch[f] = least >= 7 && most <= 22;
  }
  Point wanted = Point::Zero();
  for (const auto v : vertices(mesh.graph)) {
    is_kept[v] = number[v] == 31 * n + 3;
    if (is_kept[v]) wanted = at(mesh, v);
  }
  const auto nearest = [&](const Quad_mesh& quads) {
    double least = 1;
    for (const Point& p : quads.points) least = std::min(least, (p - wanted).norm());
    return least;
  };

  Pointed<TestType> a, b, c;
  const auto plain = quadrangulate(mesh.graph, a.graph, np, params::vertex_point_map(a.map()));
  const auto by_edges =
      quadrangulate(mesh.graph, b.graph,
                    np.edge_is_constrained_map(boost::make_assoc_property_map(is_constrained))
                        .vertex_is_constrained_map(boost::make_assoc_property_map(is_kept)),
                    params::vertex_point_map(b.map()));
  const auto by_patches =
      quadrangulate(mesh.graph, c.graph, np.face_patch_map(boost::make_assoc_property_map(patch)),
                    params::vertex_point_map(c.map()));
  REQUIRE((plain && by_edges && by_patches));
  CAPTURE(covered(rings, plain->mesh), covered(rings, by_edges->mesh), covered(rings, by_patches->mesh));
  CHECK(covered(rings, plain->mesh) < 0.2);
  CHECK(covered(rings, by_edges->mesh) > 0.9);
  CHECK(covered(rings, by_patches->mesh) > 0.9);
  CHECK(nearest(plain->mesh) > 1e-3);
  CHECK(nearest(by_edges->mesh) < 1e-12);
  CHECK(by_edges->relaxation.inverted_after == 0);
  CHECK(by_edges->features.vertices > 20);

  // Quads that are there already are laid onto them too.
  Pointed<TestType> d = pointed_quads<TestType>(plain->mesh);
  const auto finished =
      finish_quads(d.graph, mesh.graph, params::vertex_point_map(d.map()),
                   params::vertex_point_map(mesh.map())
                       .edge_is_constrained_map(boost::make_assoc_property_map(is_constrained)));
  REQUIRE(bool(finished));
  CHECK(covered(rings, finished->mesh) > 0.9);
}

TEST_CASE("sizes are met in the mean, coarse and fine") {
  const Pointed<Mesh> mesh = pointed<Mesh>(tiny::torus(60, 30));
  for (const double size : {0.04, 0.1, 0.2}) {
    std::map<Mesh::Vertex_index, double> sizes;
    for (const auto v : mesh.graph.vertices()) sizes[v] = size;
    Pointed<Mesh> quads;
    const auto result = quadrangulate(
        mesh.graph, quads.graph,
        params::vertex_point_map(mesh.map()).sizing_field(boost::make_assoc_property_map(sizes)),
        params::vertex_point_map(quads.map()));
    REQUIRE(bool(result));
    CAPTURE(size);
    CHECK(std::abs(mean_relative_size(result->mesh, [&](const Point&) { return size; }) - 1) <= 0.15);
  }
  std::map<Mesh::Vertex_index, double> graded;
  const auto grade = [](const Point& p) { return p.x() > 0 ? 0.06 : 0.15; };
  for (const auto v : mesh.graph.vertices()) graded[v] = grade(at(mesh, v));
  Pointed<Mesh> quads;
  const auto np = params::vertex_point_map(mesh.map()).sizing_field(boost::make_assoc_property_map(graded));
  const auto result = quadrangulate(mesh.graph, quads.graph, np, params::vertex_point_map(quads.map()));
  REQUIRE(bool(result));
  CHECK(std::abs(mean_relative_size(result->mesh, grade) - 1) <= 0.15);
  CHECK(result->subdivided_quads == 0);
  const auto even = [](const Point&) { return 0.09; };
  CHECK(size_report(result->mesh, grade).met > size_report(result->mesh, even).met);
  graded[Mesh::Vertex_index(5)] = std::numeric_limits<double>::quiet_NaN();
  const auto refused = quadrangulate(mesh.graph, quads.graph, np, params::vertex_point_map(quads.map()));
  REQUIRE(!refused);
  CHECK(refused.error().index == 5);
}

TEST_CASE("components are quadrangulated one by one") {
  Triangle_surface two = tiny::torus(30, 16);
  const Triangle_surface one = two;
  const int n = one.number_of_vertices();
  for (const Point& p : one.points) two.points.push_back(0.5 * p + Point(5, 0, 0));
  for (const Triangle& t : one.triangles) two.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  const Pointed<Mesh> mesh = pointed<Mesh>(two);
  const std::vector<Mesh::Vertex_index> low{Mesh::Vertex_index(0)}, high{Mesh::Vertex_index(15 * 16)};
  Mesh quads;
  auto place = quads.add_property_map<Mesh::Vertex_index, Face_location<Mesh>>("v:place").first;
  const auto np = params::vertex_point_map(mesh.map()).number_of_quads(1000).minima(low).maxima(high);
  const auto results = quadrangulate_components(mesh.graph, quads, np.vertex_location_map(place));
  REQUIRE(bool(results));
  REQUIRE(results->size() == 2);
  CHECK((*results)[0].editor.design().extrema.size() == 2);
  const double first = double((*results)[0].mesh.quads.size()),
               second = double((*results)[1].mesh.quads.size());
  CHECK(std::abs(first - 800) <= 40);
  CHECK(std::abs(second - 200) <= 20);
  CHECK(double(num_faces(quads)) == first + second);
  for (const auto v : quads.vertices())
    CHECK((unsigned(place[v].first) < one.triangles.size()) == (quads.point(v).x() < 3));
  CHECK(!quadrangulate(mesh.graph, quads, np)); // one component is what this takes
  const auto refused = quadrangulate_components(mesh.graph, quads, np.number_of_quads(-1));
  CHECK(!refused);
}

TEMPLATE_TEST_CASE("corners of quads have the parameters of their charts", "", Mesh, Polyhedron) {
  const Pointed<TestType> mesh = pointed<TestType>(tiny::torus(30, 16));
  using Traits = boost::graph_traits<TestType>;
  std::map<typename Traits::halfedge_descriptor, Inexact::Point_2> uv;
  std::map<typename Traits::face_descriptor, int> chart;
  Pointed<TestType> quads;
  const auto result = quadrangulate(mesh.graph, quads.graph,
                                    params::vertex_point_map(mesh.map())
                                        .number_of_quads(500)
                                        .halfedge_uv_map(boost::make_assoc_property_map(uv))
                                        .quad_chart_map(boost::make_assoc_property_map(chart)),
                                    params::vertex_point_map(quads.map()));
  REQUIRE(bool(result));
  CHECK(uv.size() == 4 * num_faces(quads.graph));
  std::map<int, double> area;
  for (const auto f : faces(quads.graph)) {
    std::vector<Inexact::Point_2> corners;
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, quads.graph), quads.graph)) {
      corners.push_back(uv[h]);
      const auto o =
          opposite(h, quads.graph); // the same edge from the neighbour in the chart, but for a turn
      if (chart[face(o, quads.graph)] != chart[f]) continue;
      const auto a = uv[h], b = uv[prev(o, quads.graph)];
      const double turns = a.x() - b.x();
      CHECK(a.y() == Approx(b.y()).margin(1e-12));
      CHECK(std::abs(turns - std::round(turns)) < 1e-12);
    }
    double twice = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto &a = corners[i], &b = corners[(i + 1) % 4];
      twice += a.x() * b.y() - a.y() * b.x();
    }
    CHECK(twice > 0); // counterclockwise, also over the seam
    area[chart[f]] += 0.5 * twice;
  }
  const Design& design = result->editor.design();
  for (const auto& [c, sum] : area)
    if (design.charts[std::size_t(c)]->chart->kind == Chart_kind::annulus) CHECK(sum == Approx(1));

  Quadrangulation_options adaptive;
  adaptive.quads = 500;
  adaptive.adaptive.ratio = 2;
  Pointed<TestType> other;
  const auto refused = quadrangulate(mesh.graph, other.graph,
                                     params::vertex_point_map(mesh.map())
                                         .options(adaptive)
                                         .halfedge_uv_map(boost::make_assoc_property_map(uv)),
                                     params::vertex_point_map(other.map()));
  REQUIRE(!refused);
  CHECK(refused.error().code == Error_code::impossible_request);
  CHECK(num_vertices(other.graph) == 0);
}

TEMPLATE_TEST_CASE("quads and charts of a function of the user's own", "", Mesh, Bare) {
  const Triangle_surface s = tiny::torus(30, 16);
  const Pointed<TestType> mesh = pointed<TestType>(s);
  std::map<typename boost::graph_traits<TestType>::vertex_descriptor, float> height;
  std::map<typename boost::graph_traits<TestType>::face_descriptor, int> chart;
  for (const auto v : vertices(mesh.graph)) {
    const auto p = get(mesh.map(), v);
    height[v] = float(p.x() + 0.1 * p.y() + 0.03 * p.z());
  }
  const auto np =
      params::vertex_point_map(mesh.map()).vertex_field_map(boost::make_assoc_property_map(height));
  Pointed<TestType> quads;
  const auto result =
      quadrangulate(mesh.graph, quads.graph, np.number_of_quads(500), params::vertex_point_map(quads.map()));
  REQUIRE(bool(result));
  CHECK(std::abs(double(num_faces(quads.graph)) - 500) <= 25);
  CHECK(result->valences.at(3) == 8);
  // What was done is a recipe that has the function.
  const auto recipe = recipe_from_json(to_json(result->recipe));
  REQUIRE(bool(recipe));
  auto again = Editor::create(result->editor.input(), recipe->options);
  REQUIRE(bool(again));
  for (const Edit& edit : recipe->edits) REQUIRE(bool(again->apply(edit)));
  const auto finished = again->finished_quads(recipe->finish);
  REQUIRE(bool(finished));
  CHECK(finished->quads.mesh.points == result->mesh.points);

  const auto layout = reeb_charts(mesh.graph, boost::make_assoc_property_map(chart), np);
  REQUIRE(bool(layout));
  CHECK(layout->graph.loops() == 1);
  CHECK(layout->critical.saddles.size() == 2);
  CHECK(chart.size() == num_faces(mesh.graph));
}

TEMPLATE_TEST_CASE("an editing session begins on a graph", "", Mesh, Polyhedron, Bare) {
  const Pointed<TestType> mesh = pointed<TestType>(tiny::torus(30, 16));
  const auto np = params::vertex_point_map(mesh.map());
  auto editor = create_editor(mesh.graph, np.number_of_quads(400));
  REQUIRE(bool(editor));
  const auto first = *vertices(mesh.graph).begin(),
             second = *std::next(vertices(mesh.graph).begin(), 15 * 16);
  Set_extrema edit;
  edit.extrema.push_back({surface_point(mesh.graph, first, np), false, -1});
  edit.extrema.push_back({surface_point(mesh.graph, second, np), true, -1});
  REQUIRE(bool(editor->apply(edit)));
  CHECK(editor->design().extrema.size() == 2);
  CHECK(std::abs(double(editor->quads().mesh.quads.size()) - 400) <= 20);
  CHECK(!create_editor(mesh.graph, np.edge_length(-1)));
  TestType empty;
  CHECK(!create_editor(empty, np));
}
