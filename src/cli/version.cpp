// SPDX-License-Identifier: GPL-3.0-or-later
#include "Command.h"

#include "view/Assets.h"

#include <CGAL/version.h>
#include <Eigen/Core>

#include <iostream>

namespace reebquad {

Exit_code execute_version(const Arguments& arguments) {
  Command_line line("version");
  if (!line.parse(arguments)) return Exit_code::success;
  std::cout << "reebquad " REEBQUAD_VERSION " (CGAL " CGAL_VERSION_STR ", Eigen " << EIGEN_WORLD_VERSION
            << '.' << EIGEN_MAJOR_VERSION << '.' << EIGEN_MINOR_VERSION << ")\n";
  if (studio::assets().empty())
    std::cout << "studio: without its page (" << studio::missing_page_reason() << ")\n";
  else
    std::cout << "studio: with its page\n";
  return Exit_code::success;
}

} // namespace reebquad
