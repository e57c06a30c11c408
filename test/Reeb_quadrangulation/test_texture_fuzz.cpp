// SPDX-License-Identifier: GPL-3.0-or-later
// Random edits of random textures.
#include "tiny_textures.h"

#include <algorithm>

using namespace tiny;

namespace {

Quad_texture random_texture(Random& random) {
  if (random.below(2) == 0) return annulus_texture(4 + random.below(8), 2 + random.below(4));
  return regular_disc_texture(1 + random.below(7), 1 + random.below(7), random.below(2) == 1);
}

bool is_annulus(const Quad_texture& t) {
  return t.sides.size() == 2;
}

/// By a point anywhere in the domain, or by a quad and a corner.
Texture_place random_place(Random& random, const Quad_texture& t) {
  if (random.below(2) == 0) return {0, 0, random.below(int(t.quads.size())), random.below(4)};
  const double width = is_annulus(t) ? 1 : *std::max_element(t.v.begin(), t.v.end());
  const double height = *std::max_element(t.u.begin(), t.u.end());
  return {width * random.unit(), height * random.unit()};
}

std::vector<Texture_place> random_places(Random& random, const Quad_texture& t) {
  std::vector<Texture_place> places;
  for (int n = 1 + random.below(3); n > 0; --n) places.push_back(random_place(random, t));
  return places;
}

/// The operators that make a texture larger are drawn only while it is small.
Texture_edit random_edit(Random& random, const Quad_texture& t) {
  const bool small = t.quads.size() < 120;
  const auto place = [&] { return random_place(random, t); };
  switch (random.below(18)) {
  case 0: return small ? Texture_edit(Subdivide_texture{}) : Texture_edit(Coarsen_texture{});
  case 1: return Coarsen_texture{};
  case 2:
    return small ? Texture_edit(Insert_polychord{place(), random.unit()})
                 : Texture_edit(Delete_polychord{place(), 0.5});
  case 3: return Delete_polychord{place(), random.unit()};
  case 4:
    return small ? Texture_edit(Inset_quads{random_places(random, t), random.unit()})
                 : Texture_edit(Close_quad{place()});
  case 5: return Open_quad{place(), place(), random.unit()};
  case 6: { // two edges of one vertex
    const int f = random.below(int(t.quads.size())), i = random.below(4);
    return Open_quad{{0, 0, f, i}, {0, 0, f, (i + 1) % 4}, random.unit()};
  }
  case 7:
  case 8: return Close_quad{place(), random.unit()};
  case 9: return Rotate_edge{place(), true};
  case 10: return Rotate_edge{place(), false};
  case 11: return Rotate_vertex{place()};
  case 12: return Insert_doublet{place()};
  case 13: return Remove_doublet{place()};
  case 14: return Delete_quads{random_places(random, t)};
  case 15: {
    const auto hole = std::find(t.holes.begin(), t.holes.end(), 1);
    if (hole == t.holes.end()) return Restore_quads{random_places(random, t)};
    return Restore_quads{{{0, 0, int(hole - t.holes.begin()), 0}}};
  }
  case 16: {
    Move_vertices move;
    move.vertices = {place()};
    move.dv = random.unit() - 0.5;
    move.du = random.unit() - 0.5;
    move.radius = random.below(2) * 0.5 * random.unit();
    move.falloff = Falloff(random.below(3));
    move.steps = random.below(3);
    if (random.below(2) == 0) move.anchors = {place()};
    return move;
  }
  default: return Relax_vertices{{}, 1 + random.below(3), {}};
  }
}

/// Twice the area that the quads cover in the plane.
double covered_area(const Quad_texture& t) {
  double sum = 0;
  for (const Quad& q : t.quads) {
    double v[4];
    for (int i = 0; i < 4; ++i) {
      v[i] = t.v[q[i]] - t.v[q[0]];
      if (is_annulus(t))
        v[i] -= std::round(v[i]); // a quad that is wider than half a turn is unrolled wrongly, see below
    }
    for (int i = 0; i < 4; ++i) sum += v[i] * t.u[q[(i + 1) % 4]] - v[(i + 1) % 4] * t.u[q[i]];
  }
  return sum;
}

/// Whether no quad reaches further than half a turn, so that `covered_area()` counts right.
bool is_narrow(const Quad_texture& t) {
  for (const Quad& q : t.quads)
    for (int i = 0; i < 4; ++i) {
      double d[2];
      for (int k = 0; k < 2; ++k) {
        d[k] = t.v[q[(i + k + 1) % 4]] - t.v[q[(i + k) % 4]];
        d[k] -= std::round(d[k]);
      }
      if (std::abs(d[0] + d[1]) >= 0.5) return false;
    }
  return true;
}

} // namespace

