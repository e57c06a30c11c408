// SPDX-License-Identifier: GPL-3.0-or-later
// A design while an edit changes it.
#ifndef REEBQUAD_DESIGN_DRAFT_H
#define REEBQUAD_DESIGN_DRAFT_H

#include "base/refusal.h"
#include "surface/lazy_projector.h"

#include <CGAL/Reeb_quadrangulation/Design.h>
#include <CGAL/Reeb_quadrangulation/Editor_options.h>
#include <CGAL/Reeb_quadrangulation/Harmonic_field.h>
#include <CGAL/Reeb_quadrangulation/Observer.h>
#include <CGAL/Reeb_quadrangulation/Reeb_layout.h>
#include <CGAL/Reeb_quadrangulation/stitch.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// The harmonic fields of a whole surface. The order of elimination stays from edit to edit, and the
/// factorization if `Editor_options::keep_factorization` says so, which changes no bit of the results.
class Surface_solver {
public:
  /// Keeps references.
  Surface_solver(const Triangle_surface& surface, const Editor_options& options);
  /// Fills in a field as `solve_field()` does.
  Result<void> solve(Designed_field& field);
  /// The vertices in the order of elimination of the first field, and their places in it; empty before that.
  const std::vector<int>& order() const { return m_order; }
  const std::vector<int>& places() const { return m_places; }

private:
  Harmonic_field new_field() const;

  const Triangle_surface& m_surface;
  const Editor_options& m_options;
  std::optional<Harmonic_field> m_field;
  std::vector<int> m_order, m_places;
};

/// A point as it lies in a chart; chart -1 if it does not.
struct Chart_point {
  int chart = -1;
  Point point = Point::Zero();
  Chart_location location;
};

/// A copy of a design's contours and settings that an edit works on, cut into charts whenever it asks. Thrown
/// away if the edit is refused.
class Draft {
public:
  Draft(const Triangle_surface& surface, const internal::Lazy_projector& projector, Surface_solver& solver,
        const Design& design, const Editor_options& options, Observer* observer);

  const Triangle_surface& surface() const { return m_surface; }
  Surface_solver& solver() const { return m_solver; }
  const Editor_options& options() const { return m_options; }
  const Surface_projector& projector() const { return *m_projector; }
  Field_solver_options field_solver() const { return {m_options.solver, m_options.constraints}; }
  Observer* observer() const { return m_observer; }
  const Design& before() const { return m_before; }

  Contour_network network;
  std::vector<Design_extremum> extrema;
  std::map<int, Chart_settings> settings; ///< by identity, of the charts of the design before
  int target_quads = 0;
  double edge_length = 0;
  bool resample = false;        ///< choose all counts anew for the target, not near the old ones
  std::vector<int> counts;      ///< per contour edge, to be taken as they are; empty = chosen
  int most_dislocations = 0;    ///< that may be added where counts then come nearer to lengths
  double column_price = 8;      ///< of these, see `Sampling_options`
  std::set<int> reset_textures; ///< by identity: charts that get a regular texture again
  std::map<int, int> replaced;  ///< contour edges that took the place of edges of the design before
  std::shared_ptr<const Surface_field> field;   ///< that the contours were last traced from
  int collapsed_charts = 0;                     ///< thin charts that the edit has collapsed
  double followed = 1;                          ///< see `Edit_report::followed`
  std::vector<Design_guide> guides;             ///< of the design
  std::string remark;                           ///< see `Edit_report::remark`
  std::optional<Designed_field> given_field;    ///< of `Set_field`, on the surface of the draft
  const std::vector<double>* density = nullptr; ///< per vertex of the surface; null: everywhere 1
  bool has_pushed_contours =
      false; ///< so that charts may be too thin for numbers: then their maps are checked

  /// Cuts the surface along the network as it is now. Charts with the same contours around them stay. Fails
  /// with `refused_edit`.
  Result<void> cut();
  /// Becomes what another draft of the same design is.
  void take(Draft&& other);
  /// Takes over a layout of the whole surface: its charts have no settings, and their counts are chosen anew.
  void adopt(Reeb_layout layout);
  const Atlas& atlas() const { return m_atlas; }
  const Chart& chart(int c) const { return *m_atlas.charts[c]; }
  /// The index that a chart has in the design before, or -1.
  int origin(int c) const { return m_origin[c]; }
  /// The identity of a chart in the design before, by which refusals name it, or -1.
  int identity(int c) const { return m_origin[c] < 0 ? -1 : m_before.charts[std::size_t(m_origin[c])]->id; }

