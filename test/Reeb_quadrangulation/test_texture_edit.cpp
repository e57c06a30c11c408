// SPDX-License-Identifier: GPL-3.0-or-later
#include "tiny_textures.h"

using namespace tiny;
using Catch::Contains;

namespace {

Texture_place at(double v, double u) {
  return {v, u};
}

} // namespace

TEST_CASE("a place names a quad, its nearest edge and its nearest corner") {
  const Quad_texture t = disc_texture(3, 2);
  REQUIRE(find_quad(t, at(1.5, 0.5)));
  CHECK(find_quad(t, at(1.5, 0.5))->quad == 1);
  CHECK(find_edge(t, at(1.5, 0.1))->corner == 0);
  CHECK(find_edge(t, at(1.9, 0.5))->corner == 1);
  CHECK(find_edge(t, at(1.5, 0.9))->corner == 2);
  CHECK(find_vertex(t, at(1.8, 0.9))->corner == 2);
  CHECK(find_vertex(t, at(1.1, 0.6))->corner == 3);
  CHECK(!find_quad(t, at(3.5, 0.5)));
  CHECK(!find_quad(t, {0, 0, 6, 0}));
  CHECK(find_quad(t, {0, 0, 5, 3})->quad == 5);
}

TEST_CASE("a place on an annulus may be given on any turn, and quads over the seam are found") {
  const Quad_texture t = annulus_texture(5, 2);
  for (double turn : {-2.0, 0.0, 1.0}) CHECK(find_quad(t, at(0.95 + turn, 0.25))->quad == 4);
  CHECK(find_edge(t, at(0.99, 0.25))->corner == 1);
}

TEST_CASE("places by points name the same elements as places by numbers") {
  Quad_texture t = annulus_texture(6, 3);
  t = applied(t, Close_quad{at(0.25, 0.5), 0.3});
  t = applied(t, Inset_quads{{at(0.6, 0.5)}, 0.5});
  for (int f = 0; f < int(t.quads.size()); ++f) {
    CHECK(find_quad(t, quad_place(t, f))->quad == f);
    for (int i = 0; i < 4; ++i) {
      CHECK(find_edge(t, edge_place(t, {f, i}))->corner == i);
      CHECK(find_vertex(t, vertex_place(t, {f, i}))->corner == i);
      CHECK(edge_place(t, {f, i}).quad == -1);
    }
  }
}

TEST_CASE("every edge and corner of a concave quad is named by a point near it") {
  tiny::Random random(11);
  int reflex = 0;
  for (int round = 0; round < 200; ++round) {
    Quad_texture t = annulus_texture(8, 6);
    const int v = t.quads[20][0];
    // An inner vertex goes nearly as far as its quads allow: some become concave, and some have a straight
    // corner.
    for (const double far : {0.99, 0.7, 0.4}) {
      const double angle = round % 8 == 0 ? 0.25 * std::acos(-1.0) : 6.283185307 * random.unit();
      const Texture_place place{0, 0, 20, 0};
      const auto moved = edit_texture(t, Move_vertices{{place},
                                                       far * std::cos(angle) / 8,
                                                       far * std::sin(angle) / 6,
                                                       0,
                                                       1,
                                                       Falloff::smooth,
                                                       0,
                                                       0,
                                                       {}});
      if (moved) t = moved->texture;
    }
    REQUIRE(check_texture_plane(t));
    for (int f = 0; f < int(t.quads.size()); ++f) {
      if (std::find(t.quads[f].begin(), t.quads[f].end(), v) == t.quads[f].end()) continue;
      const auto p = [&](int i) { // around the annulus from the first corner
        const int w = t.quads[f][i % 4];
        return Eigen::Vector2d(t.v[w] + std::round(t.v[t.quads[f][0]] - t.v[w]), t.u[w]);
      };
      bool concave = false, nearly_straight = false; // but convex
      for (int i = 0; i < 4; ++i) {
        const Eigen::Vector2d a = p(i + 1) - p(i), b = p(i + 2) - p(i + 1);
        const double turn = a.x() * b.y() - a.y() * b.x();
        concave = concave || turn < -1e-6;
        nearly_straight = nearly_straight || (turn > 0 && turn < 1e-9);
      }
      if (nearly_straight) continue;
      reflex += concave;
      for (int i = 0; i < 4; ++i) {
        const Texture_place edge = edge_place(t, {f, i}), corner = vertex_place(t, {f, i});
        CHECK(edge.quad == -1);
        CHECK(corner.quad == -1);
        CHECK(find_edge(t, edge)->quad == f);
        CHECK(find_edge(t, edge)->corner == i);
        CHECK(find_vertex(t, corner)->quad == f);
        CHECK(find_vertex(t, corner)->corner == i);
        if (!concave) continue;
        const Eigen::Vector2d middle = 0.5 * (p(i) + p(i + 1)); // the edge at hand, not another
        CHECK(std::hypot(std::remainder(edge.v - middle.x(), 1.0), edge.u - middle.y()) < 0.02);
      }
    }
  }
  CHECK(reflex > 50);
}

