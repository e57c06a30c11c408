// SPDX-License-Identifier: GPL-3.0-or-later
#include "edits/steps.h"

#include <cmath>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

constexpr int most_steps = 100000; // of counts that a user may ask for

Error edited_texture(const Draft& draft, int c) {
  return refuse("the chart's texture has been edited", "reset it first", Element_kind::chart,
                draft.before().charts[draft.origin(c)]->id);
}

Result<Chart_settings*> unlocked_settings_at(Draft& draft, const Surface_point& at) {
  const Result<int> c = free_annulus_at(draft, at);
  if (!c) return c.error();
  return &draft.settings[draft.before().charts[draft.origin(*c)]->id];
}

} // namespace

Result<int> free_annulus_at(const Draft& draft, const Surface_point& at) {
  const int c = draft.chart_at(at);
  if (c < 0) return refuse("there is no chart");
  const Design_chart& chart = *draft.before().charts[draft.origin(c)];
  if (chart.chart->kind != Chart_kind::annulus)
    return refuse("a disc has no columns and rows of its own", {}, Element_kind::chart, chart.id);
  if (chart.settings.locked)
    return refuse("the edit would change a locked chart", {}, Element_kind::chart, chart.id);
  if (chart.edited) return edited_texture(draft, c);
  return c;
}

Result<void> apply_edit(Draft& draft, const Set_target& edit) {
  if ((edit.quads > 0) == (edit.edge_length > 0))
    return make_error(Error_code::impossible_request,
                      "either a number of quads or an edge length must be positive");
  if (!std::isfinite(edit.edge_length))
    return make_error(Error_code::impossible_request, "the edge length must be finite");
  draft.target_quads = edit.quads;
  if (edit.edge_length > 0) draft.edge_length = edit.edge_length;
  draft.resample = true;
  return {};
}

Result<void> apply_edit(Draft& draft, const Set_columns& edit) {
  Result<Chart_settings*> settings = unlocked_settings_at(draft, edit.at);
  if (!settings) return settings.error();
  if (edit.columns != 0 && (edit.columns < 4 || edit.columns % 2 != 0 || edit.columns > most_steps))
    return make_error(Error_code::impossible_request, "the number of columns is even and at least 4, or 0");
  if (edit.side != Chart_side::both) return set_columns_of_side(draft, edit);
  (*settings)->columns = edit.columns;
  return {};
}

Result<void> apply_edit(Draft& draft, const Set_rows& edit) {
  Result<Chart_settings*> settings = unlocked_settings_at(draft, edit.at);
  if (!settings) return settings.error();
  if (edit.rows != 0 && (edit.rows < 2 || edit.rows > most_steps))
    return make_error(Error_code::impossible_request, "the number of rows is at least 2, or 0");
  (*settings)->rows = edit.rows;
  return {};
}

Result<void> apply_edit(Draft& draft, const Set_shift& edit) {
  Result<Chart_settings*> settings = unlocked_settings_at(draft, edit.at);
  if (!settings) return settings.error();
  if (std::abs(edit.shift) > most_steps)
    return make_error(Error_code::impossible_request, "the shift is too large");
  (*settings)->shift = edit.shift;
  return {};
}

Result<void> apply_edit(Draft& draft, const Set_grading& edit) {
  Result<Chart_settings*> settings = unlocked_settings_at(draft, edit.at);
  if (!settings) return settings.error();
  if (!(edit.ratio >= 1e-3 && edit.ratio <= 1e3))
    return make_error(Error_code::impossible_request,
                      "the ratio of the rows' heights is between 0.001 and 1000");
  (*settings)->grading = edit.ratio;
  return {};
}

Result<void> apply_edit(Draft& draft, const Lock_chart& edit) {
  const int c = draft.chart_at(edit.at);
  if (c < 0) return refuse("there is no chart");
  draft.settings[draft.before().charts[draft.origin(c)]->id].locked = edit.locked;
  return {};
}

namespace {

Point sample_point(const Chart& chart, const std::vector<double>& x, int sample) {
  const std::vector<int>& walk = chart.walks[0].vertices;
  std::size_t i = 0;
  while (i + 1 < walk.size() && x[i + 1] <= sample) ++i;
  const Point &p = chart.mesh.points[walk[i]], &q = chart.mesh.points[walk[(i + 1) % walk.size()]];
  return p + (sample - x[i]) / (x[i + 1] - x[i]) * (q - p);
}

} // namespace

Result<void> apply_edit(Draft& draft, const Move_corner& edit) {
  const int c = draft.chart_at(edit.at);
  if (c < 0 || draft.chart(c).kind != Chart_kind::disc ||
      !rectangle_corners(draft.network, draft.chart(c)).empty())
    return refuse("there is no cap with corners to move");
  const Design_chart& old = *draft.before().charts[draft.origin(c)];
  if (old.settings.locked)
    return refuse("the edit would change a locked chart", {}, Element_kind::chart, old.id);
  if (old.edited) return edited_texture(draft, c);
  const Chart& chart = draft.chart(c);
  const std::vector<double> x = walk_coordinates(chart.walks[0], draft.before().samples);
  const int n = int(std::lround(x.back()));
  const bool clockwise = chart.walks[0].side == Side::high;
  const int first = clockwise ? old.grid[1] : old.grid[0], second = n / 2 - first;
  const int corner = ((-old.texture.offset[0]) % n + n) % n;
  const auto nearest = [&](const Point& p, const std::vector<int>& candidates) {
    int best = candidates[0];
    for (int s : candidates)
      if ((sample_point(chart, x, s) - p).squaredNorm() < (sample_point(chart, x, best) - p).squaredNorm())
        best = s;
    return best;
  };
  std::vector<int> all;
  for (int s = 0; s < n; ++s) all.push_back(s);
  const int from = nearest(edit.at.point, {corner, (corner + first) % n, (corner + first + second) % n,
                                           (corner + 2 * first + second) % n});
  const int to = nearest(edit.to.point, all);
  draft.settings[old.id].corner = ((corner + to - from) % n + n) % n;
  return {};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
