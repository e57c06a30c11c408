// SPDX-License-Identifier: GPL-3.0-or-later
#include "automatic/components.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

std::size_t nearest_component(const std::vector<const Triangle_surface*>& components, const Point& point) {
  std::size_t best = 0;
  double best_distance = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < components.size(); ++c)
    for (const Point& p : components[c]->points)
      if (const double distance = (p - point).squaredNorm(); distance < best_distance) {
        best = c;
        best_distance = distance;
      }
  return best;
}

} // namespace

std::vector<Quadrangulation_options>
options_of_components(const Quadrangulation_options& asked,
                      const std::vector<const Triangle_surface*>& components) {
  const std::size_t n = components.size();
  std::vector<Quadrangulation_options> options(n, asked);
  std::vector<double> areas;
  double total = 0;
  for (const Triangle_surface* surface : components) {
    areas.push_back(area(*surface));
    total += areas.back();
  }
  for (std::size_t c = 0; c < n; ++c) {
    options[c].extrema.clear();
    options[c].guides.clear();
    const double share = total > 0 ? areas[c] / total : 1.0 / double(n);
    if (n > 1) options[c].quads = std::max(1, int(std::lround(asked.quads * share)));
  }
  for (const Placed_extremum& extremum : asked.extrema)
    options[nearest_component(components, extremum.point)].extrema.push_back(extremum);
  for (const Guide& guide : asked.guides)
    options[guide.points.empty() ? 0 : nearest_component(components, guide.points.front())].guides.push_back(
        guide);
  return options;
}

Result<void> leave_component(Mended_surface& mended, int asked, const std::string& what) {
  const std::size_t number = mended.components.size();
  if (std::size_t(asked) > number)
    return make_error(Error_code::not_a_surface, "there is no component " + std::to_string(asked) + ", the " +
                                                     what + " has " + std::to_string(number));
  if (asked == 0) return {};
  Mended_component only = std::move(mended.components[std::size_t(asked - 1)]);
  mended.components.clear();
  mended.components.push_back(std::move(only));
  mended.refused.clear(); // nobody asked for them
  return {};
}

Component_observer::Component_observer(Observer& whole, std::size_t component, std::size_t components)
    : m_whole(whole) {
  if (components > 1)
    m_prefix = "component " + std::to_string(component + 1) + " of " + std::to_string(components) + ": ";
}

void Component_observer::progress(const std::string& stage, double fraction) {
  m_whole.progress(m_prefix + stage, fraction);
}

bool Component_observer::cancelled() const {
  return m_whole.cancelled();
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