TEST_CASE("global subdivision and its reverse give the same bytes") {
  for (const Quad_texture& t :
       {disc_texture(1, 1), disc_texture(3, 2), annulus_texture(4, 2), annulus_texture(7, 3)}) {
    const Result<Edited_texture> fine = edit_texture(t, Subdivide_texture{});
    REQUIRE(fine);
    CHECK(is_sound(fine->texture));
    CHECK(fine->texture.quads.size() == 4 * t.quads.size());
    for (std::size_t w = 0; w < t.sides.size(); ++w) {
      REQUIRE(fine->side_steps[w].size() == 2 * t.sides[w].size());
      for (std::size_t i = 0; i < fine->side_steps[w].size(); ++i)
        CHECK(fine->side_steps[w][i] == 0.5 * double(i));
    }
    CHECK(bytes(applied(fine->texture, Coarsen_texture{})) == bytes(t));
  }
  CHECK_THAT(reason(annulus_texture(5, 2), Coarsen_texture{}), Contains("connectivity of a subdivided"));
  CHECK_THAT(reason(annulus_texture(4, 3), Coarsen_texture{}), Contains("connectivity of a subdivided"));
}

TEST_CASE("a polychord across an annulus lengthens both sides, and its deletion shortens them") {
  const Quad_texture t = annulus_texture(6, 3);
  const Insert_polychord insert{at(0.25, 0.01), 0.25};
  const Result<Edited_texture> more = edit_texture(t, insert);
  REQUIRE(more);
  CHECK(is_sound(more->texture));
  CHECK(more->texture.quads.size() == 21);
  CHECK(more->side_steps[0] == std::vector<double>{0, 1, 1.25, 2, 3, 4, 5});
  CHECK(more->side_steps[1] == more->side_steps[0]);
  const auto ends = polychord_ends(t, insert);
  REQUIRE(ends);
  REQUIRE(ends->size() == 2);
  CHECK((*ends)[0].side == 1);
  CHECK((*ends)[1].side == 0);
  for (const Polychord_end& e : *ends) {
    CHECK(e.step == 1);
    CHECK(e.fraction == 0.25);
  }
  // The strip to the right of the new line, collapsed onto its right rail.
  CHECK(same_mesh(applied(more->texture, Delete_polychord{at(0.25, 0.01), 1}), t));
}

TEST_CASE("a polychord around an annulus leaves the sides alone") {
  const Quad_texture t = annulus_texture(6, 3);
  const Insert_polychord insert{at(0.17, 0.5)};
  const Quad_texture more = applied(t, insert);
  CHECK(more.quads.size() == 24);
  CHECK(more.sides == t.sides);
  CHECK(polychord_ends(t, insert)->empty());
  CHECK(applied(more, Delete_polychord{at(0.17, 0.4)}).quads.size() == 18);
  CHECK_THAT(reason(annulus_texture(4, 2), Delete_polychord{at(0.01, 0.25)}), Contains("side to side"));
  CHECK_THAT(reason(annulus_texture(4, 1), Delete_polychord{at(0.01, 0.5)}),
             Contains("vertices of the sides"));
}

