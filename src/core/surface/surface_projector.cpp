// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/compatibility.h"
#include <CGAL/Reeb_quadrangulation/Surface_projector.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/assertions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <numeric>
#include <utility>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
constexpr int faces_per_packet = 8;

// A primitive of the tree: the bounding box of faces [8 id, 8 id + 8) of the Morton order.
class Packet {
public:
  using Id = int;
  using Point = Kernel::Point_3;
  using Datum = CGAL::Bbox_3;
  using Datum_reference = const Datum&;

  Packet(int id, const CGAL::Bbox_3& box) : m_box(box), m_id(id) {}
  Id id() const { return m_id; }
  Datum_reference datum() const { return m_box; }
  Point reference_point() const { return Point(m_box.xmin(), m_box.ymin(), m_box.zmin()); }

private:
  CGAL::Bbox_3 m_box;
  int m_id;
};

// Where on a triangle a closest point lies: on edge i from corner i, at corner i, or inside.
enum Region { on_edge = 0, at_corner = 3, inside = 6, not_better = 7 };

// The closest point of triangle (a, b, c) to p by the regions of Ericson, Real-Time Collision
// Detection, 5.1.5.
Point closest_on_triangle(const Point& p, const Point& a, const Point& b, const Point& c, int& region) {
  const Point ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  region = at_corner;
  if (d1 <= 0 && d2 <= 0) return a;
  const Point bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  region = at_corner + 1;
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  region = on_edge;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  const Point cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  region = at_corner + 2;
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  region = on_edge + 2;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  region = on_edge + 1;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  region = inside;
  const double sum = va + vb + vc;
  return a + vb / sum * ab + vc / sum * ac;
}

std::uint32_t spread_bits(std::uint32_t x) { // ten bits, two zeros after each
  x = (x | (x << 16)) & 0x030000ff;
  x = (x | (x << 8)) & 0x0300f00f;
  x = (x | (x << 4)) & 0x030c30c3;
  return (x | (x << 2)) & 0x09249249;
}

