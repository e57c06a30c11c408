// SPDX-License-Identifier: GPL-3.0-or-later
// Tiny textures, and what every texture must satisfy.
#ifndef REEBQUAD_TEST_TINY_TEXTURES_H
#define REEBQUAD_TEST_TINY_TEXTURES_H

#include <CGAL/Reeb_quadrangulation/Texture_edit.h>

#include "tiny_surfaces.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>

namespace tiny {

using namespace CGAL::Reeb_quadrangulation;

inline Quad_texture annulus_texture(int columns, int rows) {
  std::vector<double> levels;
  for (int r = 0; r <= rows; ++r) levels.push_back(double(r) / rows);
  return regular_annulus_texture(columns, levels);
}

inline Quad_texture disc_texture(int a, int b) {
  return regular_disc_texture(a, b, false);
}

/// A quad mesh of its domain, bounded by its sides, that tiles the plane.
inline bool is_sound(const Quad_texture& texture, bool clockwise = false) {
  std::vector<int> samples;
  for (const std::vector<int>& side : texture.sides) samples.push_back(int(side.size()));
  const Result<void> mesh = check_texture(texture, samples, clockwise), plane = check_texture_plane(texture);
  if (!mesh) UNSCOPED_INFO(mesh.error().message);
  if (!plane) UNSCOPED_INFO(plane.error().message);
  return mesh && plane;
}

inline Quad_texture applied(const Quad_texture& texture, const Texture_edit& edit) {
  const Result<Edited_texture> result = edit_texture(texture, edit);
  if (!result) FAIL(result.error().message);
  CHECK(is_sound(result->texture));
  return result->texture;
}

inline std::string reason(const Quad_texture& texture, const Texture_edit& edit) {
  const Result<Edited_texture> result = edit_texture(texture, edit);
  if (result) return "applied";
  CHECK(result.error().code == Error_code::refused_edit);
  return result.error().message;
}

/// Valence -> number of vertices inside.
inline std::map<int, int> inner_valences(const Quad_texture& texture) {
  std::vector<int> quads(texture.v.size(), 0);
  for (const Quad& q : texture.quads)
    for (int v : q) ++quads[v];
  for (const std::vector<int>& side : texture.sides)
    for (int v : side) quads[v] = 0;
  std::map<int, int> out;
  for (int n : quads)
    if (n > 0) ++out[n];
  return out;
}

inline std::string bytes(const Quad_texture& t) {
  std::string out;
  const auto add = [&](const void* p, std::size_t n) {
    if (n > 0) out.append(static_cast<const char*>(p), n);
    out += '|';
  };
  add(t.v.data(), t.v.size() * sizeof(double));
  add(t.u.data(), t.u.size() * sizeof(double));
  add(t.quads.data(), t.quads.size() * sizeof(Quad));
  for (const std::vector<int>& side : t.sides) add(side.data(), side.size() * sizeof(int));
  add(t.holes.data(), t.holes.size());
  return out;
}

/// The same texture up to the numbers of its vertices and quads and the corner where a quad begins.
inline bool same_mesh(const Quad_texture& a, const Quad_texture& b, double tolerance = 0) {
  if (a.v.size() != b.v.size() || a.quads.size() != b.quads.size()) return false;
  std::vector<int> to(a.v.size(), -1);
  for (std::size_t i = 0; i < a.v.size(); ++i)
    for (std::size_t j = 0; j < b.v.size() && to[i] < 0; ++j)
      if (std::abs(a.v[i] - b.v[j]) <= tolerance && std::abs(a.u[i] - b.u[j]) <= tolerance) to[i] = int(j);
  const auto canonical = [](const Quad_texture& t, const std::vector<int>* name) {
    std::map<Quad, char> out;
    for (std::size_t f = 0; f < t.quads.size(); ++f) {
      Quad q = t.quads[f], best{};
      if (name)
        for (int& v : q) v = (*name)[v];
      for (int i = 0; i < 4; ++i) {
        const Quad turned{q[i], q[(i + 1) % 4], q[(i + 2) % 4], q[(i + 3) % 4]};
        if (i == 0 || turned < best) best = turned;
      }
      out[best] = t.is_hole(int(f));
    }
    return out;
  };
  std::vector<std::vector<int>> sides = a.sides;
  for (std::vector<int>& side : sides)
    for (int& v : side) v = to[v];
  return sides == b.sides && canonical(a, &to) == canonical(b, nullptr);
}

} // namespace tiny

#endif // REEBQUAD_TEST_TINY_TEXTURES_H
