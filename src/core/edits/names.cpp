// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Edit.h>

namespace CGAL {
namespace Reeb_quadrangulation {

const char* name(const Edit& edit) {
  return std::visit([](const auto& e) { return e.edit_name; }, edit);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