// The place of three points' centre on a Morton curve of 1024^3 cells over a box.
class Morton_curve {
public:
  explicit Morton_curve(const std::vector<Point>& points) {
    Point high = -m_low;
    for (const Point& p : points) {
      m_low = m_low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const double extent = (high - m_low).maxCoeff();
    m_scale = extent > 0 ? 1023 / (3 * extent) : 0;
  }
  std::uint32_t place(const Point& three_times_centre) const {
    const Point cell = ((three_times_centre - 3 * m_low) * m_scale).cwiseMax(0).cwiseMin(1023);
    return spread_bits(std::uint32_t(cell.x())) | spread_bits(std::uint32_t(cell.y())) << 1 |
           spread_bits(std::uint32_t(cell.z())) << 2;
  }

private:
  Point m_low = Point::Constant(std::numeric_limits<double>::max());
  double m_scale = 0;
};

// Faces, each with its place, along the curve, ties by index: three passes of a stable counting sort.
std::vector<std::pair<std::uint32_t, int>> morton_order(const Triangle_surface& s,
                                                        const Morton_curve& curve) {
  const int nf = s.number_of_faces();
  std::vector<std::pair<std::uint32_t, int>> keys(nf), sorted(nf);
  for (int f = 0; f < nf; ++f) {
    const Triangle& t = s.triangles[f];
    keys[f] = {curve.place(s.points[t[0]] + s.points[t[1]] + s.points[t[2]]), f};
  }
  for (int shift = 0; shift < 30; shift += 10) {
    std::vector<int> start(1025, 0);
    for (const auto& k : keys) ++start[(k.first >> shift & 1023) + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    for (const auto& k : keys) sorted[start[k.first >> shift & 1023]++] = k;
    keys.swap(sorted);
  }
  return keys;
}

double squared_distance(const Point& p, const CGAL::Bbox_3& b) {
  const double x = std::max({b.xmin() - p.x(), p.x() - b.xmax(), 0.0});
  const double y = std::max({b.ymin() - p.y(), p.y() - b.ymax(), 0.0});
  const double z = std::max({b.zmin() - p.z(), p.z() - b.zmax(), 0.0});
  return x * x + y * y + z * z;
}

// One query: what is sought, and the best answer so far.
struct Search {
  const Triangle_surface& surface;
  const std::vector<int>& order;
  Point query;
  const Point* normal = nullptr; // faces must agree with it, or all faces are eligible
  double min_cosine = 0;
  Closest_point best{Point::Zero(), -1, std::numeric_limits<double>::infinity()};

  bool eligible(const Point& a, const Point& b, const Point& c) const {
    if (!normal) return true;
    const Point n = (b - a).cross(c - a);
    const double length = n.norm();
    return length > 0 && n.dot(*normal) >= min_cosine * length;
  }

  // Returns the region of the closest point on the face, or `not_better` if the face cannot improve the
  // answer.
  int visit(int f) {
    const Triangle& t = surface.triangles[f];
    const Point &a = surface.points[t[0]], &b = surface.points[t[1]], &c = surface.points[t[2]];
    int region;
    const Point p = closest_on_triangle(query, a, b, c, region);
    const double d = (p - query).squaredNorm();
    if (d >= best.squared_distance || !eligible(a, b, c)) return not_better;
    best = {p, f, d};
    return region;
  }

  // Visits the faces around the source of halfedge `start` until one improves the answer.
  int visit_fan(int start) {
    int region = not_better, h = start;
    do {
      h = surface.rotate_ccw(h);
      if (h < 0) break;
      region = visit(h / 3);
    } while (h != start && region == not_better);
    for (h = start; region == not_better;) {
      h = surface.rotate_cw(h);
      if (h < 0 || h == start) break;
      region = visit(h / 3);
    }
    return region;
  }

  // Walks from face to face for as long as the distance falls.
  void walk(int f) {
    int region = visit(f);
    for (int step = 0; step < 256 && region < inside; ++step) {
      const int h = 3 * best.face + region % 3;
      if (region >= at_corner)
        region = visit_fan(h);
      else
        region = surface.opposite[h] >= 0 ? visit(surface.opposite[h] / 3) : int(not_better);
    }
  }

  void visit_packet(int packet) {
    const int first = faces_per_packet * packet;
    const int beyond = std::min(first + faces_per_packet, int(order.size()));
    for (int i = first; i < beyond; ++i) {
      const Triangle& t = surface.triangles[order[i]];
      const Point &a = surface.points[t[0]], &b = surface.points[t[1]], &c = surface.points[t[2]];
      const Point outside = (a.cwiseMin(b).cwiseMin(c) - query).cwiseMax(query - a.cwiseMax(b).cwiseMax(c));
      if (outside.cwiseMax(0.0).squaredNorm() < best.squared_distance) visit(order[i]);
    }
  }
};

// What the tree is asked: which boxes meet the open ball around the query through the best answer so far.
// Each packet that does may shrink the ball, and none of them ends the search.
struct Shrinking_ball {
  Search* search;
};

// CGAL's traits of an AABB tree, with the functors that this query and the order of the packets change.
struct Packet_traits : internal::Aabb_traits<Kernel, Packet> {
  struct Compute_bbox {
    template <class Iterator> CGAL::Bbox_3 operator()(Iterator first, Iterator beyond) const {
      CGAL::Bbox_3 box;
      for (; first != beyond; ++first) box += first->datum();
      return box;
    }
  };
  // Halves of a run of packets are runs: along the curve, half of a range lies together.
  struct Split_primitives {
    template <class Iterator> void operator()(Iterator, Iterator, const CGAL::Bbox_3&) const {}
  };
  struct Do_intersect {
    bool operator()(const Shrinking_ball& ball, const CGAL::Bbox_3& box) const {
      return squared_distance(ball.search->query, box) < ball.search->best.squared_distance;
    }
    bool operator()(const Shrinking_ball& ball, const Packet& packet) const {
      if ((*this)(ball, packet.datum())) ball.search->visit_packet(packet.id());
      return false;
    }
  };
  Compute_bbox compute_bbox_object() const { return {}; }
  Split_primitives split_primitives_object() const { return {}; }
  Do_intersect do_intersect_object() const { return {}; }
};

} // namespace

struct Surface_projector::Implementation {
  const Triangle_surface& surface;
  Point centre = Point::Zero();
  double reach = 0;
  std::once_flag built;
  Morton_curve curve;
  std::vector<int> order;
  std::vector<std::uint32_t> places; // of each packet's first face on the curve
  CGAL::AABB_tree<Packet_traits> tree;

