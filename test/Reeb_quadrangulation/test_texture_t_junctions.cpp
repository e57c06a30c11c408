// SPDX-License-Identifier: GPL-3.0-or-later
#include "tiny_quads.h"
#include "tiny_textures.h"

#include <CGAL/Reeb_quadrangulation/merge_patches.h>

#include <algorithm>
#include <set>

using namespace tiny;
using Catch::Contains;

namespace {

struct Hanging_case {
  Quad_mesh mesh;
  std::vector<Hanging_edge> hanging;
};

/// A flat sheet: `rows` rows of coarse quads below the line y = 0, one row of fine quads above. Coarse column
/// i has `t[i]` T-junctions on the line.
Hanging_case sheet(const std::vector<int>& t, int rows) {
  Hanging_case c;
  const int n = int(t.size());
  for (int y = 0; y <= rows; ++y)
    for (int x = 0; x <= n; ++x) c.mesh.points.emplace_back(x, -y, 0);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < n; ++x) {
      const int above = y * (n + 1) + x, below = above + n + 1;
      c.mesh.quads.push_back({below, below + 1, above + 1, above});
    }
  std::vector<int> line;
  for (int x = 0; x < n; ++x) {
    line.push_back(x);
    Hanging_edge edge{x, 2, {}};
    for (int k = 1; k <= t[x]; ++k) {
      line.push_back(int(c.mesh.points.size()));
      edge.vertices.insert(edge.vertices.begin(), line.back());
      c.mesh.points.emplace_back(x + double(k) / (t[x] + 1), 0, 0);
    }
    if (t[x] > 0) c.hanging.push_back(edge);
  }
  line.push_back(n);
  const int above = int(c.mesh.points.size());
  for (int v : line) c.mesh.points.push_back(c.mesh.points[v] + Point(0, 1, 0));
  for (int i = 0; i + 1 < int(line.size()); ++i)
    c.mesh.quads.push_back({line[i], line[i + 1], above + i + 1, above + i});
  return c;
}

/// A torus of a coarse and a fine band: column i of the coarse one has `low[i]` and `high[i]` T-junctions on
/// its two ends; their sums are equal.
Hanging_case torus(const std::vector<int>& low, const std::vector<int>& high, int rows) {
  Hanging_case c;
  const int n = int(low.size());
  for (int y = 0; y <= rows; ++y)
    for (int x = 0; x < n; ++x) c.mesh.points.emplace_back(x, y, 0);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < n; ++x)
      c.mesh.quads.push_back({y * n + x, y * n + (x + 1) % n, (y + 1) * n + (x + 1) % n, (y + 1) * n + x});
  const auto ring = [&](const std::vector<int>& t, int y, int corner) {
    std::vector<int> line;
    for (int x = 0; x < n; ++x) {
      line.push_back(y * n + x);
      Hanging_edge edge{(corner == 0 ? 0 : rows - 1) * n + x, corner, {}};
      for (int k = 1; k <= t[x]; ++k) {
        line.push_back(int(c.mesh.points.size()));
        edge.vertices.push_back(line.back());
        c.mesh.points.emplace_back(x + double(k) / (t[x] + 1), y, 0);
      }
      if (corner == 2) std::reverse(edge.vertices.begin(), edge.vertices.end());
      if (t[x] > 0) c.hanging.push_back(edge);
    }
    return line;
  };
  const std::vector<int> first = ring(low, 0, 0), last = ring(high, rows, 2);
  REQUIRE(first.size() == last.size());
  const int m = int(first.size()), middle = int(c.mesh.points.size());
  for (int i = 0; i < m; ++i) c.mesh.points.emplace_back(i, rows + 1, 0);
  for (int i = 0; i < m; ++i) {
    const int j = (i + 1) % m;
    c.mesh.quads.push_back({last[i], last[j], middle + j, middle + i});
    c.mesh.quads.push_back({middle + i, middle + j, first[j], first[i]});
  }
  return c;
}

struct Edges {
  int boundary = 0, all = 0;
};