TEST_CASE("a disc keeps its corners, an annulus its entry 0, and what it is told to keep") {
  CHECK_THAT(reason(disc_texture(1, 3), Delete_polychord{at(0.5, 0.1)}), Contains("must stay"));
  const Quad_texture less = applied(disc_texture(2, 2), Delete_polychord{at(0.5, 0.01), 1});
  CHECK(less.sides[0].size() == 6);
  for (const double u : {0.0, 2.0})
    for (const double v : {0.0, 2.0}) {
      bool found = false;
      for (int s : less.sides[0]) found = found || (less.v[s] == v && less.u[s] == u);
      CHECK(found);
    }
  const Quad_texture t = annulus_texture(5, 2);
  const Delete_polychord collapse{at(0.3, 0.01), 0.5};
  CHECK(edit_texture(t, collapse)->side_steps[0] == std::vector<double>{0, 1, 3, 4});
  CHECK(edit_texture(t, collapse, {{{2}, {}}})->side_steps[0] == std::vector<double>{0, 2, 3, 4});
  CHECK_THAT(edit_texture(t, collapse, {{{1, 2}, {}}}).error().message, Contains("must stay"));
  CHECK(edit_texture(t, Delete_polychord{at(0.9, 0.01), 0})->side_steps[0] ==
        std::vector<double>{0, 1, 2, 3});
}

TEST_CASE("an edge of an annulus must be shorter than half a turn") {
  CHECK(applied(annulus_texture(5, 2), Delete_polychord{at(0.3, 0.01)}).sides[0].size() == 4);
  CHECK_THAT(reason(annulus_texture(4, 2), Delete_polychord{at(0.3, 0.01)}), Contains("invert"));
  CHECK_THAT(reason(annulus_texture(3, 2), Delete_polychord{at(0.5, 0.01)}), Contains("two edges"));
}

TEST_CASE("an inset makes a ring around a quad, with eight extraordinary vertices") {
  const Quad_texture t = annulus_texture(6, 3);
  const Quad_texture cube = applied(t, Inset_quads{{at(0.25, 0.5)}, 0.5});
  CHECK(cube.quads.size() == t.quads.size() + 4);
  CHECK(inner_valences(cube) == std::map<int, int>{{3, 4}, {4, 8}, {5, 4}});
  CHECK(cube.sides == t.sides);
  const Quad_texture back = applied(cube, Delete_polychord{at(0.17, 0.35), 0});
  CHECK(inner_valences(back) == inner_valences(t));
}

TEST_CASE("an inset of a region may touch the sides, and be undone by deleting its ring") {
  const Quad_texture t = disc_texture(4, 4);
  const Quad_texture cube = applied(t, Inset_quads{{at(0.5, 0.5), at(1.5, 0.5), at(1.5, 1.5)}, 0.5});
  CHECK(cube.quads.size() == 16 + 8);
  const Quad_texture back = applied(cube, Delete_polychord{edge_place(cube, side_edge(cube, 0, 0)), 0.5});
  CHECK(back.quads.size() < cube.quads.size());
  CHECK_THAT(reason(t, Inset_quads{{at(0.5, 0.5), at(1.5, 1.5)}, 0.5}), Contains("touches itself"));
  CHECK_THAT(reason(t, Inset_quads{{}, 0.5}), Contains("no quads"));
  CHECK_THAT(reason(t, Inset_quads{{at(0.5, 0.5)}, 1.5}), Contains("between 0 and 1"));
  // All of an annulus: a new row along either side.
  CHECK(inner_valences(applied(annulus_texture(4, 1),
                               Inset_quads{{at(0.1, 0.5), at(0.3, 0.5), at(0.6, 0.5), at(0.9, 0.5)}, 0.5})) ==
        std::map<int, int>{{4, 8}});
}

