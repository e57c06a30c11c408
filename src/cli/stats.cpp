// SPDX-License-Identifier: GPL-3.0-or-later
// reebquad stats QUADS: certifies and measures a quad mesh of any origin.
#include "Command.h"
#include "Input.h"
#include "Interruption.h"
#include "Terminal_observer.h"

#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>
#include <CGAL/Reeb_quadrangulation/surface_as_read.h>

#include <nlohmann/json.hpp>

#include <iostream>
#include <optional>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;
namespace po = boost::program_options;

Exit_code execute_stats(const Arguments& arguments) {
  Command_line line("stats QUADS [--against INPUT] [--json] [--strict]");
  line.options.add_options()(
      "against", po::value<std::string>()->value_name("FILE"),
      "the triangle surface that the quads stand for: compares the topology, measures the "
      "distance and what is lost of the shape")("json", "print the numbers as JSON")(
      "strict", "warnings about the shape end with 5");
  line.take("QUADS");
  if (!line.parse(arguments)) return Exit_code::success;
  const std::string file = line.required("QUADS");

  watch_for_interruption();
  const Quad_mesh quads = quads_of(read_soup(file), file);
  std::optional<Triangle_surface> input, as_read;
  if (line.has("against")) {
    const Polygon_soup soup = read_soup(line.text("against"));
    input = joined(value_or_fail(mend_surface(soup), line.text("against")));
    as_read = surface_as_read(soup);
  }

  const Terminal_observer observer(true);
  Certificate_options options;
  options.observer = &observer;
  Certificate_input certified{quads};
  if (input) {
    certified.input = &*input;
    certified.as_read = &*as_read;
  }
  const Certificate certificate = certify(certified, options);
  Mesh_statistics statistics = quad_statistics(quads);
  if (certificate.shape) add_shape(statistics, *certificate.shape);
  if (interrupted()) return Exit_code::interrupted;

  if (line.has("json")) {
    nlohmann::ordered_json out;
    out["file"] = file;
    out["certificate"] = nlohmann::ordered_json::parse(to_json(certificate));
    out["statistics"] = nlohmann::ordered_json::parse(to_json(statistics));
    std::cout << out.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
  } else {
    std::cout << to_text(certificate) << '\n' << to_text(statistics);
  }
  const bool warned = line.has("strict") && !certificate.warnings.empty();
  return certificate.passed && !warned ? Exit_code::success : Exit_code::certificate_failed;
}

} // namespace reebquad
