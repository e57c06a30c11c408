// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/base_domain.h>
#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include "tiny_quads.h"
#include "tiny_surfaces.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

using namespace CGAL::Reeb_quadrangulation;

namespace {

Triangle_surface surface_of(const Quad_mesh& mesh) {
  return tiny::connected(tiny::triangulated(mesh));
}

/// Each triangle as three quads: a quad mesh full of extraordinary vertices, such as nobody makes on purpose.
Quad_mesh three_quads_a_triangle(const Triangle_surface& s) {
  Quad_mesh mesh{s.points, {}};
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int v, int w) {
    const auto [place, added] = middles.insert({std::minmax(v, w), int(mesh.points.size())});
    if (added) mesh.points.push_back(0.5 * (s.points[v] + s.points[w]));
    return place->second;
  };
  for (const Triangle& t : s.triangles) {
    int m[3];
    for (int i = 0; i < 3; ++i) m[i] = middle(t[i], t[(i + 1) % 3]);
    const int centre = int(mesh.points.size());
    mesh.points.push_back((s.points[t[0]] + s.points[t[1]] + s.points[t[2]]) / 3);
    for (int i = 0; i < 3; ++i) mesh.quads.push_back({t[i], m[i], centre, m[(i + 2) % 3]});
  }
  return mesh;
}

std::vector<std::pair<std::string, Quad_mesh>> meshes() {
  std::vector<std::pair<std::string, Quad_mesh>> out;
  out.push_back({"cube", tiny::subdivided(tiny::subdivided(tiny::quad_cube()))});
  out.push_back({"coarsest cube", tiny::quad_cube()});
  out.push_back({"torus", tiny::quad_torus(9, 6)});
  out.push_back({"cylinder", tiny::quad_cylinder(6, 4)});
  out.push_back({"octahedron", three_quads_a_triangle(tiny::octahedron())});
  out.push_back({"sheet", three_quads_a_triangle(tiny::sheet({"####", "#..#", "####"}))});
  out.push_back({"two cubes", tiny::two_cubes()});
  return out;
}

/// All faults that have nothing to do with geometry, but as many boundary loops as before.
std::string faults(const Quad_mesh& mesh, const Triangle_surface& s) {
  Certificate_options options;
  options.measure_shape = options.find_self_intersections = false;
  std::string text;
  for (const Certificate_check& check : certify({mesh, &s}, options).checks)
    if (check.status == Check_status::failed && check.name != "no_inverted_quads" && check.name != "outward")
      text += check.name + ": " + check.message + "; ";
  return text;
}

bool same_bytes(const Point& a, const Point& b) {
  return std::memcmp(a.data(), b.data(), 3 * sizeof(double)) == 0;
}

/// Everything outside of the patches `edited` is as it was: the same quads of vertices with the same bytes,
/// in the same order.
void check_outside(const Quad_mesh& before, const Base_domain& domain, const Textured_base& after,
                   const std::set<int>& edited) {
  REQUIRE(after.vertex_origin.size() == after.mesh.points.size());
  REQUIRE(after.patch_of_quad.size() == after.mesh.quads.size());
  for (std::size_t v = 0; v < after.mesh.points.size(); ++v)
    if (after.vertex_origin[v] >= 0)
      if (!same_bytes(after.mesh.points[v], before.points[after.vertex_origin[v]]))
        FAIL("a vertex has moved");
  std::vector<Quad> wanted, found;
  for (std::size_t q = 0; q < before.quads.size(); ++q)
    if (edited.count(domain.patch_of_quad[q]) == 0) wanted.push_back(before.quads[q]);
  for (std::size_t q = 0; q < after.mesh.quads.size(); ++q) {
    if (edited.count(after.patch_of_quad[q]) > 0) continue;
    Quad quad = after.mesh.quads[q];
    for (int& v : quad) v = after.vertex_origin[v];
    found.push_back(quad);
  }
  CHECK(found == wanted);
}

} // namespace

TEST_CASE("the base complex of a cube is its sides, of a torus or a tube one patch") {
  const Quad_mesh cube = tiny::subdivided(tiny::subdivided(tiny::quad_cube()));
  const auto sides = base_domain(cube);
  REQUIRE(sides);
  REQUIRE(sides->patches.size() == 6);
  for (const Base_patch& p : sides->patches) CHECK((p.columns == 4 && p.rows == 4));
  const auto torus = base_domain(tiny::quad_torus(9, 6));
  REQUIRE(torus);
  REQUIRE(torus->patches.size() == 1);
  CHECK(torus->patches[0].columns * torus->patches[0].rows == 54);
  const auto tube = base_domain(tiny::quad_cylinder(6, 4));
  REQUIRE(tube);
  REQUIRE(tube->patches.size() == 1);
  CHECK(std::max(tube->patches[0].columns, tube->patches[0].rows) == 6);
}

