// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a run as one HTML file with a viewer in it.
#include "Layout_view.h"
#include "Run.h"

#include "view/Html_report.h"

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;

namespace {

studio::Layers layers_of(const Quadrangulation& result, const Point& origin) {
  const Design& design = result.editor.design();
  const Layout_view view(result.editor);
  studio::Layer_source source;
  source.origin = origin;
  source.surface = &result.editor.working_surface();
  source.charted = &view.charted;
  for (std::size_t c = 0; c < design.charts.size(); ++c) source.chart_ids.push_back(int(c));
  source.extrema = design.extrema;
  source.quads = &result.mesh;
  source.chart_of_quad = result.chart_of_quad;
  return studio::make_layers(source);
}

} // namespace

std::string report_html(const Run& run, const Run_options& options) {
  studio::Html_report report;
  report.title = options.input;
  report.facts = studio::Json::parse(report_json(run, options));
  Eigen::AlignedBox3d box;
  for (const Point& p : run.surface.points) box.extend(p);
  report.facts["axis"] = {options.pipeline.suggestion.axis.x(), options.pipeline.suggestion.axis.y(),
                          options.pipeline.suggestion.axis.z()};
  for (const Component_run& component : run.components)
    if (component.result) report.parts.push_back(layers_of(*component.result, box.center()));
  return value_or_fail(studio::html_text(report), options.html);
}

} // namespace reebquad
