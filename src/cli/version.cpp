// SPDX-License-Identifier: GPL-3.0-or-later
#include "Command.h"

#include "view/Assets.h"

#include <CGAL/Reeb_quadrangulation/Field_solver_options.h>
#include <CGAL/Reeb_quadrangulation/render.h>
#include <CGAL/version.h>
#include <Eigen/Core>

#include <iostream>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;

Exit_code execute_version(const Arguments& arguments) {
  Command_line line("version");
  if (!line.parse(arguments)) return Exit_code::success;
  std::cout << "reebquad " REEBQUAD_VERSION " (CGAL " CGAL_VERSION_STR ", Eigen " << EIGEN_WORLD_VERSION
            << '.' << EIGEN_MAJOR_VERSION << '.' << EIGEN_MINOR_VERSION << ")\n";
  std::cout << (can_write_png() ? "pictures: by libpng\n" : "pictures: none (libpng was not there)\n");
  std::cout << "solvers: "
            << (linear_solver_named("cholmod") ? "multifrontal, cholmod, eigen\n" : "multifrontal, eigen\n");
  if (studio::assets().empty())
    std::cout << "studio: without its page (" << studio::missing_page_reason() << ")\n";
  else
    std::cout << "studio: with its page\n";
  return Exit_code::success;
}

} // namespace reebquad