TEST_CASE("opening a quad and closing it") {
  const Quad_texture t = disc_texture(4, 4);
  const Quad_texture open = applied(t, Open_quad{at(1.5, 1.99), at(2.5, 1.99), 0.5});
  CHECK(open.quads.size() == 17);
  CHECK(inner_valences(open) == std::map<int, int>{{3, 2}, {4, 6}, {5, 2}});
  const Quad_texture closed = applied(open, Close_quad{at(2, 2.05)});
  CHECK(same_mesh(closed, t, 1e-15));
  // Two edges at a right angle: one of the two new vertices has one old quad, which moves away.
  CHECK(inner_valences(applied(t, Open_quad{at(1.5, 1.99), at(2.01, 2.5), 0.5})) ==
        std::map<int, int>{{2, 1}, {4, 7}, {5, 2}});
  CHECK_THAT(reason(t, Open_quad{at(1.5, 1.99), at(1.5, 1.99)}), Contains("do not meet"));
  CHECK_THAT(reason(t, Open_quad{at(0.5, 0.9), at(2.5, 1.99)}), Contains("do not meet"));
}

TEST_CASE("opening at a side vertex leaves the side as it is") {
  const Quad_texture t = disc_texture(4, 4);
  for (const Open_quad& edit :
       {Open_quad{at(1.5, 0.01), at(2.5, 0.01)}, Open_quad{at(2.01, 0.5), at(2.5, 0.01)},
        Open_quad{at(1.5, 0.01), at(2.01, 0.5)}}) {
    const Result<Edited_texture> open = edit_texture(t, edit);
    REQUIRE(open);
    CHECK(is_sound(open->texture));
    CHECK(open->texture.sides == t.sides);
    CHECK(open->texture.quads.size() == 17);
  }
}

TEST_CASE("closing a quad at a side keeps the side's vertex") {
  const Quad_texture t = annulus_texture(6, 3);
  const Quad_texture closed = applied(t, Close_quad{at(0.18, 0.05), 0.5});
  CHECK(closed.quads.size() == 17);
  CHECK(closed.sides[0].size() == 6);
  for (int i = 0; i < 6; ++i) CHECK(closed.u[closed.sides[0][i]] == 0);
  CHECK_THAT(reason(annulus_texture(6, 1), Close_quad{at(0.18, 0.05)}), Contains("sides"));
}

TEST_CASE("an edge turns one way and back") {
  const Quad_texture t = disc_texture(4, 3);
  for (bool ccw : {false, true}) {
    const Quad_texture turned = applied(t, Rotate_edge{at(1.99, 1.5), ccw});
    CHECK(inner_valences(turned) == std::map<int, int>{{3, 2}, {4, 2}, {5, 2}});
    // The edge now lies across its hexagon.
    const Texture_place place = at(2.0, ccw ? 1.49 : 1.51);
    CHECK(same_mesh(applied(turned, Rotate_edge{place, !ccw}), t));
  }
  CHECK_THAT(reason(t, Rotate_edge{at(1.5, 0.01), true}), Contains("not on a side"));
}

TEST_CASE("turning a vertex twice changes nothing, and takes an edge from each neighbour") {
  const Quad_texture t = disc_texture(6, 6);
  const Quad_texture turned = applied(t, Rotate_vertex{at(3.1, 3.1)});
  CHECK(inner_valences(turned) == std::map<int, int>{{3, 4}, {4, 17}, {5, 4}});
  CHECK(same_mesh(applied(turned, Rotate_vertex{at(3.1, 3.1)}), t));
  CHECK_THAT(reason(t, Rotate_vertex{at(0.1, 3.1)}), Contains("not on a side"));
}

