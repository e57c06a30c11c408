// SPDX-License-Identifier: GPL-3.0-or-later
// reebquad stats QUADS: certifies and measures a quad mesh of any origin.
#include "Command.h"
#include "Input.h"
#include "Interruption.h"
#include "Terminal_observer.h"

#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>

#include <nlohmann/json.hpp>

#include <iostream>
#include <optional>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;
namespace po = boost::program_options;

Exit_code execute_stats(const Arguments& arguments) {
  Command_line line("stats QUADS [--against INPUT] [--json]");
  line.options.add_options()(
      "against", po::value<std::string>()->value_name("FILE"),
      "the triangle surface that the quads stand for: compares the topology, measures the "
      "distance and what is undersampled")("json", "print the numbers as JSON");
  line.take("QUADS");
  if (!line.parse(arguments)) return Exit_code::success;
  const std::string file = line.required("QUADS");

  watch_for_interruption();
  const Quad_mesh quads = quads_of(read_soup(file), file);
  std::optional<Triangle_surface> input;
  if (line.has("against"))
    input = joined(value_or_fail(mend_surface(read_soup(line.text("against"))), line.text("against")));

  const Terminal_observer observer(true);
  Certificate_options options;
  options.observer = &observer;
  const Certificate certificate = certify({quads, input ? &*input : nullptr}, options);
  const Mesh_statistics statistics = quad_statistics(quads, input ? &*input : nullptr);
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
  return certificate.passed ? Exit_code::success : Exit_code::certificate_failed;
}

} // namespace reebquad
