// SPDX-License-Identifier: GPL-3.0-or-later
// reebquad shape NAME -o FILE: writes a built-in triangle surface.
#include "Input.h"
#include "Interruption.h"

#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <cstdio>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;
namespace po = boost::program_options;

namespace {

void print_shapes() {
  for (const Shape_info& shape : shape_names())
    std::printf("  %-12s %s\n", shape.name.c_str(), shape.description.c_str());
}

} // namespace

Exit_code execute_shape(const Arguments& arguments) {
  Command_line line("shape NAME -o FILE [--triangles N]   (reebquad shape --list names the shapes)");
  line.options.add_options()("output,o", po::value<std::string>()->value_name("FILE"), "the file to write")(
      "triangles", po::value<int>()->default_value(10000)->value_name("N"),
      "about how many triangles")("list", "list the built-in shapes");
  line.take("NAME");
  if (!line.parse(arguments)) return Exit_code::success;
  if (line.has("list")) {
    print_shapes();
    return Exit_code::success;
  }
  const std::string name = line.required("NAME");
  const std::string file = line.required("output");
  require_writable_format(file);
  watch_for_interruption();
  const Triangle_surface surface =
      value_or_fail(make_shape(name, line.values["triangles"].as<int>()), "shape");
  const Uninterruptible whole;
  for (const std::string& warning : value_or_fail(write_mesh(file, surface), file))
    std::fprintf(stderr, "reebquad: %s: %s\n", file.c_str(), warning.c_str());
  return Exit_code::success;
}

} // namespace reebquad