  /// The vertices of a chart as its systems eliminate them.
  std::vector<int> order_of(const Chart& chart) const { return elimination_order(chart, m_solver.places()); }
  /// Prepares the maps that charts do not have yet, several at once.
  Result<void> prepare_maps();
  /// Calls `work(c)` for charts, several at once, the largest first, so that two threads end together;
  /// returns the first error in the order of the list. Fails with `cancelled` where the observer asks for it.
  Result<void> for_each_chart(const std::vector<int>& charts,
                              const std::function<Result<void>(int)>& work) const;
  /// Tells the observer that a stage begins; fails with `cancelled` if it asks to stop.
  Result<void> begin(const char* stage) const;
  /// The map of a chart, prepared.
  Result<std::shared_ptr<const Chart_parameterization>> map(int c);
  /// The map of an annulus, solved for its natural V.
  Result<Chart_parameterization> naturally_solved_map(int c);
  /// How many times lengths count at the vertices of the network; empty: once.
  std::vector<double> network_density() const;
  bool has_map(int c) const { return bool(m_maps[c]); }

  /// \name Elements that points mean
  /// @{
  int vertex_at(const Surface_point& point) const;
  /// The same where a new extremum may be: without a hint, the nearest vertex that is not on the boundary.
  int inner_vertex_at(const Surface_point& point) const;
  int chart_at(const Surface_point& point) const;
  int face_at(const Point& point) const; ///< the nearest face of the surface
  /// The nearest point of the surface, in the chart that contains it, or in the one given.
  Chart_point chart_point_at(const Point& point, int chart = -1) const;
  int chart_of_vertex(int vertex) const;     ///< -1 on a contour
  int contour_at(const Point& point) const;  ///< a contour edge, or -1
  int extremum_at(const Point& point) const; ///< index into `extrema`, or -1
  int saddle_at(const Point& point) const;   ///< a node, or -1
  /// The number of the vertex of a contour edge that is nearest to a point.
  int vertex_of_contour_at(int edge, const Point& point) const;
  Point position(int network_vertex) const { return network.position(m_surface, network_vertex); }
  /// @}

  /// The contour edges at a node, with repetition for loops.
  std::vector<int> edges_at(int node) const;
  /// Whether an edge is a loop of its own, without saddles: a cap, a subdivision.
  bool is_free_loop(int edge) const;
  std::vector<int> extremal_vertices() const;

private:
  std::vector<double> chart_density(const Chart& chart) const;
  std::vector<int> changed_charts() const;
  void remember_contours();
  const Triangle_surface& m_surface;
  const internal::Lazy_projector& m_projector;
  Surface_solver& m_solver;
  const Design& m_before;
  const Editor_options& m_options;
  Observer* m_observer;
  Atlas m_atlas;
  std::vector<std::shared_ptr<const Chart_parameterization>> m_maps;
  std::vector<int> m_origin;
  std::vector<char> m_was_cut; // per contour edge: whether the atlas knows it
};

/// Whether quads of neighbouring charts may meet otherwise than those of regular textures.
bool has_irregular_texture(const Design& design);

/// The chart before whose contours chart `c` has, but for those that were replaced, and which has an edited
/// texture; or null.
const Design_chart* predecessor(const Draft& draft, int c);

/// Gives a new chart the texture of its predecessor, in the same places of the domain and of the contours.
/// `map` is prepared.
Result<void> inherit_texture(const Draft& draft, const Design_chart& old, const Contour_samples& samples,
                             Chart_parameterization map, Design_chart& made);

/// The quads of a design, on the surface. Fails as `stitch_textures()` does, only with edited textures. Quads
/// of locked charts are not split.
Result<Stitched_mesh> stitch_design(const Triangle_surface& surface,
                                    const internal::Lazy_projector& projector, const Design& design);

/// Whether a triangle of a chart is turned over in its map, by more than rounding.
bool folds(const Chart& chart, const Chart_parameterization& map);

/// An annulus that the draft has new and that cannot be mapped, or -1: very thin ones fold by rounding.
int unmappable_chart(Draft& draft);

/// Joins the saddles on both sides of every annulus that is lower than half a quad, the lowest first, as long
/// as charts result; counts in `Draft::collapsed_charts`. A quad is as large as the draft's target makes it
/// if its counts are to be chosen anew, else as before. Fails only as maps and counts do, or with
/// `cancelled`.
Result<void> collapse_thin_charts(Draft& draft);

/// Joins the saddles around an annulus on one contour. Fails with `refused_edit`.
Result<void> collapse_chart(Draft& draft, int chart);

/// Samples, maps and fills what the draft has new, and makes it a design. Fails like an edit.
Result<Design> complete_design(Draft& draft);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_DESIGN_DRAFT_H
