// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CERTIFICATE_TOPOLOGY_H
#define REEBQUAD_CERTIFICATE_TOPOLOGY_H

#include <CGAL/Reeb_quadrangulation/certificate.h>

#include <vector>

/// \file
/// The connectivity of any face-vertex arrays, derived for the certificate and the statistics alone.

namespace CGAL {
namespace Reeb_quadrangulation {
namespace certification {

/// How often something was found, and where first.
struct Finding {
  int count = 0;
  int element = -1; ///< a vertex, a face, or the smaller vertex of an edge
  int other = -1;   ///< the greater vertex of an edge, or the face's partner
  void note(int first_element, int second_element = -1) {
    if (count++ > 0) return;
    element = first_element;
    other = second_element;
  }
};

/// What `analyse()` finds. Faces that are not usable (`bad_indices`, `repeated_vertices`, `duplicates`) are
/// in no count.
struct Soup_topology {
  std::vector<char> usable;  ///< of each face
  Finding bad_indices;       ///< faces with an index out of range
  Finding repeated_vertices; ///< faces that name a vertex twice
  Finding duplicates;        ///< quads with the vertices of an earlier quad (`other`)
  Finding crowded_edges;     ///< edges of more than two faces
  Finding misdirected_edges; ///< edges that their two faces use in the same direction
  Finding several_fans;      ///< vertices whose faces are not one fan
  Finding unreferenced;      ///< vertices of no face
  int faces = 0;             ///< usable ones
  int edges = 0;
  std::vector<int> valence;      ///< edges at each vertex
  std::vector<char> on_boundary; ///< of each vertex: it has an edge of one face
  std::vector<int> component;    ///< of each vertex, by smallest vertex; -1 if unreferenced
  std::vector<Component_counts> components;
  int boundary_loops() const;
  int euler_characteristic() const;
};

/// Whether the faces at each vertex are told apart by fans (needed to find vertices of several fans, and to
/// count the boundary loops through them) or are known to be one fan.
enum class Fans { unknown, single };

/// Analyses faces over `number_of_vertices` vertices in O(V + F log d), d the greatest vertex degree.
/// Instantiated for `Triangle` and `Quad`; duplicates are looked for among quads only.
template <class Face>
Soup_topology analyse(const std::vector<Face>& faces, int number_of_vertices, Fans fans);

} // namespace certification
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_CERTIFICATE_TOPOLOGY_H
