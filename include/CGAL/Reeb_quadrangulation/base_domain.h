// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_BASE_DOMAIN_H
#define CGAL_REEB_QUADRANGULATION_BASE_DOMAIN_H

/// \file
/// Connectivity textures on any quad mesh (figure 11 of the paper): its quads in rectangular patches,
/// textures of some patches edited with the operators of Texture_edit.h, and the mesh with these textures,
/// which is the same bits everywhere else.

#include <CGAL/Reeb_quadrangulation/Surface_projector.h>
#include <CGAL/Reeb_quadrangulation/Texture_edit.h>
#include <CGAL/Reeb_quadrangulation/relax_quads.h>

#include <map>
#include <memory>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// A rectangle of quads. Vertex (x, y), for x in [0, columns] and y in [0, rows], is entry y (columns + 1) +
/// x, quad (x, y) entry y columns + x; x and y grow counterclockwise about the normal. Opposite sides may be
/// the same edges of the mesh.
struct Base_patch {
  int columns = 0, rows = 0;
  std::vector<int> vertices, quads;
};

/// A quad mesh as patches.
struct Base_domain {
  std::vector<Base_patch> patches; ///< ordered by their smallest quad
  std::vector<int> patch_of_quad;
};

/// Where a mesh is cut into patches.
enum class Base_cut {
  separatrices, ///< the base complex: along the straight lines of edges from the extraordinary vertices
  everywhere    ///< every quad is a patch
};

/// Cuts an oriented manifold quad mesh, with or without boundary, into patches. Extraordinary are inner
/// vertices not of four quads and boundary vertices not of two. A part that the separatrices do not cut into
/// rectangles (a ring, a torus) is cut along the lines through its first quad too. Fails with
/// `not_a_surface`, naming the quad or the vertex. O(Q) for each such cut.
Result<Base_domain> base_domain(const Quad_mesh& mesh, Base_cut cut = Base_cut::separatrices);

/// The texture of a patch and where the vertices of its side lie: `steps[i]` edges of the patch from its
/// corner (0, 0) counterclockwise. The texture's domain is [0, columns] x [0, rows].
struct Patch_texture {
  Quad_texture texture;
  std::vector<double> steps;
};

/// The quads of the patch themselves.
Patch_texture patch_texture(const Base_patch& patch);

/// Applies an edit. The vertices that the patch shares with others stay; others may come to its side. Fails
/// as `edit_texture()`.
Result<Patch_texture> edit_texture(const Patch_texture& texture, const Texture_edit& edit);

/// Finds the places of textures by points in space.
class Base_locator {
public:
  /// The mesh and the domain are copied as far as they are needed.
  Base_locator(const Quad_mesh& mesh, const Base_domain& domain);

  struct Place {
    int patch = -1;
    double v = 0, u = 0; ///< in the patch's texture
  };
  /// The point of the quads, each cut along a diagonal, that is nearest. O(log Q).
  Place locate(const Point& point) const;

private:
  std::shared_ptr<const Triangle_surface> m_surface; ///< triangles 2 q and 2 q + 1 are quad q
  std::shared_ptr<const Surface_projector> m_projector;
  std::vector<int> m_patch;               ///< per quad
  std::vector<std::array<int, 2>> m_cell; ///< per quad: column and row
  std::vector<int> m_corner;              ///< per quad: which of its corners is the first of the cell
};

/// A mesh in which patches have other textures.
struct Textured_base {
  Quad_mesh mesh; ///< first the vertices and quads outside of the textured patches, in their order
  std::vector<int> vertex_origin; ///< per vertex: that of the base mesh whose place it has, bit by bit, or -1
  std::vector<int> patch_of_quad;
  int t_junctions = 0;            ///< vertices that came to sides of patches
  std::vector<int> extraordinary; ///< vertices that became so in taking T-junctions away
  Relax_report relaxation;
};

/// Puts textures in the place of the quads of their patches. A vertex goes to its point (V, U) in the patch's
/// quads, bilinearly, and from there to the nearest point of the surface whose normal is not turned away; a
/// vertex at a point of the patch's own grid stays where that is. Then the inner vertices that have moved or
/// are new are relaxed on the surface.
///
/// Neighbours stay as they are: where a texture has got vertices on its side, it is shrunk by half a quad,
/// and a ring of quads around it, still inside of the patch, leads from its side to the patch's
/// (`resolve_t_junctions()`).
///
/// Fails with `impossible_request` if a texture is not one of its patch (index, sides), with `refused_edit`
/// where holes leave a vertex whose quads are not one fan, and as `relax_quads()`. With
/// `relaxation.iterations` 0 and no untangling nothing is relaxed. \pre the projector's surface is connected
/// by `connect()`.
Result<Textured_base> apply_textures(const Quad_mesh& mesh, const Base_domain& domain,
                                     const std::map<int, Patch_texture>& textures,
                                     const Surface_projector& projector,
                                     const Relax_options& relaxation = {});

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_BASE_DOMAIN_H
