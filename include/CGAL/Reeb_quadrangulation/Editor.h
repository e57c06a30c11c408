// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_EDITOR_H
#define CGAL_REEB_QUADRANGULATION_EDITOR_H

#include <CGAL/Reeb_quadrangulation/Design.h>
#include <CGAL/Reeb_quadrangulation/Edit.h>
#include <CGAL/Reeb_quadrangulation/Editor_options.h>
#include <CGAL/Reeb_quadrangulation/Observer.h>
#include <CGAL/Reeb_quadrangulation/finish_design.h>
#include <CGAL/Reeb_quadrangulation/prepare_surface.h>
#include <CGAL/Reeb_quadrangulation/stitch.h>

#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// What an edit, an undo or a redo changed.
struct Edit_report {
  std::vector<int> new_charts, removed_charts; ///< identities; see `Design_chart::id`
  std::vector<int> remeshed_charts;            ///< kept charts with other counts or another texture
  std::vector<int> lost_textures; ///< removed charts whose edited texture no other chart took over
  std::vector<int> new_contours, removed_contours; ///< contour edges
  std::vector<int> changed_counts;                 ///< kept contour edges with another count
  int collapsed_charts = 0; ///< thin charts that the edit collapsed, see `Suggest::collapse_thin`
  /// The share of a moved contour's length that lies in its plane; on the rest other contours, extrema or its
  /// saddle's order hold it.
  double followed = 1;
  std::string remark; ///< what else the user should know, a sentence; usually empty
  double seconds = 0; ///< wall time
};

/// An editing session: a design and its history.
///
/// Every edit is checked before it is applied. A refused one returns `Error_code::refused_edit` (or
/// `impossible_request`, `infeasible_sampling`) with the reason and the element, and leaves everything as it
/// was. States are immutable values that share what they have in common: undo and redo exchange them and give
/// the same bytes again. The time of an edit is that of its charts, plus O(F) integer work for cutting the
/// surface.
class Editor {
public:
  /// Begins a session on a connected surface; the first design has no extrema, contours or charts until
  /// `Suggest` or `Set_extrema` gives it some. Fails like `quadrangulate()` if the surface is not one that
  /// the method takes.
  static Result<Editor> create(Triangle_surface surface, const Editor_options& options = {},
                               Observer* observer = nullptr);
  ~Editor();
  Editor(Editor&&) noexcept;
  Editor& operator=(Editor&&) noexcept;

  /// Applies an edit; redoable edits are forgotten.
  Result<Edit_report> apply(const Edit& edit, Observer* observer = nullptr);

  /// The design that an edit would lead to; nothing changes. Fails like `apply()` and takes as long; uses the
  /// session's solver, so call it from one thread at a time.
  Result<Design> preview(const Edit& edit, Observer* observer = nullptr) const;

  bool can_undo() const;
  bool can_redo() const;
  Edit_report undo(); ///< \pre `can_undo()`
  Edit_report redo(); ///< \pre `can_redo()`
  /// What was undone cannot be redone. \post not `can_redo()`
  void forget_undone();

  /// The edits that lead to the present design, then those that can be redone.
  const std::vector<Edit>& edits() const;
  /// How many of them are applied.
  int position() const;

  const Design& design() const;
  const Triangle_surface& input() const;           ///< as given
  const Triangle_surface& working_surface() const; ///< that the design lives on; closed if loops are filled
  const Editor_options& options() const;
  const Prepare_report& preparation() const; ///< how the working surface was made

  /// The chart of the design that contains a point, or -1.
  int chart_at(const Surface_point& point) const;

  /// The quad mesh of the design as it stands, positions on the surface, not relaxed. O(quads); a copy where
  /// the last edit had to stitch them already, to see that edited textures meet.
  Stitched_mesh quads() const;
  /// The same without the quads of fillings, where boundary loops are filled (`Editor_options::boundaries`):
  /// of each filling a disc of quads is left out, whose border comes to lie on the loop. Where it cannot run
  /// along the loop straight, a ring of quads lies between. Fails with `impossible_request` where a filling
  /// has no quad for itself, and with `refused_edit` with poles that are whole.
  Result<Stitched_mesh> open_quads() const;
  /// The same, finished on the input surface, by as many threads as the session has; see `finish_design()`.
  /// Refused if the design is empty.
  Result<Finished_design> finished_quads(const Finish_options& options = {},
                                         Observer* observer = nullptr) const;

private:
  struct Implementation;
  explicit Editor(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> m_implementation;
};

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_EDITOR_H
