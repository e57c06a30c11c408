// SPDX-License-Identifier: GPL-3.0-or-later
#include "Design.h"

#include <CGAL/Reeb_quadrangulation/quadrangulate.h>

namespace reebquad {
namespace studio {

using namespace CGAL::Reeb_quadrangulation;

Point middle(const Triangle_surface& surface) {
  Eigen::AlignedBox3d box;
  for (const Point& p : surface.points) box.extend(p);
  return box.isEmpty() ? Point::Zero() : Point(box.center());
}

namespace {

/// The automatic pipeline; its edits are the options of the suggestion and the number of quads.
class Automatic_design : public Design {
public:
  explicit Automatic_design(Triangle_surface surface)
      : m_surface(std::move(surface)), m_origin(middle(m_surface)), m_results(1) {}

  Result<Json> apply(const Json& edit, Observer* observer) override {
    std::vector<Json> edits(m_edits.begin(), m_edits.begin() + m_applied);
    edits.push_back(edit);
    Result<Quadrangulation_options> options = options_of(edits);
    if (!options) return options.error();
    Result<Quadrangulation> result = quadrangulate(m_surface, *options, observer);
    if (!result) return result.error();
    m_edits = std::move(edits);
    m_results.resize(m_edits.size());
    m_results.push_back(std::make_shared<Quadrangulation>(std::move(*result)));
    ++m_applied;
    return Json::object();
  }

  Result<void> undo(Observer*) override {
    if (m_applied == 0) return make_error(Error_code::impossible_request, "there is nothing to undo");
    --m_applied;
    return {};
  }
  Result<void> redo(Observer*) override {
    if (m_applied == int(m_edits.size()))
      return make_error(Error_code::impossible_request, "there is nothing to redo");
    ++m_applied;
    return {};
  }

  const std::vector<Json>& edits() const override { return m_edits; }
  int applied() const override { return m_applied; }

  Layers layers() const override {
    Layer_source source;
    source.surface = &m_surface;
    source.origin = m_origin;
    if (const Quadrangulation* q = result()) {
      source.embedding = &q->layout.embedding;
      source.network = &q->layout.network;
      source.atlas = &q->layout.atlas;
      source.graph = &q->layout.graph;
      source.critical = &q->layout.critical;
      source.values = &q->layout.values;
      source.counts = &q->sampling.counts;
      source.quads = &q->mesh;
      source.chart_of_quad = &q->chart_of_quad;
    }
    return make_layers(source);
  }

  Json facts() const override {
    Json charts = Json::array();
    if (const Quadrangulation* q = result())
      for (std::size_t c = 0; c < q->layout.atlas.charts.size(); ++c)
        charts.push_back({{"id", c},
                          {"kind", q->layout.atlas.charts[c]->kind == Chart_kind::disc ? "disc" : "annulus"},
                          {"columns", q->sampling.grid[c][0]},
                          {"rows", q->sampling.grid[c][1]}});
    return {{"charts", charts}};
  }

  Result<std::shared_ptr<const std::string>> chart(int) const override {
    return make_error(Error_code::impossible_request, "there is no chart of that number");
  }

  const Triangle_surface& surface() const override { return m_surface; }
  const Quad_mesh* quads() const override { return result() ? &result()->mesh : nullptr; }
  const std::map<int, int>& predicted_valences() const override {
    static const std::map<int, int> none;
    return result() ? result()->valences : none;
  }

private:
  const Quadrangulation* result() const { return m_results[m_applied].get(); }

  static Result<Quadrangulation_options> options_of(const std::vector<Json>& edits) {
    Quadrangulation_options options;
    for (const Json& edit : edits) {
      const std::string name = edit.value("edit", "");
      if (name == "suggest") {
        options.suggestion.persistence = edit.value("persistence", options.suggestion.persistence);
        if (edit.contains("axis")) {
          const std::vector<double> axis = edit["axis"];
          options.suggestion.axis = {axis.at(0), axis.at(1), axis.at(2)};
        }
      } else if (name == "set_target") {
        options.quads = edit.value("quads", options.quads);
      } else {
        return make_error(Error_code::refused_edit, "there is no edit '" + name + "'");
      }
    }
    return options;
  }

  Triangle_surface m_surface;
  Point m_origin;
  std::vector<Json> m_edits;
  std::vector<std::shared_ptr<Quadrangulation>> m_results; // after each number of edits
  int m_applied = 0;
};

} // namespace

Result<std::unique_ptr<Design>> Design::create(Triangle_surface surface, Observer*) {
  return std::unique_ptr<Design>(std::make_unique<Automatic_design>(std::move(surface)));
}

} // namespace studio
} // namespace reebquad
