// SPDX-License-Identifier: GPL-3.0-or-later
// Functions on face graphs: quads along the borders of patches, the patches on them, the Reeb graph of any
// function.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Reeb_quadrangulation/face_graph.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>

namespace RQ = CGAL::Reeb_quadrangulation;
namespace params = CGAL::Reeb_quadrangulation::parameters;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int fail(const RQ::Error& error) {
  std::cerr << error.message << '\n';
  return 1;
}

int main() {
  const RQ::Result<RQ::Triangle_surface> hand = RQ::make_shape("hand", 6000);
  if (!hand) return fail(hand.error());
  Mesh mesh, quads;
  if (const auto added = RQ::to_face_graph(*hand, mesh); !added) return fail(added.error());

  // Two patches: what is above half of the height, and what is below.
  auto height = mesh.add_property_map<Mesh::Vertex_index, double>("v:height").first;
  double low = 1e300, high = -1e300;
  for (const Mesh::Vertex_index v : mesh.vertices()) {
    height[v] = mesh.point(v).z();
    low = std::min(low, height[v]);
    high = std::max(high, height[v]);
  }
  auto patch = mesh.add_property_map<Mesh::Face_index, std::string>("f:patch").first;
  for (const Mesh::Face_index f : mesh.faces())
    patch[f] = height[mesh.target(mesh.halfedge(f))] > 0.5 * (low + high) ? "upper" : "lower";

  const auto result = RQ::quadrangulate(mesh, quads, params::number_of_quads(2000).face_patch_map(patch));
  if (!result) return fail(result.error());
  auto carried = quads.add_property_map<Mesh::Face_index, std::string>("f:patch").first;
  if (const auto done = RQ::transfer_attribute(mesh, quads, patch, carried); !done) return fail(done.error());
  int upper = 0;
  for (const Mesh::Face_index f : quads.faces()) upper += carried[f] == "upper";
  std::cout << quads.number_of_faces() << " quads, " << upper << " of them in the upper patch; "
            << result->features.vertices << " vertices on the border\n";

  const auto graph = RQ::reeb_graph(mesh, height);
  if (!graph) return fail(graph.error());
  int clear = 0;
  for (const auto& node : graph->nodes) clear += node.persistence > 0.05 * (high - low);
  std::cout << "the height has " << graph->nodes.size() << " critical vertices, " << clear
            << " of them clear\n";

  const auto certificate = RQ::certify(quads, mesh);
  if (!certificate) return fail(certificate.error());
  std::cout << "certificate " << (certificate->passed ? "passed" : "failed") << '\n';
  return certificate->passed ? 0 : 1;
}
