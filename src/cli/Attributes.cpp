// SPDX-License-Identifier: GPL-3.0-or-later
#include "Attributes.h"

#include "Input.h"
#include "Interruption.h"

#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>
#include <CGAL/Reeb_quadrangulation/quad_parameters.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;

namespace {

/// Moves the texture coordinates of each chart, of all quads, into a square of its own; squares are side by
/// side in rows.
void pack(const std::vector<int>& chart, int charts, std::vector<Eigen::Vector2d>& uv) {
  constexpr double margin = 0.02; // of a square
  std::vector<Eigen::AlignedBox2d> box(std::size_t(std::max(charts, 0)));
  for (std::size_t i = 0; i < uv.size(); ++i) box[std::size_t(chart[i / 4])].extend(uv[i]);
  const int side = std::max(1, int(std::ceil(std::sqrt(double(charts)))));
  for (std::size_t i = 0; i < uv.size(); ++i) {
    const int c = chart[i / 4];
    const Eigen::AlignedBox2d& own = box[std::size_t(c)];
    const Eigen::Vector2d in_box = (uv[i] - own.min()).cwiseQuotient(own.sizes().cwiseMax(1e-300));
    const Eigen::Vector2d square(c % side, c / side); // its number in each direction
    uv[i] = (square + Eigen::Vector2d::Constant(margin) + (1 - 2 * margin) * in_box) / side;
  }
}

} // namespace

Attributed_soup read_attributed_soup(const std::string& file, std::vector<std::string>* notes) {
  Attributed_soup read;
  read.soup = read_soup(file, notes, &read.attributes);
  return read;
}

void add_charts(const std::vector<Component_run>& components, Mesh_attributes& attributes) {
  Face_labels charts;
  charts.kind = "chart";
  std::vector<Eigen::Vector2d> uv;
  bool has_uv = true;
  std::size_t quads = 0;
  for (std::size_t c = 0; c < components.size(); ++c) {
    if (!components[c].result) continue;
    const Quadrangulation& result = *components[c].result;
    const int first = int(charts.names.size());
    const std::string prefix = components.size() > 1 ? "component_" + std::to_string(c + 1) + "_" : "";
    for (std::size_t i = 0; i < result.editor.design().charts.size(); ++i)
      charts.names.push_back(prefix + "chart_" + std::to_string(i));
    for (const int chart : result.chart_of_quad) charts.label.push_back(chart < 0 ? -1 : first + chart);
    quads += result.mesh.quads.size();
    charts.label.resize(quads, -1); // quads between a half and its mirror image may be of no chart
    const Result<std::vector<Quad_parameters>> parameters = quad_parameters(result);
    has_uv = has_uv && bool(parameters);
    if (!has_uv) continue;
    for (const Quad_parameters& quad : *parameters) uv.insert(uv.end(), quad.begin(), quad.end());
  }
  if (has_uv) {
    pack(charts.label, int(charts.names.size()), uv);
    attributes.uv = std::move(uv);
  } else {
    attributes.others.push_back(
        "texture coordinates of charts, which subdivided or mirrored quads do not have");
  }
  attributes.labels.erase(std::remove_if(attributes.labels.begin(), attributes.labels.end(),
                                         [](const Face_labels& l) { return l.kind == "chart"; }),
                          attributes.labels.end());
  attributes.labels.push_back(std::move(charts));
}

void write_quads(const std::string& file, const Polygon_soup& quads, const Mesh_attributes& attributes,
                 bool quiet) {
  std::vector<std::string> dropped;
  Write_options options;
  options.attributes = &attributes;
  options.dropped = &dropped;
  const Uninterruptible whole;
  for (const std::string& warning : value_or_fail(write_mesh(file, quads, options), file))
    std::cerr << "reebquad: " << file << ": " << warning << '\n';
  if (quiet || dropped.empty()) return;
  std::cerr << "reebquad: " << file << ": dropped: ";
  for (std::size_t i = 0; i < dropped.size(); ++i) std::cerr << (i > 0 ? ", " : "") << dropped[i];
  std::cerr << '\n';
}

} // namespace reebquad