/// Counts the edges; fails if two quads pass one in the same direction.
Edges edges_of(const Quad_mesh& mesh) {
  std::set<std::pair<int, int>> directed;
  for (const Quad& q : mesh.quads)
    for (int i = 0; i < 4; ++i) CHECK(directed.insert({q[i], q[(i + 1) % 4]}).second);
  Edges out;
  for (const auto& [a, b] : directed) {
    const bool inner = directed.count({b, a}) > 0;
    out.boundary += !inner;
    out.all += !inner || a < b;
  }
  return out;
}

int euler(const Quad_mesh& mesh) {
  return int(mesh.points.size()) - edges_of(mesh).all + int(mesh.quads.size());
}

Resolved_mesh resolved(const Hanging_case& c, const T_junction_options& options = {}) {
  const Result<Resolved_mesh> result = resolve_t_junctions(c.mesh, c.hanging, options);
  if (!result) FAIL(result.error().message);
  CHECK(result->parent.size() == result->mesh.quads.size());
  for (std::size_t v = 0; v < c.mesh.points.size(); ++v) CHECK(result->mesh.points[v] == c.mesh.points[v]);
  return *result;
}

const T_junction_options inside_only{4, false, {}};

/// Whether every quad of a mesh in the plane is convex and counterclockwise.
bool is_convex(const Quad_mesh& mesh) {
  for (const Quad& q : mesh.quads)
    for (int i = 0; i < 4; ++i) {
      const Point &a = mesh.points[q[i]], &b = mesh.points[q[(i + 1) % 4]], &c = mesh.points[q[(i + 2) % 4]];
      if (!((b - a).cross(c - b).z() > -1e-12)) return false;
    }
  return true;
}

} // namespace

TEST_CASE("without T-junctions nothing changes") {
  const Quad_mesh mesh = quad_torus(4, 5);
  const Resolved_mesh out = resolved({mesh, {}});
  CHECK(out.mesh.quads == mesh.quads);
  CHECK(out.extraordinary.empty());
}

TEST_CASE("two T-junctions of neighbours give the 2:4 template: six quads, three new vertices, four "
          "extraordinary") {
  const Hanging_case c = sheet({0, 1, 1, 0}, 2);
  const Resolved_mesh out = resolved(c, inside_only);
  CHECK(out.mesh.quads.size() == c.mesh.quads.size() + 4);
  CHECK(out.mesh.points.size() == c.mesh.points.size() + 3);
  CHECK(out.lines == 1);
  CHECK(out.templates == 0);
  CHECK(out.boundary_vertices.empty());
  CHECK(out.extraordinary.size() == 4);
  CHECK(edges_of(out.mesh).boundary == edges_of(c.mesh).boundary - 4 - 2);
  CHECK(is_convex(out.mesh));
  std::vector<int> touched(c.mesh.quads.size(), 0);
  for (int f : out.parent) ++touched[f];
  CHECK(touched[1] == 3);
  CHECK(touched[2] == 3);
  CHECK(std::count(touched.begin(), touched.end(), 1) == std::ptrdiff_t(touched.size()) - 2);
}

TEST_CASE("two T-junctions of one edge give the 1:3 template: four quads, two new vertices") {
  const Hanging_case c = sheet({0, 2, 0}, 2);
  const Resolved_mesh out = resolved(c);
  CHECK(out.mesh.quads.size() == c.mesh.quads.size() + 3);
  CHECK(out.mesh.points.size() == c.mesh.points.size() + 2);
  CHECK(out.templates == 1);
  CHECK(out.extraordinary.size() == 4);
  CHECK(is_convex(out.mesh));
}

TEST_CASE("nested templates make no more extraordinary vertices than one") {
  for (int t : {2, 4, 6, 10}) {
    const Resolved_mesh out = resolved(sheet({0, t, 0}, 2));
    CHECK(out.templates == t / 2);
    CHECK(out.extraordinary.size() == 4);
    CHECK(is_convex(out.mesh));
  }
}

TEST_CASE("a T-junction across a strip from another makes no extraordinary vertex") {
  const Hanging_case c = torus({1, 0, 0, 0, 0}, {1, 0, 0, 0, 0}, 3);
  const Resolved_mesh out = resolved(c);
  CHECK(out.extraordinary.empty());
  CHECK(out.mesh.quads.size() == c.mesh.quads.size() + 3);
  CHECK(edges_of(out.mesh).boundary == 0);
  CHECK(euler(out.mesh) == 0);
}

