// SPDX-License-Identifier: GPL-3.0-or-later
// What the examples of edits have in common: a session with two poles, and edits that tell what they change.
#ifndef REEB_QUADRANGULATION_EXAMPLES_EDIT_SESSION_H
#define REEB_QUADRANGULATION_EXAMPLES_EDIT_SESSION_H

#include <CGAL/Reeb_quadrangulation/Editor.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace edit_session {

namespace RQ = CGAL::Reeb_quadrangulation;

inline RQ::Surface_point at(double x, double y, double z) {
  return {RQ::Point(x, y, z), -1};
}

// Applies an edit and says what it changed; ends the program if it is refused.
inline void apply(RQ::Editor& editor, const RQ::Edit& edit) {
  const RQ::Result<RQ::Edit_report> done = editor.apply(edit);
  if (!done) {
    std::cerr << RQ::name(edit) << ": " << done.error().message << '\n';
    std::exit(1);
  }
  std::cout << RQ::name(edit) << ": " << done->new_charts.size() << " new charts, "
            << done->remeshed_charts.size() << " others with new quads;";
  for (const auto& [valence, number] : editor.quads().valences)
    std::cout << "  " << number << " of valence " << valence;
  std::cout << '\n';
}

// A session on a built-in shape, designed with one minimum and one maximum.
inline RQ::Editor begin(const std::string& shape, int triangles, const RQ::Surface_point& minimum,
                        const RQ::Surface_point& maximum) {
  RQ::Result<RQ::Editor> editor = RQ::Editor::create(*RQ::make_shape(shape, triangles));
  if (!editor) {
    std::cerr << editor.error().message << '\n';
    std::exit(1);
  }
  RQ::Set_extrema poles;
  poles.extrema.push_back({minimum, false, -1});
  poles.extrema.push_back({maximum, true, -1});
  apply(*editor, poles);
  return std::move(*editor);
}

} // namespace edit_session

#endif // REEB_QUADRANGULATION_EXAMPLES_EDIT_SESSION_H
