// SPDX-License-Identifier: GPL-3.0-or-later
// Columns that end or begin inside of an annulus, and where they do best.
#include "design/dislocation_places.h"
#include "edits/steps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

constexpr double meeting_distance = 2; // in edges: dislocations that near take away from each other

// The entry nearest to a point among those whose columns have the sign, or any if that is 0; -1 if there is
// none nearer than `reach`.
int nearest(const std::vector<Design_dislocation>& list, const Point& p, int sign, double reach) {
  int best = -1;
  double least = reach * reach;
  for (int i = 0; i < int(list.size()); ++i) {
    if (list[i].columns * sign < 0) continue;
    if (const double d = (list[i].at - p).squaredNorm(); d <= least) {
      least = d;
      best = i;
    }
  }
  return best;
}

} // namespace

Result<void> apply_edit(Draft& draft, const Add_dislocation& edit) {
  if (!Dislocation::is_number(edit.columns))
    return make_error(Error_code::impossible_request,
                      "a dislocation has an even number of columns from -6 to 6, and not 0");
  const Result<int> c = free_annulus_at(draft, edit.at);
  if (!c) return c.error();
  const Chart_point place = draft.chart_point_at(edit.at.point, *c);
  const int id = draft.before().charts[draft.origin(*c)]->id;
  if (place.chart < 0) return refuse("the point lies on a contour", {}, Element_kind::chart, id);
  std::vector<Design_dislocation>& list = draft.settings[id].dislocations;
  const int met = nearest(list, place.point, -edit.columns, meeting_distance * draft.edge_length);
  if (met < 0) {
    list.push_back({place.point, edit.columns});
    return {};
  }
  const int left = list[met].columns + edit.columns;
  if (left * edit.columns > 0) list[met].at = place.point;
  list[met].columns = left;
  if (left == 0) list.erase(list.begin() + met);
  return {};
}

Result<void> apply_edit(Draft& draft, const Remove_dislocation& edit) {
  const Result<int> c = free_annulus_at(draft, edit.at);
  if (!c) return c.error();
  const int id = draft.before().charts[draft.origin(*c)]->id;
  std::vector<Design_dislocation>& list = draft.settings[id].dislocations;
  const int found = nearest(list, edit.at.point, 0, std::numeric_limits<double>::infinity());
  if (found < 0) return refuse("the chart has no dislocations", {}, Element_kind::chart, id);
  list.erase(list.begin() + found);
  return {};
}

Result<void> apply_edit(Draft& draft, const Balance_columns& edit) {
  if (edit.most < 1 || edit.most > 10000 || !(edit.price > 0) || !std::isfinite(edit.price))
    return make_error(Error_code::impossible_request,
                      "1 to 10,000 dislocations are placed, and a column has a positive price");
  draft.most_dislocations = edit.most;
  draft.column_price = edit.price;
  draft.resample = true;
  return {};
}

Result<void> set_columns_of_side(Draft& draft, const Set_columns& edit) {
  const Result<int> c = free_annulus_at(draft, edit.at);
  if (!c) return c.error();
  const Design_chart& chart = *draft.before().charts[draft.origin(*c)];
  Chart_settings& settings = draft.settings[chart.id];
  const int low = chart.grid[0], high = low + settings.columns_gained();
  settings.dislocations.clear();
  settings.columns = 0;
  if (edit.columns == 0) return {};
  settings.columns = edit.side == Chart_side::low ? edit.columns : low;
  const int gained = edit.side == Chart_side::low ? high - edit.columns : edit.columns - low;
  if (std::abs(gained) > 4 * std::max(low, high))
    return make_error(Error_code::impossible_request,
                      "the columns of a side are at most five times those of the other");
  Dislocation_places places(chart, {{settings.columns, chart.grid[1]}}, draft.before().edge_length);
  places.choose_rows(gained);
  settings.dislocations = places.place();
  return {};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
