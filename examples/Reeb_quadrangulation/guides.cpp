// SPDX-License-Identifier: GPL-3.0-or-later
// Quads follow strokes on the surface: a wave around the tube of a torus becomes a contour, and columns come
// onto a line along the tube. A weaker guide takes them a part of the way.
#include "edit_session.h"

#include <CGAL/Reeb_quadrangulation/followed_guide.h>

#include <cmath>

namespace RQ = CGAL::Reeb_quadrangulation;
using edit_session::apply;
using edit_session::at;

// A point of the torus: a around the axis, b around the tube.
RQ::Point on_torus(double a, double b) {
  return {(1 + 0.4 * std::cos(b)) * std::cos(a), (1 + 0.4 * std::cos(b)) * std::sin(a), 0.4 * std::sin(b)};
}

int main() {
  RQ::Editor editor = edit_session::begin("torus", 4000, at(-1.4, 0, 0), at(1.4, 0, 0));
  RQ::Guide around, along;
  around.closed = true;
  for (int i = 0; i < 40; ++i) {
    const double b = 2 * std::acos(-1.0) * i / 40;
    around.points.push_back(on_torus(1.6 + 0.1 * std::sin(b), b));
    along.points.push_back(on_torus(-2.3 + 0.04 * i, 0.01 * i));
  }
  along.strength = 0.5;
  apply(editor, RQ::Add_guide{around});
  apply(editor, RQ::Add_guide{along});

  const auto quads = [&]() {
    RQ::Result<RQ::Finished_design> finished = editor.finished_quads();
    if (!finished) std::exit(1);
    for (const RQ::Guide_outcome& guide : finished->guides)
      std::cout << "  guide: " << (guide.kept ? "kept" : guide.reason) << ", edges of quads on "
                << 100 * guide.after.on << " % of it, angle " << guide.before.angle << " -> "
                << guide.after.angle << " degrees\n";
    return std::move(*finished);
  };
  quads();
  RQ::Move_guide exact;
  exact.at = {along.points[20], -1};
  exact.strength = 1;
  apply(editor, exact);
  const RQ::Finished_design finished = quads();
  return finished.relaxation.inverted_after == 0 && finished.guides[0].kept ? 0 : 1;
}