TEST_CASE("patches are rectangles of the mesh's quads that cover it once") {
  for (const auto& [name, mesh] : meshes())
    for (const Base_cut cut : {Base_cut::separatrices, Base_cut::everywhere}) {
      INFO(name);
      const auto domain = base_domain(mesh, cut);
      REQUIRE(domain);
      std::vector<int> times(mesh.quads.size(), 0);
      for (std::size_t p = 0; p < domain->patches.size(); ++p) {
        const Base_patch& patch = domain->patches[p];
        REQUIRE(int(patch.quads.size()) == patch.columns * patch.rows);
        REQUIRE(int(patch.vertices.size()) == (patch.columns + 1) * (patch.rows + 1));
        if (cut == Base_cut::everywhere) CHECK(patch.quads.size() == 1);
        for (int y = 0; y < patch.rows; ++y)
          for (int x = 0; x < patch.columns; ++x) {
            const int q = patch.quads[y * patch.columns + x], a = y * (patch.columns + 1) + x,
                      b = a + patch.columns + 1;
            ++times[q];
            CHECK(domain->patch_of_quad[q] == int(p));
            const Quad cell{patch.vertices[a], patch.vertices[a + 1], patch.vertices[b + 1],
                            patch.vertices[b]};
            bool same = false; // up to the corner where it begins
            for (int i = 0; i < 4; ++i) {
              Quad turned = mesh.quads[q];
              std::rotate(turned.begin(), turned.begin() + i, turned.end());
              same = same || turned == cell;
            }
            CHECK(same);
          }
      }
      CHECK(std::count(times.begin(), times.end(), 1) == std::ptrdiff_t(times.size()));
    }
}

TEST_CASE("what is not an oriented manifold quad mesh is refused, naming the place") {
  const auto twisted = base_domain(tiny::quad_moebius(5));
  REQUIRE(!twisted);
  CHECK(twisted.error().code == Error_code::not_a_surface);
  CHECK(twisted.error().element == Element_kind::face);
  Quad_mesh touching = tiny::two_cubes(); // in one vertex
  for (Quad& q : touching.quads)
    for (int& v : q)
      if (v == 8) v = 7;
  const auto pinched = base_domain(touching);
  REQUIRE(!pinched);
  CHECK(pinched.error().element == Element_kind::vertex);
  CHECK(pinched.error().index == 7);
}

TEST_CASE("a texture that was not edited gives the quads that were") {
  for (const auto& [name, mesh] : meshes()) {
    INFO(name);
    const Triangle_surface s = surface_of(mesh);
    const Surface_projector projector(s);
    const auto domain = base_domain(mesh);
    REQUIRE(domain);
    const auto same = apply_textures(mesh, *domain, {{0, patch_texture(domain->patches[0])}}, projector);
    REQUIRE(same);
    CHECK(same->mesh.quads.size() == mesh.quads.size());
    CHECK(std::count(same->vertex_origin.begin(), same->vertex_origin.end(), -1) == 0);
    check_outside(mesh, *domain, *same, {0});
    CHECK(faults(same->mesh, s) == "");
  }
}

TEST_CASE("a patch that is subdivided alone leaves its neighbours' bits, and the mesh watertight") {
  for (const auto& [name, mesh] : meshes())
    for (const Base_cut cut : {Base_cut::separatrices, Base_cut::everywhere}) {
      INFO(name);
      const Triangle_surface s = surface_of(mesh);
      const Surface_projector projector(s);
      const auto domain = base_domain(mesh, cut);
      REQUIRE(domain);
      const int patch = int(domain->patches.size()) / 2;
      const auto fine = edit_texture(patch_texture(domain->patches[patch]), Subdivide_texture{});
      REQUIRE(fine);
      const auto result = apply_textures(mesh, *domain, {{patch, *fine}}, projector);
      REQUIRE(result);
      CHECK(faults(result->mesh, s) == "");
      check_outside(mesh, *domain, *result, {patch});
      const int around = 2 * (domain->patches[patch].columns + domain->patches[patch].rows);
      CHECK(result->t_junctions == around);
      CHECK(result->mesh.quads.size() >=
            mesh.quads.size() + 3 * domain->patches[patch].quads.size() + around);
      for (const Point& p : result->mesh.points)
        CHECK(projector.closest(p).squared_distance < 1e-20); // on the surface
    }
}

TEST_CASE("an inset changes nothing but its own vertices: the rest of the patch keeps its bits too") {
  const Quad_mesh cube = tiny::subdivided(tiny::subdivided(tiny::quad_cube()));
  const Triangle_surface s = surface_of(cube);
  const Surface_projector projector(s);
  const auto domain = base_domain(cube);
  REQUIRE(domain);
  const auto box = edit_texture(patch_texture(domain->patches[2]), Inset_quads{{{1.5, 1.5}, {2.5, 1.5}}});
  REQUIRE(box);
  const auto result = apply_textures(cube, *domain, {{2, *box}}, projector);
  REQUIRE(result);
  CHECK(result->t_junctions == 0);
  CHECK(result->mesh.quads.size() == cube.quads.size() + 6);
  CHECK(std::count(result->vertex_origin.begin(), result->vertex_origin.end(), -1) == 6);
  check_outside(cube, *domain, *result, {2});
  CHECK(faults(result->mesh, s) == "");
}

