// SPDX-License-Identifier: GPL-3.0-or-later
// The base complex of a design in integers: where separatrices go is told from counts, shifts and corners
// alone, without quads.
#ifndef REEBQUAD_DESIGN_LAYOUT_LINES_H
#define REEBQUAD_DESIGN_LAYOUT_LINES_H

#include <CGAL/Reeb_quadrangulation/Design.h>

#include <array>
#include <optional>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The integers of a design that are free.
struct Layout_integers {
  std::vector<int> counts; ///< per contour edge
  std::vector<int> turn; ///< per chart: columns by which an annulus's HIGH walk is turned east; the sample of
                         ///< a disc's first corner
};

/// The lines of edges of a design whose textures are all regular. A column of an annulus goes on straight to
/// the other side, a line of a cap to the opposite sample; contours are lines themselves. So the base complex
/// is the columns and lines that separatrices take.
class Layout_lines {
public:
  /// None if a texture is not regular, or if a node of several contours has valence 4: which of them are
  /// straight there?
  static std::optional<Layout_lines> of(const Design& design);

  const Layout_integers& integers() const { return m_now; }
  /// Other counts and turns. O(samples). \pre Counts are conserved, and the same as before around rectangles.
  void set(const Layout_integers& integers);
  /// Another turn of one chart. O(1)
  void set_turn(int chart, int turn) { m_now.turn[chart] = turn; }

  /// Samples around a walk of a chart.
  int samples(int chart) const { return int(m_charts[chart].ids[0].size()); }
  /// How far a disc's corner can turn until it lies where another was.
  int turns_of_disc(int chart) const;
  bool is_disc(int chart) const { return m_charts[chart].disc; }
  bool is_rectangle(int chart) const { return m_charts[chart].rectangle; }
  int number_of_charts() const { return int(m_charts.size()); }

  /// The number of patches of the base complex; a ring that no separatrix crosses counts as one. O(columns
  /// that separatrices take).
  int patches();

private:
  struct Part {
    int edge;
    bool forward;
  };
  struct Lines {
    bool disc = false, rectangle = false, clockwise = false, counted = true;
    std::array<int, 2> grid{{0, 0}};        // of a disc, by the steps of its walk: first, second
    std::array<std::vector<Part>, 2> walks; // of a disc only one
    std::array<std::vector<int>, 2> ids;    // per sample of the walk: its vertex
    std::vector<int> taken;                 // per column, or line of a disc: the last trace that took it
  };
  struct Port {
    int chart, walk, sample;
  };
  bool read(const Design& design);
  bool find_kinds(const Design& design);
  void merge_across_plain_contours(const Design& design);
  void number();
  std::array<int, 4> corners(const Lines& chart, int turn) const;
  bool is_corner(const Port& port) const;
  Port across(const Port& port) const;
  int line(const Port& port) const;
  void trace(Port port);

  Layout_integers m_now;
  std::vector<std::array<int, 2>> m_ends; // per contour edge: its nodes
  std::vector<Lines> m_charts;
  std::vector<int> m_first; // per contour edge: the vertex after its first node
  int m_nodes = 0;
  std::vector<char> m_on_boundary;        // per node
  std::vector<char> m_boundary_edge;      // per contour edge
  std::vector<std::vector<Port>> m_ports; // per vertex
  std::vector<int> m_quads;               // per vertex, without corners
  std::vector<int> m_corners;             // per vertex: how many lie there
  std::vector<char> m_boundary;           // per vertex
  int m_trace = 0;
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_DESIGN_LAYOUT_LINES_H