TEST_CASE("a single T-junction ends on the boundary, or is refused") {
  const Hanging_case c = sheet({0, 1, 0}, 3);
  const Resolved_mesh out = resolved(c);
  CHECK(out.boundary_vertices.size() == 1);
  CHECK(out.extraordinary.empty());
  CHECK(is_convex(out.mesh));
  T_junction_options options;
  options.may_end_on_boundary = false;
  const auto refused = resolve_t_junctions(c.mesh, c.hanging, options);
  REQUIRE(!refused);
  CHECK_THAT(refused.error().message, Contains("for its line to end"));
  options.may_end_on_boundary = true;
  options.fixed.assign(c.mesh.quads.size(), 0);
  for (int f = 3; f < 9; ++f) options.fixed[f] = 1; // the rows below the first: out to the side
  const Resolved_mesh aside = resolved(c, options);
  CHECK(aside.boundary_vertices.size() == 1);
  CHECK(aside.extraordinary.size() == 2);
}

TEST_CASE("odd numbers send one line and nest the rest, beside where the line turns") {
  const Resolved_mesh out = resolved(sheet({0, 3, 1, 0}, 2), inside_only);
  CHECK(out.lines == 1);
  CHECK(out.templates == 1);
  CHECK(is_convex(out.mesh));
  const Resolved_mesh straight = resolved(sheet({0, 5, 0}, 1));
  CHECK(straight.lines == 1);
  CHECK(straight.boundary_vertices.size() == 1);
  CHECK(straight.templates == 2);
  CHECK(is_convex(straight.mesh));
}

TEST_CASE("a band refined on one side as a whole") {
  for (int n : {4, 6, 12}) {
    const std::vector<int> one(n, 1), none(n, 0);
    std::vector<int> all(n, 0);
    all[0] = n; // the other side meets its neighbour in one place only
    const Hanging_case c = torus(one, all, 4);
    const Resolved_mesh out = resolved(c);
    CHECK(edges_of(out.mesh).boundary == 0);
    CHECK(euler(out.mesh) == 0);
    CHECK(out.lines == n / 2);
    // Each pair has two vertices of three edges, and shares its corners of more edges with the next; the nest
    // has four.
    CHECK(int(out.extraordinary.size()) == 3 * n / 2 + 4);
  }
}

TEST_CASE("hanging edges that do not fit the mesh are refused") {
  Hanging_case c = sheet({0, 2, 0}, 2);
  const auto message = [&](const Hanging_edge& e) {
    const auto result = resolve_t_junctions(c.mesh, {e});
    return result ? std::string("resolved") : result.error().message;
  };
  CHECK(message(c.hanging[0]) == "resolved");
  CHECK_THAT(message({99, 0, {1}}), Contains("does not exist"));
  CHECK_THAT(message({1, 0, {1}}), Contains("on its other side"));
  Hanging_edge e = c.hanging[0];
  std::reverse(e.vertices.begin(), e.vertices.end());
  CHECK_THAT(message(e), Contains("no finer quads"));
  const auto twice = resolve_t_junctions(c.mesh, {c.hanging[0], c.hanging[0]});
  REQUIRE(!twice);
  CHECK_THAT(twice.error().message, Contains("twice"));
  c.mesh.quads.push_back(c.mesh.quads[0]);
  CHECK_THAT(message(c.hanging[0]), Contains("same direction"));
}

TEST_CASE("random T-junctions on bands: always watertight, all quads, of the same shape") {
  Random random(11);
  std::size_t extraordinary = 0, junctions = 0;
  for (int k = 0; k < 2000; ++k) {
    const int n = 3 + random.below(10), rows = 1 + random.below(4);
    std::vector<int> low(n, 0), high(n, 0);
    const int total = random.below(3 * n);
    for (int i = 0; i < total; ++i) {
      ++low[random.below(n)];
      ++high[random.below(n)];
    }
    const Hanging_case c = torus(low, high, rows);
    T_junction_options options;
    options.turn_cost = std::vector<double>{0, 1, 4, 1000}[random.below(4)];
    const Resolved_mesh out = resolved(c, options);
    const Edges edges = edges_of(out.mesh);
    REQUIRE(edges.boundary == 0);
    REQUIRE(int(out.mesh.points.size()) - edges.all + int(out.mesh.quads.size()) == 0);
    for (const Quad& q : out.mesh.quads) REQUIRE(std::set<int>(q.begin(), q.end()).size() == 4);
    std::vector<int> edges_at(out.mesh.points.size(), 0);
    for (const Quad& q : out.mesh.quads)
      for (int v : q) ++edges_at[v];
    for (const Quad& q : c.mesh.quads)
      for (int v : q) --edges_at[v];
    for (const Hanging_edge& e : c.hanging)
      for (int v : e.vertices) --edges_at[v]; // the coarse quad's straight angle is between two edges
    REQUIRE(edges_at == out.added_edges);
    extraordinary += out.extraordinary.size();
    junctions += 2 * std::size_t(total);
  }
  CHECK(double(extraordinary) < 2.0 * double(junctions));
}

