// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of meshes that have several components, each a run of its own.
#ifndef REEBQUAD_AUTOMATIC_COMPONENTS_H
#define REEBQUAD_AUTOMATIC_COMPONENTS_H

#include <CGAL/Reeb_quadrangulation/quadrangulate.h>
#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

/// The options of each component: quads by area, placed extrema to the component with the nearest vertex.
std::vector<Quadrangulation_options>
options_of_components(const Quadrangulation_options& asked,
                      const std::vector<const Triangle_surface*>& components);

/// Leaves only the component `asked`, counted from 1, and nothing of what was refused; with 0, all. Fails
/// with `not_a_surface` if there are not so many; `what` is the word for the whole: "file".
Result<void> leave_component(Mended_surface& mended, int asked, const std::string& what);

/// Names the component in the progress of its stages, where there are several.
class Component_observer : public Observer {
public:
  /// Counts from 0. Keeps a reference.
  Component_observer(Observer& whole, std::size_t component, std::size_t components);
  void progress(const std::string& stage, double fraction) override;
  bool cancelled() const override;

private:
  Observer& m_whole;
  std::string m_prefix;
};

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_AUTOMATIC_COMPONENTS_H
