// SPDX-License-Identifier: GPL-3.0-or-later
// What a refusal offers: it works, it is the nearest of its kind, it depends on nothing but the design and
// the edit; and what needs no refusal any more.
#include "editor_sessions.h"

#include <CGAL/Reeb_quadrangulation/offer_after.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace sessions;

namespace {

// The offer after an edit that the editor refuses, which leaves the editor as it was.
std::optional<Offer> offered(const Editor& editor, const Edit& edit) {
  INFO(to_json(edit));
  const Design* before = &editor.design();
  const Result<Design> refused = editor.preview(edit);
  REQUIRE(!refused);
  INFO(refused.error().message);
  const Result<std::optional<Offer>> offer = offer_after(editor, edit, refused.error());
  REQUIRE(bool(offer));
  CHECK(&editor.design() == before);
  return *offer;
}

// The same, where there must be one: the editor applies it.
Offer sure_offer(Editor& editor, const Edit& edit) {
  const std::optional<Offer> offer = offered(editor, edit);
  INFO(to_json(edit));
  REQUIRE(bool(offer));
  CHECK(offer->words.size() > 5);
  applied(editor, offer->edit);
  editor.undo();
  return *offer;
}

Editor ringed_sphere() {
  Editor editor = sphere_session();
  applied(editor, Subdivide_chart{at(1, 0, 0)});
  return editor;
}

// Asks for everything to stop.
struct Stopper : Observer {
  void progress(const std::string&, double) override {}
  bool cancelled() const override { return true; }
};

} // namespace

TEST_CASE("a contour that cannot go all the way to a plane is offered the longest part that works") {
  Editor editor = ringed_sphere();
  const Move_contour far{at(1, 0, 0), Point(0, 0, 1.5), Eigen::Vector3d(0, 0, 1), {}};
  refused(editor, far, "the plane does not meet the surface");
  const Offer offer = sure_offer(editor, far);
  const Move_contour& less = std::get<Move_contour>(offer.edit);
  CHECK(offer.words.find("of the way") != std::string::npos);
  CHECK(less.plane_point.z() > 0.3);
  CHECK(less.plane_point.z() < 1);
  Move_contour more = less; // an eighth farther
  more.plane_point.z() += 1.5 / 8;
  CHECK(!editor.preview(more));
}

TEST_CASE("of a tilt seven eighths are tried first, and told in degrees") {
  const Editor editor = ringed_sphere();
  const double angle = std::acos(-1.0) / 4;
  const Eigen::Vector3d normal(std::sin(angle), 0, std::cos(angle));
  Point centre = Point::Zero(); // of the ring: the plane only turns
  for (int e : contours_of(editor))
    if (const std::vector<Point> ring = points_of(editor, e); std::abs(ring[0].z()) < 0.1)
      for (const Point& p : ring) centre += p / double(ring.size());
  const Move_contour tilted{at(1, 0, 0), centre, normal, {}};
  const Error whatever =
      make_error(Error_code::refused_edit, "the plane leaves the charts beside the contour");
  const Result<std::optional<Offer>> offer = offer_after(editor, tilted, whatever);
  REQUIRE(bool(offer));
  REQUIRE(bool(*offer));
  const Eigen::Vector3d less = std::get<Move_contour>((*offer)->edit).plane_normal.normalized();
  CHECK(std::acos(less.z()) / angle == Approx(0.875).margin(0.03)); // the ring is nearly level
  CHECK((*offer)->words == "Tilt by 39 degrees instead");
}