namespace {

/// Adds a ring between two bands. `a` and `b` get the numbers of its vertices that each band has; they share
/// `shared` of them, and between two shared ones only one band has others.
std::vector<int> add_ring(Quad_mesh& mesh, Random& random, int shared, std::array<int, 2> extra, double y,
                          std::array<std::vector<int>, 2>& side) {
  std::vector<int> owner(shared), count(shared, 0);
  for (int i = 0; i < shared; ++i) owner[i] = i < 2 ? i : random.below(2);
  for (int s = 0; s < 2; ++s)
    for (int k = extra[s]; k > 0;)
      if (const int i = random.below(shared); owner[i] == s) {
        ++count[i];
        --k;
      }
  std::vector<int> ring;
  for (int i = 0; i < shared; ++i)
    for (int k = 0; k <= count[i]; ++k) {
      ring.push_back(int(mesh.points.size()));
      mesh.points.emplace_back(i + double(k) / (count[i] + 1), y, 0);
      for (int s = 0; s < 2; ++s)
        if (k == 0 || owner[i] == s) side[s].push_back(ring.back());
    }
  return ring;
}

/// A band of `rows` rows of quads up from one ring to another.
void add_band(Quad_mesh& mesh, const std::vector<int>& low, const std::vector<int>& high, int rows) {
  const int n = int(low.size());
  std::vector<int> below = low;
  for (int r = 1; r <= rows; ++r) {
    std::vector<int> above = high;
    for (int i = 0; i < n && r < rows; ++i) {
      above[i] = int(mesh.points.size());
      mesh.points.emplace_back(i, 10 * r, 0);
    }
    for (int i = 0; i < n; ++i)
      mesh.quads.push_back({below[i], below[(i + 1) % n], above[(i + 1) % n], above[i]});
    below = above;
  }
}

/// The hanging edges of a band along a ring.
void add_hanging(Hanging_case& c, const std::vector<int>& ring, const std::vector<int>& side) {
  for (std::size_t i = 0; i < side.size(); ++i) {
    const int a = side[i], b = side[(i + 1) % side.size()];
    std::vector<int> between;
    const std::size_t from = std::size_t(std::find(ring.begin(), ring.end(), a) - ring.begin());
    for (std::size_t k = from + 1; ring[k % ring.size()] != b; ++k) between.push_back(ring[k % ring.size()]);
    if (between.empty()) continue;
    for (int f = 0; f < int(c.mesh.quads.size()); ++f)
      for (int j = 0; j < 4; ++j) {
        const int from_vertex = c.mesh.quads[f][j], to = c.mesh.quads[f][(j + 1) % 4];
        if (from_vertex == b && to == a) std::reverse(between.begin(), between.end());
        if ((from_vertex == a && to == b) || (from_vertex == b && to == a))
          c.hanging.push_back({f, j, between});
      }
  }
}

} // namespace