TEST_CASE("a doublet comes and goes") {
  const Quad_texture t = disc_texture(3, 3);
  const Quad_texture doublet = applied(t, Insert_doublet{at(1.1, 1.1)});
  CHECK(doublet.quads.size() == 10);
  CHECK(inner_valences(doublet) == std::map<int, int>{{2, 1}, {4, 2}, {5, 2}});
  CHECK(same_mesh(applied(doublet, Remove_doublet{at(1.51, 1.5)}), t));
  CHECK_THAT(reason(t, Remove_doublet{at(1.1, 1.1)}), Contains("no doublet"));
  CHECK_THAT(reason(t, Remove_doublet{at(0.1, 1.1)}), Contains("not on a side"));
}

TEST_CASE("closing a quad beside a doublet removes the singlet that it would leave") {
  const Quad_texture t = applied(disc_texture(3, 3), Insert_doublet{at(1.1, 1.1)});
  // The corner of the lower right quad at (2, 1): its diagonal joins it with the doublet's vertex; the other
  // joins the doublet's ends.
  const Result<Quad_corner> corner = find_vertex(t, at(1.15, 1.02));
  REQUIRE(corner);
  const Quad_texture closed = applied(t, Close_quad{{0, 0, corner->quad, corner->corner}, 0.5});
  CHECK(closed.quads.size() == 8);
  CHECK(inner_valences(closed).count(1) == 0);
}

TEST_CASE("holes stay in the texture, go with its quads, and can be filled") {
  const Quad_texture t = annulus_texture(6, 3);
  const Quad_texture hole = applied(t, Delete_quads{{at(0.25, 0.5), at(0.42, 0.5)}});
  CHECK(hole.quads == t.quads);
  CHECK(hole.holes[7] + hole.holes[8] == 2);
  Quad_texture bad = hole;
  bad.holes.pop_back();
  CHECK_THAT(check_texture(bad, {6, 6}, false).error().message, Contains("hole"));
  CHECK_THAT(reason(bad, Subdivide_texture{}), Contains("arrays"));
  CHECK(bytes(applied(hole, Restore_quads{{at(0.25, 0.5), at(0.42, 0.5)}})) == bytes(t));
  const Quad_texture fine = applied(hole, Subdivide_texture{});
  CHECK(std::count(fine.holes.begin(), fine.holes.end(), 1) == 8);
  CHECK(bytes(applied(fine, Coarsen_texture{})) == bytes(hole));
  CHECK_THAT(reason(hole, Delete_quads{{at(0.25, 0.5)}}), Contains("already"));
  CHECK_THAT(reason(hole, Restore_quads{{at(0.25, 0.1)}}), Contains("no hole"));
  CHECK_THAT(reason(hole, Delete_quads{{at(0.6, 0.9)}}), Contains("one fan"));
  CHECK_THAT(reason(hole, Rotate_edge{at(0.25, 0.35), true}), Contains("border of a hole"));
  CHECK_THAT(reason(disc_texture(1, 1), Delete_quads{{at(0.5, 0.5)}}), Contains("no quad"));
}

TEST_CASE("a moved vertex goes where it is told, or as far as no quad inverts") {
  const Quad_texture t = disc_texture(4, 4);
  Move_vertices move;
  move.vertices = {at(2.1, 2.1)};
  move.dv = 0.25;
  move.du = -0.5;
  const Quad_texture moved = applied(t, move);
  CHECK(moved.v[12] == 2.25);
  CHECK(moved.u[12] == 1.5);
  for (std::size_t i = 0; i < t.v.size(); ++i)
    if (i != 12) CHECK((moved.v[i] == t.v[i] && moved.u[i] == t.u[i]));
  move.dv = 100;
  const Quad_texture far = applied(t, move);
  CHECK(far.v[12] > 2);
  CHECK(far.v[12] < 3);
  move.vertices = {at(0.1, 2.1)};
  CHECK_THAT(reason(t, move), Contains("side vertices"));
  move.vertices.clear();
  CHECK_THAT(reason(t, move), Contains("no vertices"));
}