TEST_CASE("20,000 random operators: always a tiling of the domain, and values stay as they are") {
  Random random(2026);
  int tried = 0;
  std::map<std::string, int> applied;
  while (tried < 20000) {
    Quad_texture t = random_texture(random);
    const bool clockwise = !is_annulus(t) && t.quads.size() > 0 && [&] {
      const std::vector<int>& s = t.sides[0];
      return t.v[s[1]] == t.v[s[0]];
    }();
    const double area = covered_area(t);
    std::vector<Quad_texture> history{t};
    std::vector<std::string> wanted{bytes(t)};
    std::vector<Texture_edit> edits;
    for (int k = 0; k < 100; ++k, ++tried) {
      const Texture_edit edit = random_edit(random, t);
      const Result<Edited_texture> result = edit_texture(t, edit);
      if (bytes(t) != wanted.back()) FAIL("an edit has changed its input");
      if (!result) {
        if (result.error().code != Error_code::refused_edit || result.error().message.empty())
          FAIL("an edit was refused without a reason");
        continue;
      }
      ++applied[name(edit)];
      t = result->texture;
      INFO(name(edit) << ", trial " << tried);
      if (!is_sound(t, clockwise)) FAIL("the texture is not sound");
      if (!is_annulus(t) || is_narrow(t)) REQUIRE(covered_area(t) == Approx(area).epsilon(1e-9));
      for (std::size_t w = 0; w < t.sides.size(); ++w) {
        if (result->side_steps[w].size() != t.sides[w].size())
          FAIL("a side has not one step for each vertex");
        if (!std::is_sorted(result->side_steps[w].begin(), result->side_steps[w].end()))
          FAIL("a side is out of order");
      }
      history.push_back(t);
      wanted.push_back(bytes(t));
      edits.push_back(edit);
    }
    // Undo: the values kept. Redo: the edits again.
    for (std::size_t i = 0; i < history.size(); ++i)
      if (bytes(history[i]) != wanted[i]) FAIL("a value that was kept has changed");
    Quad_texture again = history.front();
    for (std::size_t i = 0; i < edits.size(); ++i) {
      again = edit_texture(again, edits[i])->texture;
      if (bytes(again) != wanted[i + 1]) FAIL("an edit gives other bytes the second time");
    }
  }
  for (const auto& [edit, times] : applied) {
    UNSCOPED_INFO(edit << ": " << times);
    CHECK(times >= 20);
  }
  CHECK(applied.size() == std::variant_size_v<Texture_edit>);
}

TEST_CASE("operators and their inverses on random textures") {
  Random random(3);
  int pairs = 0;
  for (int k = 0; k < 3000; ++k) {
    Quad_texture t = random_texture(random);
    for (int n = random.below(4); n > 0; --n)
      if (const auto next = edit_texture(t, random_edit(random, t))) t = next->texture;
    const Result<Edited_texture> fine = edit_texture(t, Subdivide_texture{});
    if (fine && t.quads.size() < 40) {
      const Result<Edited_texture> coarse = edit_texture(fine->texture, Coarsen_texture{});
      REQUIRE(coarse);
      CHECK(bytes(coarse->texture) == bytes(t));
    }
    const Quad_corner corner{random.below(int(t.quads.size())), random.below(4)};
    const int v = t.quads[corner.quad][corner.corner];
    const Result<Edited_texture> turned = edit_texture(t, Rotate_vertex{{0, 0, corner.quad, corner.corner}});
    if (turned) {
      int f = 0;
      while (std::find(turned->texture.quads[f].begin(), turned->texture.quads[f].end(), v) ==
             turned->texture.quads[f].end())
        ++f;
      const Quad& q = turned->texture.quads[f];
      const Result<Edited_texture> back = edit_texture(
          turned->texture, Rotate_vertex{{0, 0, f, int(std::find(q.begin(), q.end(), v) - q.begin())}});
      REQUIRE(back);
      CHECK(same_mesh(back->texture, t));
      ++pairs;
    }
    const Result<Edited_texture> edge =
        edit_texture(t, Rotate_edge{{0, 0, corner.quad, corner.corner}, true});
    if (edge) { // the new edge is the one from corner 3 to corner 0 of the last but one quad
      const Result<Edited_texture> back =
          edit_texture(edge->texture, Rotate_edge{{0, 0, int(edge->texture.quads.size()) - 2, 3}, false});
      REQUIRE(back);
      CHECK(same_mesh(back->texture, t));
      ++pairs;
    }
    const Result<Edited_texture> doublet =
        edit_texture(t, Insert_doublet{{0, 0, corner.quad, corner.corner}});
    if (doublet) {
      const Result<Edited_texture> back =
          edit_texture(doublet->texture, Remove_doublet{{0, 0, int(doublet->texture.quads.size()) - 1, 1}});
      REQUIRE(back);
      CHECK(same_mesh(back->texture, t));
      ++pairs;
    }
  }
  CHECK(pairs > 1000);
}
