// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_BASE_PI_H
#define REEBQUAD_BASE_PI_H

namespace CGAL {
namespace Reeb_quadrangulation {

constexpr double pi = 3.14159265358979323846;

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // REEBQUAD_BASE_PI_H
