// SPDX-License-Identifier: GPL-3.0-or-later
#include "components.h"

#include "automatic/components.h"

#include <CGAL/Reeb_quadrangulation/given_features.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace reebquad {
namespace python {

using namespace CGAL::Reeb_quadrangulation;

namespace {

/// Of points that are equal, the first one: mending makes one of them.
std::vector<int> first_equal_points(const std::vector<Point>& points) {
  const auto coordinates = [&](int p) {
    const Point& at = points[std::size_t(p)];
    return std::make_tuple(at.x(), at.y(), at.z());
  };
  std::vector<int> order(points.size()), first(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return coordinates(a) < coordinates(b); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool repeats = i > 0 && coordinates(order[i]) == coordinates(order[i - 1]);
    first[std::size_t(order[i])] = repeats ? first[std::size_t(order[i - 1])] : order[i];
  }
  return first;
}

using Edge = std::pair<int, int>;

Edge edge(int a, int b) {
  return {std::min(a, b), std::max(a, b)};
}

/// The user's features by the points that stand for them, and which of them were found.
struct Wanted_features {
  std::vector<int> first;                 ///< see `first_equal_points()`
  std::map<Edge, std::vector<int>> edges; ///< the rows that name it
  std::map<int, std::vector<int>> points;
  std::vector<char> edge_found, point_found;
};

Wanted_features wanted_features(const Request& request, const Polygon_soup& soup) {
  Wanted_features wanted;
  wanted.first = first_equal_points(soup.points);
  const auto first = [&](int p) { return wanted.first[std::size_t(p)]; };
  for (std::size_t i = 0; i < request.feature_edges.size(); ++i) {
    const auto [a, b] = request.feature_edges[i];
    wanted.edges[edge(first(a), first(b))].push_back(int(i));
  }
  for (std::size_t i = 0; i < request.feature_points.size(); ++i)
    wanted.points[first(request.feature_points[i])].push_back(int(i));
  wanted.edge_found.assign(request.feature_edges.size(), 0);
  wanted.point_found.assign(request.feature_points.size(), 0);
  return wanted;
}

void mark(const std::vector<int>& rows, std::vector<char>& found) {
  for (const int row : rows) found[std::size_t(row)] = 1;
}

/// Those of one component.
Given_features features_of(const Mended_component& component, Wanted_features& wanted) {
  const Triangle_surface& surface = component.surface;
  const auto point = [&](int v) {
    const int p = component.point_of_vertex[std::size_t(v)];
    return p < 0 ? -1 : wanted.first[std::size_t(p)];
  };
  std::vector<char> sharp(std::size_t(surface.number_of_halfedges()), 0);
  for (int h = 0; h < surface.number_of_halfedges(); ++h) {
    const auto found = wanted.edges.find(edge(point(surface.source(h)), point(surface.target(h))));
    if (found == wanted.edges.end()) continue;
    sharp[std::size_t(h)] = 1;
    mark(found->second, wanted.edge_found);
  }
  std::vector<int> points;
  for (int v = 0; v < surface.number_of_vertices(); ++v)
    if (const auto found = wanted.points.find(point(v)); found != wanted.points.end()) {
      points.push_back(v);
      mark(found->second, wanted.point_found);
    }
  return given_features(surface, std::move(sharp), std::move(points));
}

Result<void> all_found(const std::vector<char>& found, const char* sentence, Element_kind kind) {
  const auto missed = std::find(found.begin(), found.end(), 0);
  if (missed == found.end()) return {};
  const auto row = missed - found.begin();
  return make_error(Error_code::impossible_request, "row " + std::to_string(row) + sentence, kind, row);
}

} // namespace

std::vector<Quadrangulation_options> deal(const Quadrangulation_options& asked,
                                          const std::vector<Mended_component>& components) {
  std::vector<const Triangle_surface*> surfaces;
  for (const Mended_component& component : components) surfaces.push_back(&component.surface);
  return internal::options_of_components(asked, surfaces);
}

Result<void> deal_features(const Request& request, const Polygon_soup& soup,
                           const std::vector<Mended_component>& components,
                           std::vector<Quadrangulation_options>& options) {
  if (!request.has_features()) return {};
  Wanted_features wanted = wanted_features(request, soup);
  for (std::size_t c = 0; c < components.size(); ++c) {
    options[c].given_features = features_of(components[c], wanted);
    options[c].features.lines = true;
  }
  if (Result<void> found =
          all_found(wanted.edge_found, " of the features is no edge of the mesh", Element_kind::edge);
      !found)
    return found;
  return all_found(wanted.point_found, " of the features' points is no vertex of a face",
                   Element_kind::vertex);
}

std::vector<double> sizes_of(const std::vector<double>& sizes, const Polygon_soup& soup,
                             const Mended_component& component) {
  std::vector<double> result;
  for (std::size_t v = 0; v < component.surface.points.size(); ++v) {
    int point = component.point_of_vertex[v];
    if (point < 0) { // added by mending: as at the nearest point
      const Point& at = component.surface.points[v];
      const auto nearer = [&](const Point& a, const Point& b) {
        return (a - at).squaredNorm() < (b - at).squaredNorm();
      };
      point = int(std::min_element(soup.points.begin(), soup.points.end(), nearer) - soup.points.begin());
    }
    result.push_back(sizes[std::size_t(point)]);
  }
  return result;
}

} // namespace python
} // namespace reebquad
