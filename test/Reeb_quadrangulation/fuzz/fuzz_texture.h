// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes as edits of a connectivity texture: what is applied leaves a sound texture, what is refused leaves it
// alone.
#ifndef FUZZ_TEXTURE_H
#define FUZZ_TEXTURE_H

#include "fuzz_promise.h"

#include <CGAL/Reeb_quadrangulation/Texture_edit.h>

#include <cstdint>
#include <cstring>
#include <vector>

namespace fuzz {

using namespace CGAL::Reeb_quadrangulation;

/// Takes numbers from bytes, zeros after the end.
class Bytes {
public:
  Bytes(const std::uint8_t* data, std::size_t size) : m_data(data), m_size(size) {}
  bool at_end() const { return m_at >= m_size; }
  std::uint8_t byte() { return at_end() ? std::uint8_t(0) : m_data[m_at++]; }
  /// Mostly between 0 and 1, sometimes any double.
  double number() {
    const std::uint8_t b = byte();
    if (b < 250) return b / 249.0;
    std::uint8_t raw[8];
    for (std::uint8_t& r : raw) r = byte();
    double x;
    std::memcpy(&x, raw, sizeof x);
    return x;
  }
  Texture_place place() {
    Texture_place p;
    if (byte() % 4 != 0) {
      p.v = number();
      p.u = number();
      return p;
    }
    p.quad = int(std::int8_t(byte()));
    p.corner = byte() % 5;
    return p;
  }
  std::vector<Texture_place> places() {
    std::vector<Texture_place> all(byte() % 4);
    for (Texture_place& p : all) p = place();
    return all;
  }

private:
  const std::uint8_t* m_data;
  std::size_t m_size, m_at = 0;
};

inline Move_vertices move_of(Bytes& bytes) {
  Move_vertices move;
  move.vertices = bytes.places();
  move.dv = bytes.number() - 0.5;
  move.du = bytes.number() - 0.5;
  move.radius = bytes.number();
  move.aspect = bytes.number();
  move.falloff = Falloff(bytes.byte() % 3);
  move.rings = int(bytes.byte()) << (bytes.byte() % 24);
  move.steps = bytes.byte() % 8;
  move.anchors = bytes.places();
  return move;
}

inline Texture_edit edit_of(Bytes& bytes) {
  switch (bytes.byte() % 15) {
  case 0: return Subdivide_texture{};
  case 1: return Coarsen_texture{};
  case 2: return Insert_polychord{bytes.place(), bytes.number()};
  case 3: return Delete_polychord{bytes.place(), bytes.number()};
  case 4: return Inset_quads{bytes.places(), bytes.number()};
  case 5: return Open_quad{bytes.place(), bytes.place(), bytes.number()};
  case 6: return Close_quad{bytes.place(), bytes.number()};
  case 7: return Rotate_edge{bytes.place(), bytes.byte() % 2 == 0};
  case 8: return Rotate_vertex{bytes.place()};
  case 9: return Insert_doublet{bytes.place()};
  case 10: return Remove_doublet{bytes.place()};
  case 11: return Delete_quads{bytes.places()};
  case 12: return Restore_quads{bytes.places()};
  case 13: return move_of(bytes);
  default: return Relax_vertices{bytes.places(), bytes.byte() % 8, bytes.places()};
  }
}

inline int texture(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const int columns = 4 + bytes.byte() % 5, rows = 1 + bytes.byte() % 4;
  std::vector<double> levels;
  for (int r = 0; r <= rows; ++r) levels.push_back(double(r) / rows);
  Quad_texture now = bytes.byte() % 2 == 0 ? regular_annulus_texture(columns, levels)
                                           : regular_disc_texture(columns, rows + 1, false);
  for (int step = 0; step < 12 && !bytes.at_end(); ++step) {
    const Texture_edit edit = edit_of(bytes);
    if (std::holds_alternative<Subdivide_texture>(edit) && now.quads.size() > 500) continue;
    Result<Edited_texture> edited = edit_texture(now, edit);
    if (!edited) {
      promise(!edited.error().message.empty());
      continue;
    }
    std::vector<int> samples;
    for (const std::vector<int>& side : edited->texture.sides) samples.push_back(int(side.size()));
    promise(bool(check_texture(edited->texture, samples, false)));
    promise(bool(check_texture_plane(edited->texture)));
    now = std::move(edited->texture);
  }
  return 0;
}

} // namespace fuzz

#endif // FUZZ_TEXTURE_H