TEST_CASE("edits that would take a vertex from a neighbour are refused") {
  const auto domain = base_domain(tiny::subdivided(tiny::quad_cube()));
  REQUIRE(domain);
  const Patch_texture plain = patch_texture(domain->patches[0]);
  CHECK(!edit_texture(plain, Delete_polychord{{0.5, 0.01}}));
  CHECK(!edit_texture(plain, Coarsen_texture{}));
  // What an edit has added may go again.
  const auto more = edit_texture(plain, Insert_polychord{{0.5, 0.01}});
  REQUIRE(more);
  CHECK(more->steps.size() == plain.steps.size() + 2);
  const auto less = edit_texture(*more, Coarsen_texture{});
  CHECK(!less);
  const auto fine = edit_texture(plain, Subdivide_texture{});
  REQUIRE(fine);
  const auto coarse = edit_texture(*fine, Coarsen_texture{});
  REQUIRE(coarse);
  CHECK(coarse->steps == plain.steps);
}

TEST_CASE("textures that are not the patch's are impossible requests") {
  const Quad_mesh cube = tiny::subdivided(tiny::quad_cube());
  const Triangle_surface s = surface_of(cube);
  const Surface_projector projector(s);
  const auto domain = base_domain(cube);
  REQUIRE(domain);
  const auto code = [&](int patch, const Patch_texture& texture) {
    const auto result = apply_textures(cube, *domain, {{patch, texture}}, projector);
    return result ? Error_code::internal_error : result.error().code;
  };
  const Patch_texture good = patch_texture(domain->patches[0]);
  CHECK(code(6, good) == Error_code::impossible_request);
  Base_patch other;
  other.columns = 3;
  other.rows = 2;
  CHECK(code(0, patch_texture(other)) == Error_code::impossible_request);
  Patch_texture bad = good;
  bad.steps[1] = 1.5;
  CHECK(code(0, bad) == Error_code::impossible_request);
  bad = good;
  bad.texture.v[4] = 17;
  CHECK(code(0, bad) == Error_code::impossible_request);
}

TEST_CASE("a place is where its point lies") {
  for (const auto& [name, mesh] : meshes()) {
    INFO(name);
    const auto domain = base_domain(mesh);
    REQUIRE(domain);
    const Base_locator locator(mesh, *domain);
    for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
      const Quad& quad = mesh.quads[q];
      for (int i = 0; i < 4; ++i) {
        // Near corner i, within the diagonal's triangles.
        const Point centre = 0.5 * (mesh.points[quad[0]] + mesh.points[quad[2]]);
        const Point p = mesh.points[quad[i]] + 0.2 * (centre - mesh.points[quad[i]]);
        const Base_locator::Place place = locator.locate(p);
        const Base_patch& patch = domain->patches[place.patch];
        CHECK(domain->patch_of_quad[q] == place.patch);
        const int x = std::min(int(place.v), patch.columns - 1), y = std::min(int(place.u), patch.rows - 1);
        REQUIRE(patch.quads[y * patch.columns + x] == int(q));
        const int near =
            patch.vertices[int(std::lround(place.u)) * (patch.columns + 1) + int(std::lround(place.v))];
        CHECK(near == quad[i]);
      }
    }
  }
}

TEST_CASE("500 random edits of random patches: watertight, and the same bits outside") {
  tiny::Random random(31);
  int applied = 0;
  while (applied < 500)
    for (const auto& [name, mesh] : meshes()) {
      const Triangle_surface s = surface_of(mesh);
      const Surface_projector projector(s);
      const auto domain =
          base_domain(mesh, random.below(3) == 0 ? Base_cut::everywhere : Base_cut::separatrices);
      REQUIRE(domain);
      std::map<int, Patch_texture> textures;
      std::set<int> edited;
      for (int k = 0; k < 6; ++k) {
        const int patch = random.below(int(domain->patches.size()));
        Patch_texture& t = textures.try_emplace(patch, patch_texture(domain->patches[patch])).first->second;
        edited.insert(patch);
        const Texture_place at{0, 0, random.below(int(t.texture.quads.size())), random.below(4)};
        const Texture_edit edits[] = {Subdivide_texture{},      Insert_polychord{at, 0.3}, Inset_quads{{at}},
                                      Insert_doublet{at},       Rotate_edge{at},           Rotate_vertex{at},
                                      Close_quad{at},           Delete_polychord{at},      Coarsen_texture{},
                                      Relax_vertices{{}, 2, {}}};
        const int which = random.below(10);
        if (which == 0 && t.texture.quads.size() > 100) continue;
        const auto next = edit_texture(t, edits[which]);
        applied += bool(next);
        if (next) t = *next;
      }
      Relax_options quick;
      quick.iterations = 2;
      quick.untangle = false;
      const auto result = apply_textures(mesh, *domain, textures, projector, quick);
      INFO(name << ", " << applied);
      REQUIRE(result);
      CHECK(faults(result->mesh, s) == "");
      check_outside(mesh, *domain, *result, edited);
    }
}