  explicit Implementation(const Triangle_surface& s) : surface(s), curve(s.points) {
    Point low = Point::Constant(std::numeric_limits<double>::max()), high = -low;
    for (const Point& p : s.points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    centre = 0.5 * low + 0.5 * high;
    reach = 1e9 * (high - low).maxCoeff();
  }

  // Seen from very far away all of the surface lies in one direction: a point nearer in that direction has
  // the same answer up to rounding, and products of its distances do not overflow. What is no point at all
  // lies in the middle.
  Point pulled_in(const Point& query) const {
    const Point away = 0.5 * query - 0.5 * centre; // halves: a difference of two doubles may be infinite
    const double far = away.cwiseAbs().maxCoeff();
    if (2 * far <= reach) return query;
    if (!away.allFinite()) return centre;
    return centre + reach * (away / far);
  }

  void build() {
    std::vector<CGAL::Bbox_3> boxes;
    for (const auto& [place, face] : morton_order(surface, curve)) {
      if (order.size() % faces_per_packet == 0) {
        places.push_back(place);
        boxes.emplace_back();
      }
      order.push_back(face);
      for (int v : surface.triangles[face]) {
        const Point& p = surface.points[v];
        boxes.back() += CGAL::Bbox_3(p.x(), p.y(), p.z(), p.x(), p.y(), p.z());
      }
    }
    for (int i = 0; i < int(boxes.size()); ++i) tree.insert(Packet(i, boxes[i]));
    tree.build();
  }

  // Before the tree is asked, a ball about as large as the answer: the packets at the query's own place.
  void begin(Search& search) const {
    const auto after = std::upper_bound(places.begin(), places.end(), curve.place(3 * search.query));
    const int packet = std::max(0, int(after - places.begin()) - 1);
    search.visit_packet(packet);
    if (packet + 1 < int(places.size())) search.visit_packet(packet + 1);
  }

  Closest_point search(const Point& query, const Point* normal, double min_cosine, int hint_face,
                       double maximum_distance = std::numeric_limits<double>::infinity()) {
    std::call_once(built, [this] { build(); });
    Search search{surface, order, pulled_in(query), normal, min_cosine};
    search.best.squared_distance = maximum_distance * maximum_distance;
    if (hint_face >= 0)
      search.walk(hint_face);
    else
      begin(search);
    tree.do_intersect(Shrinking_ball{&search});
    // On a surface whose own squares overflow no distance is less than infinite: any face is as good as
    // another.
    if (search.best.face < 0 && !normal) search.best = {surface.points[surface.triangles[0][0]], 0, 0};
    return answer(search, query);
  }

  Closest_point nearby(const Point& query, int face) const {
    Search search{surface, order, pulled_in(query)};
    search.walk(face);
    if (search.best.face < 0) search.best = {surface.points[surface.triangles[face][0]], face, 0};
    return answer(search, query);
  }

  static Closest_point answer(const Search& search, const Point& query) {
    Closest_point best = search.best;
    if (search.query != query && best.face >= 0) best.squared_distance = (best.point - query).squaredNorm();
    return best;
  }
};

Surface_projector::Surface_projector(const Triangle_surface& surface)
    : m_implementation(std::make_unique<Implementation>(surface)) {
  CGAL_precondition(surface.number_of_faces() > 0);
}
Surface_projector::~Surface_projector() = default;
Surface_projector::Surface_projector(Surface_projector&&) noexcept = default;
Surface_projector& Surface_projector::operator=(Surface_projector&&) noexcept = default;

const Triangle_surface& Surface_projector::surface() const {
  return m_implementation->surface;
}

void Surface_projector::build() const {
  std::call_once(m_implementation->built, [this] { m_implementation->build(); });
}

Closest_point Surface_projector::closest(const Point& query) const {
  return closest(query, -1);
}

Closest_point Surface_projector::closest(const Point& query, int hint_face) const {
  return m_implementation->search(query, nullptr, 0, hint_face);
}

Closest_point Surface_projector::closest_nearby(const Point& query, int face) const {
  return m_implementation->nearby(query, face);
}

Closest_point Surface_projector::closest_compatible(const Point& query, const Point& normal,
                                                    double min_cosine, int hint_face,
                                                    double maximum_distance) const {
  return m_implementation->search(query, &normal, min_cosine, hint_face, maximum_distance);
}

Point Surface_projector::normal(int face) const {
  const Triangle& t = surface().triangles[face];
  const std::vector<Point>& p = surface().points;
  const Point n = (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]);
  const double length = n.norm();
  return length > 0 ? Point(n / length) : Point(Point::Zero());
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