TEST_CASE("bands that are finer than each other in different places: always watertight") {
  Random random(77);
  for (int k = 0; k < 1000; ++k) {
    Hanging_case c;
    const std::array<int, 2> columns{{4 + random.below(6), 4 + random.below(6)}};
    std::array<std::array<std::vector<int>, 2>, 2> sides; // per ring and band
    std::array<std::vector<int>, 2> rings;
    for (int r = 0; r < 2; ++r) {
      const int shared = 3 + random.below(std::min(columns[0], columns[1]) - 2);
      rings[r] = add_ring(c.mesh, random, shared, {{columns[0] - shared, columns[1] - shared}}, r, sides[r]);
    }
    add_band(c.mesh, sides[0][0], sides[1][0], 2 + random.below(3));
    add_band(c.mesh, sides[1][1], sides[0][1], 2 + random.below(3));
    for (int r = 0; r < 2; ++r)
      for (int s = 0; s < 2; ++s) add_hanging(c, rings[r], sides[r][s]);
    INFO("trial " << k);
    const Resolved_mesh out = resolved(c);
    const Edges edges = edges_of(out.mesh);
    REQUIRE(edges.boundary == 0);
    REQUIRE(int(out.mesh.points.size()) - edges.all + int(out.mesh.quads.size()) == 0);
  }
}

TEST_CASE("random T-junctions in a flat sheet: always convex quads") {
  Random random(5);
  for (int k = 0; k < 2000; ++k) {
    std::vector<int> t(2 + random.below(9), 0);
    for (int& x : t) x = std::max(0, random.below(8) - 4);
    const Hanging_case c = sheet(t, 1 + random.below(4));
    const Resolved_mesh out = resolved(c);
    REQUIRE(is_convex(out.mesh));
    REQUIRE(euler(out.mesh) == 1);
  }
}

namespace {

/// `n` x `rows` flat quads from x = `x` on, `width` wide and 1 high.
Quad_mesh patch(double x, double width, int n, int rows) {
  Quad_mesh mesh;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= n; ++i) mesh.points.emplace_back(x + width * i / n, double(j) / rows, 0);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + n + 1;
      mesh.quads.push_back({a, a + 1, b + 1, b});
    }
  return mesh;
}

} // namespace

TEST_CASE("patches made separately are merged, and what is left is resolved") {
  for (const auto& [left, right] :
       {std::pair(4, 4), std::pair(4, 8), std::pair(4, 7), std::pair(9, 5), std::pair(1, 6)}) {
    INFO(left << " rows beside " << right);
    const Quad_mesh both = together(patch(0, 1, 3, left), patch(1.001, 1, 3, right));
    const auto merged = merge_patches(both);
    REQUIRE(merged);
    CHECK(merged->greedy_merges >= 2);
    CHECK(merged->greedy_merges + merged->later_merges == std::min(left, right) + 1);
    std::size_t junctions = 0;
    for (const Hanging_edge& e : merged->hanging) junctions += e.vertices.size();
    CHECK(int(junctions) == std::abs(left - right));
    const Resolved_mesh out = resolved({merged->mesh, merged->hanging});
    CHECK(edges_of(out.mesh).boundary == 2 * 6 + left + right + int(out.boundary_vertices.size()));
    CHECK(euler(out.mesh) == 1);
    CHECK(is_convex(out.mesh));
  }
}

TEST_CASE("patches that are apart, or only touch, stay apart") {
  const auto apart = merge_patches(together(patch(0, 1, 3, 4), patch(1.5, 1, 3, 4)));
  REQUIRE(apart);
  CHECK(apart->greedy_merges == 0);
  CHECK(apart->hanging.empty());
  const auto one = merge_patches(patch(0, 1, 3, 4));
  REQUIRE(one);
  CHECK(one->mesh.quads == patch(0, 1, 3, 4).quads);
  CHECK(!merge_patches(patch(0, 1, 3, 4), 0.9));
  Quad_mesh bad = patch(0, 1, 3, 4);
  bad.quads.push_back(bad.quads[0]);
  CHECK(!merge_patches(bad));
}

TEST_CASE("a cylinder in two pieces closes") {
  for (const auto& [lower, upper] : {std::pair(8, 8), std::pair(8, 16), std::pair(8, 12), std::pair(6, 10)}) {
    Quad_mesh top = quad_cylinder(upper, 2);
    for (Point& p : top.points) p.z() += 2.01;
    const auto merged = merge_patches(together(quad_cylinder(lower, 2), top));
    REQUIRE(merged);
    const Resolved_mesh out = resolved({merged->mesh, merged->hanging}, inside_only);
    CHECK(edges_of(out.mesh).boundary == lower + upper);
    CHECK(euler(out.mesh) == 0);
  }
}
