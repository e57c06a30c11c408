// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/refusal.h"

namespace CGAL {
namespace Reeb_quadrangulation {

Error refuse(const std::string& reason, const std::string& details, Element_kind element, int index) {
  return make_error(Error_code::refused_edit, details.empty() ? reason : reason + ": " + details, element,
                    index);
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