TEST_CASE("a part between two anchors is offered smaller tilts about both, wherever the contour begins") {
  const Editor editor = ringed_sphere();
  const Error whatever =
      make_error(Error_code::refused_edit, "the plane leaves the charts beside the contour");
  const double half = std::sqrt(0.5);
  const std::vector<Point> around{{1, 0, 0},  {half, half, 0},   {0, 1, 0},  {-half, half, 0},
                                  {-1, 0, 0}, {-half, -half, 0}, {0, -1, 0}, {half, -half, 0}};
  for (std::size_t i = 0; i < around.size(); ++i) {
    const Point &moved = around[i], &one = around[(i + 2) % 8], &other = around[(i + 6) % 8];
    const Move_contour part{{moved, -1}, moved, Point(0, 0, 1) + 0.5 * moved, {{one, -1}, {other, -1}}};
    const Result<std::optional<Offer>> offer = offer_after(editor, part, whatever);
    REQUIRE(bool(offer));
    REQUIRE(bool(*offer));
    const Move_contour& less = std::get<Move_contour>((*offer)->edit);
    CHECK(less.anchors.size() == 2);
    CHECK((*offer)->words.find("degrees") != std::string::npos);
    CHECK(std::abs(less.plane_normal.normalized().z()) > part.plane_normal.normalized().z());
  }
}

TEST_CASE("a locked chart that stands in the way is named, and the offer unlocks it") {
  Editor editor = ringed_sphere();
  const int id = chart_at(editor, at(0, 0.8, 0.6)).id;
  applied(editor, Lock_chart{at(0, 0.8, 0.6), true});
  for (const Edit& edit : {Edit(Set_columns{at(0, 0.8, 0.6), 12}), Edit(Subdivide_chart{at(0, 0.8, 0.6)})}) {
    const Result<Design> refused = editor.preview(edit);
    REQUIRE(!refused);
    CHECK(refused.error().element == Element_kind::chart);
    CHECK(refused.error().index == id);
    const Offer offer = sure_offer(editor, edit);
    CHECK(!std::get<Lock_chart>(offer.edit).locked);
    applied(editor, offer.edit);
    applied(editor, edit);
    editor.undo();
    editor.undo();
  }
}

TEST_CASE("where an extremum is already, another is offered a place beside it") {
  Editor editor = ringed_sphere();
  const int pole = editor.design().extrema[0].vertex;
  const Point p = editor.working_surface().points[std::size_t(pole)];
  const Offer offer = sure_offer(editor, Add_extremum{{p, pole}, true});
  CHECK(offer.words.find("beside") != std::string::npos);
  CHECK((offer.place - p).norm() <= 5.5 * editor.design().edge_length);
  CHECK(std::get<Add_extremum>(offer.edit).at.point == offer.place);
}

TEST_CASE("an extremum on a contour goes to a vertex beside it, at most a quad's edge away") {
  Editor editor = session(shape("sphere", 1200), extrema({0, 0, -1}, {{0, 0, 1}}), 60);
  applied(editor, Subdivide_chart{at(1, 0, 0)});
  const Contour_network& network = editor.design().network;
  const Triangle_surface& surface = editor.working_surface();
  int on_contour = -1;
  for (int e : contours_of(editor))
    for (int v : network.edges[std::size_t(e)].vertices)
      if (v < surface.number_of_vertices()) on_contour = v;
  REQUIRE(on_contour >= 0);
  const double h = editor.design().edge_length;
  const Point p = surface.points[std::size_t(on_contour)];
  applied(editor, Add_extremum{{p, on_contour}, true});
  double least = 10 * h;
  for (const Design_extremum& e : editor.design().extrema)
    least = std::min(least, (surface.points[std::size_t(e.vertex)] - p).norm());
  CHECK(least > 0);
  CHECK(least <= h);
}

TEST_CASE("an extremum that would leave its charts is offered a part of the way, or the whole surface") {
  Editor editor = torus_session();
  const Move_extremum away{at(1.4, 0, 0), at(-1, 0.1, 0.4)};
  const Offer offer = sure_offer(editor, away);
  const Move_extremum& less = std::get<Move_extremum>(offer.edit);
  const bool is_wide = less.scope == Edit_scope::surface;
  CHECK((is_wide || (less.to.point - away.to.point).norm() < (away.from.point - away.to.point).norm()));
}

