// SPDX-License-Identifier: GPL-3.0-or-later
// The stages alone, on a CGAL::Polyhedron_3 with exact coordinates: a field on its vertices, charts on its
// faces.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Reeb_quadrangulation/face_graph.h>
#include <CGAL/subdivision_method_3.h>

#include <iostream>
#include <map>

namespace RQ = CGAL::Reeb_quadrangulation;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Vertex = boost::graph_traits<Polyhedron>::vertex_descriptor;
using Face = boost::graph_traits<Polyhedron>::face_descriptor;

int main() {
  Polyhedron blob;
  blob.make_tetrahedron(Kernel::Point_3(4, 0, 0), Kernel::Point_3(0, 5, 0), Kernel::Point_3(0, 0, 6),
                        Kernel::Point_3(0, 0, 0));
  CGAL::Subdivision_method_3::Loop_subdivision(blob, CGAL::parameters::number_of_iterations(4));

  // The field has one minimum and two maxima, at vertices of the tetrahedron: hence one saddle.
  const auto corner = vertices(blob).begin();
  const std::vector<Vertex> minima{*corner}, maxima{*std::next(corner), *std::next(corner, 2)};
  const auto parameters = RQ::parameters::minima(minima).maxima(maxima);

  std::map<Vertex, double> field;
  std::map<Face, int> chart;
  const auto designed = RQ::reeb_field(blob, boost::make_assoc_property_map(field), parameters);
  const auto layout = RQ::reeb_charts(blob, boost::make_assoc_property_map(chart), parameters);
  if (!designed || !layout) {
    std::cerr << (designed ? layout.error() : designed.error()).message << '\n';
    return 1;
  }

  std::cout << field.size() << " vertices; the field is " << field[minima[0]] << " at the minimum and "
            << field[maxima[0]] << " at the maxima\n"
            << layout->critical.saddles.size() << " saddle, " << layout->atlas.charts.size() << " charts:";
  std::map<int, int> faces_of_chart;
  for (const auto& [face, c] : chart) ++faces_of_chart[c];
  for (const auto& [c, n] : faces_of_chart) std::cout << ' ' << n;
  std::cout << " faces\n";
  return layout->critical.saddles.size() == 1 ? 0 : 1;
}
