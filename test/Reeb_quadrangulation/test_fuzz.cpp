// SPDX-License-Identifier: GPL-3.0-or-later
// Random meshes, random extrema, random fields: whatever is asked, the quads are certified and the maps do
// not fold.
#include "layout_stages.h"

#include <CGAL/Reeb_quadrangulation/prepare_surface.h>

#include <algorithm>
#include <set>

using namespace CGAL::Reeb_quadrangulation;
using tiny::Random;

namespace {

bool joined(const Triangle_surface& s, int a, int b) {
  for (int h = 0; h < s.number_of_halfedges(); ++h)
    if ((s.source(h) == a && s.target(h) == b) || (s.source(h) == b && s.target(h) == a)) return true;
  return false;
}

// Flips random edges where that leaves a simplicial surface; folds in space do not matter here.
Triangle_surface flipped(Triangle_surface s, int flips, Random& random) {
  for (int i = 0; i < flips; ++i) {
    const int h = random.below(s.number_of_halfedges()), g = s.opposite[h];
    if (g < 0) continue;
    const int a = s.source(h), b = s.target(h), c = s.source(Triangle_surface::previous(h)),
              d = s.source(Triangle_surface::previous(g));
    if (c == d || joined(s, c, d)) continue;
    s.triangles[h / 3] = {c, d, b};
    s.triangles[g / 3] = {d, c, a};
    s = tiny::connected({s.points, s.triangles, {}, {}});
  }
  return s;
}

// Puts a vertex into random faces.
Triangle_surface with_stars(Triangle_surface s, int stars, Random& random) {
  for (int i = 0; i < stars; ++i) {
    const int f = random.below(s.number_of_faces()), v = s.number_of_vertices();
    const Triangle t = s.triangles[f];
    s.points.push_back((s.points[t[0]] + s.points[t[1]] + s.points[t[2]]) / 3);
    s.triangles[f] = {t[0], t[1], v};
    s.triangles.push_back({t[1], t[2], v});
    s.triangles.push_back({t[2], t[0], v});
  }
  return tiny::connected({s.points, s.triangles, {}, {}});
}

Triangle_surface without_unused_points(const Triangle_surface& s) {
  std::vector<int> index(s.points.size(), -1);
  Triangle_surface result;
  for (Triangle t : s.triangles) {
    for (int& v : t) {
      if (index[v] < 0) {
        index[v] = int(result.points.size());
        result.points.push_back(s.points[v]);
      }
      v = index[v];
    }
    result.triangles.push_back(t);
  }
  return result;
}

// Removes a face, or all faces at a vertex, if a connected surface is left.
Triangle_surface punctured(const Triangle_surface& s, Random& random) {
  Triangle_surface open{s.points, {}, {}, {}};
  if (random.below(2) == 0) {
    open.triangles = s.triangles;
    open.triangles.erase(open.triangles.begin() + random.below(s.number_of_faces()));
  } else {
    const int v = random.below(s.number_of_vertices());
    for (const Triangle& t : s.triangles)
      if (std::find(t.begin(), t.end(), v) == t.end()) open.triangles.push_back(t);
  }
  open = without_unused_points(open);
  if (open.triangles.empty() || !open.connect() || connected_components(open).second != 1) return s;
  return open;
}

Triangle_surface base_surface(int kind) {
  switch (kind) {
  case 0: return tiny::tetrahedron();
  case 1: return tiny::octahedron();
  case 2: return tiny::cube();
  case 3: return tiny::torus(3, 3);
  case 4: return tiny::torus(4, 5);
  case 5: return tiny::torus(8, 7);
  case 6: return tiny::torus(3, 3, 0.4, 1);
  case 7: return tiny::double_torus(3, 3);
  case 8: return tiny::double_torus(5, 4);
  case 9: return tiny::boxes({"#####", "#.#.#", "#####"});
  case 10: return tiny::bipyramid(7);
  default: return tiny::boxes({"###", "#.#", "###", "#.#", "###", "#.#", "###"});
  }
}

struct Trial {
  Triangle_surface surface;
  Designed_field field;
  bool is_harmonic = false;
};

Triangle_surface random_surface(Random& random, bool open) {
  Triangle_surface s = base_surface(random.below(12));
  if (random.below(3) == 0 && s.number_of_faces() < 200) s = tiny::subdivided(s);
  s = with_stars(std::move(s), random.below(6), random);
  s = flipped(std::move(s), random.below(12), random);
  for (Point& p : s.points) p += 0.05 * Point(random.unit(), random.unit(), random.unit());
  if (!open) return s;
  for (int i = 1 + random.below(3); i > 0; --i) s = punctured(s, random);
  Prepare_options options;
  options.flip = false;
  Result<Prepared_surface> prepared = prepare_surface(std::move(s), options);
  REQUIRE(bool(prepared));
  return std::move(prepared->surface);
}

// Up to eight distinct interior vertices, often neighbours, with labels so that there is a minimum and a
// maximum.
void choose_extrema(const Triangle_surface& s, Random& random, Designed_field& field) {
  std::vector<char> on_boundary(s.points.size(), 0);
  const auto loops = boundary_loops(s);
  for (const auto& loop : loops)
    for (int h : loop) on_boundary[s.source(h)] = 1;
  for (std::size_t i = 0; i < loops.size(); ++i) field.boundary_is_maximum.push_back(random.below(2) == 1);
  std::set<int> chosen;
  for (int i = 2 + random.below(7); i > 0; --i) {
    int v = random.below(s.number_of_vertices());
    if (!chosen.empty() && random.below(2) == 0) v = s.target(s.outgoing[*chosen.begin()]);
    if (!on_boundary[v]) chosen.insert(v);
  }
  for (int v : chosen) (random.below(2) == 0 ? field.minima : field.maxima).push_back(v);
  const bool has_minimum = !field.minima.empty() || std::count(field.boundary_is_maximum.begin(),
                                                               field.boundary_is_maximum.end(), false) > 0;
  const bool has_maximum = !field.maxima.empty() || std::count(field.boundary_is_maximum.begin(),
                                                               field.boundary_is_maximum.end(), true) > 0;
  if (has_minimum && has_maximum) return;
  std::vector<int>& lacking = has_minimum ? field.maxima : field.minima;
  std::vector<int>& other = has_minimum ? field.minima : field.maxima;
  if (other.size() > 1 || (other.size() == 1 && !loops.empty())) {
    lacking.push_back(other.back());
    other.pop_back();
    return;
  }
  if (!loops.empty()) {
    if (loops.size() > 1) {
      field.boundary_is_maximum[0] = !has_maximum;
      return;
    }
  }
  for (int v = 0; v < s.number_of_vertices(); ++v)
    if (!on_boundary[v] && (other.empty() || other[0] != v)) {
      lacking.push_back(v);
      return;
    }
}

Trial make_trial(std::uint64_t seed, bool open) {
  Random random(seed);
  Trial trial;
  trial.surface = random_surface(random, open);
  choose_extrema(trial.surface, random, trial.field);
  Designed_field& field = trial.field;
  const int style = random.below(4);
  trial.is_harmonic = style < 2;
  if (style < 3) {
    field = stages::harmonic(trial.surface, field.minima, field.maxima,
                             style == 2 ? Weight_kind::cotangent : Weight_kind::clamped_cotangent,
                             field.boundary_is_maximum);
  } else {
    for (int v = 0; v < trial.surface.number_of_vertices(); ++v) field.values.push_back(random.unit());
  }
  return trial;
}

// What fails, or nothing.
std::string failure(const Trial& trial, int quads) {
  const Result<stages::Stages> run = stages::run(trial.surface, trial.field, quads);
  if (!run) return run.error().message;
  const Reeb_layout& layout = run->layout;
  std::string text = stages::faults(run->stitched.mesh, trial.surface, run->stitched.valences);
  for (const auto& chart : layout.atlas.charts)
    if (const int chords = stages::chords(*chart); chords > 0) text += std::to_string(chords) + " chords; ";
  // Where a rough field's contour encloses a long inlet, U is 0 or 1 there up to rounding.
  const int turned = trial.is_harmonic ? run->flipped : run->folds;
  if (turned > 0) text += std::to_string(turned) + " flipped triangles; ";
  const bool simple = std::all_of(layout.critical.multiplicity.begin(), layout.critical.multiplicity.end(),
                                  [](int k) { return k == 1; });
  const int genus = stages::genus(trial.surface), loops = layout.graph.loops();
  if (loops > genus || (simple && loops != genus))
    text += "loops " + std::to_string(loops) + " of " + std::to_string(genus) + "; ";
  return text;
}

void fuzz(int runs, bool open) {
  for (int seed = 1; seed <= runs; ++seed) {
    const Trial trial = make_trial(std::uint64_t(seed) + (open ? 1000000 : 0), open);
    const std::string text = failure(trial, 100 + seed % 7 * 60);
    INFO("seed " << seed << ": " << text << trial.surface.number_of_faces() << " faces");
    CHECK(text.empty());
  }
}

} // namespace

TEST_CASE("closed surfaces: any extrema, any field, certified quads and no flipped triangle") {
  fuzz(600, false);
}

TEST_CASE("open surfaces: any extrema, any labels of the boundary loops, certified quads") {
  fuzz(400, true);
}