TEST_CASE("a saddle that would leave its charts is offered a part of the way") {
  Editor editor = torus_session();
  const Move_saddle away{at(-0.6, 0, 0), at(1.2, 0.1, 0.3)};
  refused(editor, away, "the saddle would leave its charts");
  const Offer offer = sure_offer(editor, away);
  CHECK(offer.words.find("of the way") != std::string::npos);
  CHECK((offer.place - Point(-0.6, 0, 0)).norm() < (away.to.point - Point(-0.6, 0, 0)).norm());
}

TEST_CASE("what is never possible, or was no refusal, has no offer; without a design there is none either") {
  Editor editor = torus_session();
  CHECK(!offered(editor, Add_extremum{at(0, 1, 0.4), true, Edit_scope::chart, 2}));
  CHECK(!offered(editor, Remove_extremum{at(1.4, 0, 0)})); // the last maximum
  const Error cancelled = make_error(Error_code::cancelled, "cancelled by the user");
  CHECK(!*offer_after(editor, Subdivide_chart{at(1.4, 0, 0)}, cancelled));
  const Editor empty = std::move(*Editor::create(shape("sphere", 600)));
  CHECK(!offered(empty, Subdivide_chart{at(1, 0, 0)}));
}

TEST_CASE("an offer depends on the design and the edit alone, and the search for one can be stopped") {
  Editor editor = torus_session();
  const Move_saddle away{at(-0.6, 0, 0), at(1.2, 0.1, 0.3)};
  const std::string first = to_json(offered(editor, away)->edit);
  editor.undo();
  editor.redo();
  CHECK(to_json(offered(editor, away)->edit) == first);
  Stopper stop;
  const Result<std::optional<Offer>> stopped = offer_after(editor, away, editor.preview(away).error(), &stop);
  REQUIRE(!stopped);
  CHECK(stopped.error().code == Error_code::cancelled);
}

TEST_CASE("a part of a cap's contour moves between anchors, and the cap keeps its four corners") {
  Editor editor = sphere_session();
  int cap = -1;
  for (int e : contours_of(editor))
    if (points_of(editor, e)[0].z() > 0.3) cap = e;
  REQUIRE(cap >= 0);
  const std::vector<Point> p = points_of(editor, cap);
  const std::size_t n = p.size();
  Move_contour part{{p[n / 2], -1}, p[0], Eigen::Vector3d(0.2, 0.1, 1), {{p[n / 4], -1}, {p[3 * n / 4], -1}}};
  applied(editor, part);
  CHECK(valences(editor) == std::map<int, int>{{3, 8}});
  CHECK(chart_at(editor, at(0, 0, 1)).chart->kind == Chart_kind::disc);
  const Stitched_mesh quads = editor.quads();
  for (const std::size_t i : {n / 4, 3 * n / 4}) {
    double least = 1;
    for (const Point& v : quads.mesh.points) least = std::min(least, (v - p[i]).norm());
    CHECK(least < 1e-12);
  }
}

TEST_CASE("an extremum goes even where nothing in the charts around would be one: wider charts are taken") {
  // Two maxima near to each other, and a third one: around the pair's saddle there is no other maximum.
  Editor editor = session(shape("sphere", 3000), extrema({0, 0, -1}, {{0, 0, 1}, {1, 0, 0}}), 600);
  const Result<Edit_report> more = editor.apply(Add_extremum{at(0, 1, -0.2), false});
  REQUIRE(bool(more));
  std::size_t left = editor.design().extrema.size();
  for (bool again = true; again;) {
    again = false;
    for (const Design_extremum& e : std::vector<Design_extremum>(editor.design().extrema)) {
      std::size_t same = 0;
      for (const Design_extremum& o : editor.design().extrema) same += o.is_maximum == e.is_maximum;
      if (same == 1) continue;
      const Point p = editor.working_surface().points[std::size_t(e.vertex)];
      INFO(p.transpose());
      applied(editor, Remove_extremum{{p, e.vertex}});
      CHECK(editor.design().extrema.size() == --left);
      again = true;
      break;
    }
  }
  CHECK(left == 2);
}