TEST_CASE("a brush moves near vertices more than far ones, and anchors not at all") {
  const Quad_texture t = disc_texture(8, 8);
  for (Falloff falloff : {Falloff::constant, Falloff::linear, Falloff::smooth}) {
    Move_vertices move;
    move.vertices = {at(4.1, 4.1)};
    move.anchors = {at(4.1, 5.1)};
    move.dv = 0.3;
    move.radius = 2.5;
    move.falloff = falloff;
    const Quad_texture moved = applied(t, move);
    const auto shift = [&](int x, int y) { return moved.v[y * 9 + x] - t.v[y * 9 + x]; };
    CHECK(shift(4, 4) == Approx(0.3));
    CHECK(shift(4, 5) == 0);
    CHECK(shift(4, 7) == 0);
    CHECK(shift(0, 4) == 0);
    if (falloff == Falloff::constant)
      CHECK(shift(4, 2) == Approx(0.3));
    else {
      CHECK(shift(4, 3) > shift(4, 2));
      CHECK(shift(4, 2) > 0);
    }
  }
}

TEST_CASE("relaxation brings a disturbed grid back, but for anchors") {
  const Quad_texture t = disc_texture(6, 5);
  Quad_texture noisy = t;
  Random random(7);
  for (int y = 1; y < 5; ++y)
    for (int x = 1; x < 6; ++x) {
      noisy.v[y * 7 + x] += 0.6 * (random.unit() - 0.5);
      noisy.u[y * 7 + x] += 0.6 * (random.unit() - 0.5);
    }
  REQUIRE(is_sound(noisy));
  const Quad_texture relaxed = applied(noisy, Relax_vertices{{}, 200, {}});
  CHECK(same_mesh(relaxed, t, 1e-6));
  const Quad_texture held = applied(noisy, Relax_vertices{{}, 200, {vertex_place(noisy, {8, 0})}});
  const int anchor = noisy.quads[8][0];
  CHECK(held.v[anchor] == noisy.v[anchor]);
  CHECK(!same_mesh(held, t, 1e-6));
}

TEST_CASE("moving with relaxation draws the neighbours along") {
  const Quad_texture t = annulus_texture(8, 6);
  Move_vertices move;
  move.vertices = {at(0.01, 0.51)};
  move.dv = -0.05;
  move.du = 0.05;
  const Quad_texture alone = applied(t, move);
  move.steps = 5;
  const Quad_texture drawn = applied(t, move);
  CHECK(drawn.v[24] == alone.v[24]);
  CHECK(drawn.v[24] == Approx(0.95));
  CHECK(drawn.u[32] > alone.u[32]);
  CHECK(drawn.sides == t.sides);
}

TEST_CASE("a texture that is none is refused, not read out of its bounds") {
  Quad_texture t = disc_texture(2, 2);
  t.quads[0][0] = 99;
  CHECK_THAT(reason(t, Subdivide_texture{}), Contains("does not exist"));
  t = disc_texture(2, 2);
  t.u.pop_back();
  CHECK_THAT(reason(t, Subdivide_texture{}), Contains("arrays"));
  t = disc_texture(2, 2);
  t.sides[0].clear();
  CHECK_THAT(reason(t, Subdivide_texture{}), Contains("side"));
  t = disc_texture(2, 2);
  t.quads.pop_back();
  CHECK_THAT(reason(t, Subdivide_texture{}), Contains("side"));
  CHECK_THAT(reason(disc_texture(2, 2), Subdivide_texture{}), Contains("applied"));
  CHECK_THAT(reason(disc_texture(2, 2), Close_quad{at(std::nan(""), 0)}), Contains("finite"));
}

TEST_CASE("each edit has its name") {
  CHECK(std::string(name(Texture_edit(Subdivide_texture{}))) == "subdivide_texture");
  CHECK(std::string(name(Texture_edit(Open_quad{}))) == "open_quad");
  CHECK(std::string(name(Texture_edit(Relax_vertices{}))) == "relax_vertices");
}
