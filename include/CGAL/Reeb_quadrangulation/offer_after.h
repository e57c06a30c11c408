// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_OFFER_AFTER_H
#define CGAL_REEB_QUADRANGULATION_OFFER_AFTER_H

#include <CGAL/Reeb_quadrangulation/Editor.h>

#include <optional>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

/// An edit in place of one that was refused. It has been tried: the editor that was asked applies it.
struct Offer {
  Edit edit;
  std::string words;           ///< what it does instead, for a button: "Tilt by 12 degrees instead"
  Point place = Point::Zero(); ///< where it is done, on the surface or near it
};

/// The nearest thing that works after an edit was refused: less of the same (a smaller tilt, a part of the
/// way, a place beside it, another number), then the same in another way (on the whole surface, by the field,
/// in the other kind of parts), then what has to come first (a chart is unlocked). Nothing if none of these
/// works, if the failure is no refusal of the edit, or if the design has no charts.
///
/// Depends on the design, the edit and the refusal alone. Costs at most 16 previews, one after the other
/// until the first that works: to be asked for after a refusal, which stays quick so. Fails with `cancelled`
/// only.
Result<std::optional<Offer>> offer_after(const Editor& editor, const Edit& edit, const Error& refusal,
                                         Observer* observer = nullptr);

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_OFFER_AFTER_H
