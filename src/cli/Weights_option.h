// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_CLI_WEIGHTS_OPTION_H
#define REEBQUAD_CLI_WEIGHTS_OPTION_H

#include <CGAL/Reeb_quadrangulation/design_energy.h>

#include <string>

namespace reebquad {

/// The names of the weights of a design's energy, each with its default.
std::string names_of_weights();

/// The weights of "angle=1,size=0.01"; the others keep their defaults. A `Usage_error` says what is wrong.
CGAL::Reeb_quadrangulation::Energy_weights energy_weights(const std::string& text);

} // namespace reebquad

#endif // REEBQUAD_CLI_WEIGHTS_OPTION_H
