// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the energy that a search predicts for a design orders designs as their finished quads would: makes
// the quads of every design that the search tries and prints Spearman's rank correlation of the energy and of
// what is measured of the quads, one JSON line a model, then the mean over all. Usage: bench_energy [-n
// TRIES] [-q QUADS] FILE...
//   judged = mean of the squared distance of the surface from the quads, in squared mean edges, and half of 1
//   less the mean scaled Jacobian, and the price of the extraordinary vertices
#include "bench_tools.h"

#include <CGAL/Reeb_quadrangulation/deviation.h>
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>
#include <CGAL/Reeb_quadrangulation/search_extrema.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <numeric>
#include <optional>

using namespace bench;
using Json = nlohmann::ordered_json;

namespace {

struct Options {
  int tries = 40, quads = 3000;
  std::vector<std::string> models;
};

struct Pair {
  double predicted = 0, judged = 0;
};

// Equal values share the mean of their ranks.
std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> result(values.size());
  for (std::size_t begin = 0, end; begin < order.size(); begin = end) {
    for (end = begin; end < order.size() && values[order[end]] == values[order[begin]];) ++end;
    for (std::size_t i = begin; i < end; ++i) result[order[i]] = 0.5 * double(begin + end - 1);
  }
  return result;
}

// Spearman's; nothing where one side is constant.
std::optional<double> rank_correlation(const std::vector<Pair>& pairs) {
  std::vector<double> x, y;
  for (const Pair& p : pairs) {
    x.push_back(p.predicted);
    y.push_back(p.judged);
  }
  x = ranks(x);
  y = ranks(y);
  const double mean = 0.5 * double(pairs.size() - 1);
  double xx = 0, yy = 0, xy = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    xx += (x[i] - mean) * (x[i] - mean);
    yy += (y[i] - mean) * (y[i] - mean);
    xy += (x[i] - mean) * (y[i] - mean);
  }
  if (!(xx > 0 && yy > 0)) return {};
  return xy / std::sqrt(xx * yy);
}

Result<double> judged(const Quad_mesh& quads, const Triangle_surface& surface) {
  const Result<Deviation> deviation = measure_deviation(quads, surface);
  if (!deviation) return deviation.error();
  double squares = 0;
  for (double d : deviation->of_surface) squares += d * d;
  squares /= double(deviation->of_surface.size());
  const Mesh_statistics statistics = quad_statistics(quads);
  const Energy_weights weights;
  const double edge = statistics.edge_length.mean;
  return weights.shape * squares / (edge * edge) + weights.angle * (1 - statistics.scaled_jacobian.mean) +
         weights.vertices * statistics.extraordinary_vertices;
}

// The designs that a search tries, each with its finished quads.
Result<std::vector<Pair>> pairs_of(const Triangle_surface& surface, const Options& options) {
  Editor_options session;
  session.quads = options.quads;
  session.threads = 1;
  Result<Editor> editor = Editor::create(surface, session);
  if (!editor) return editor.error();
  std::vector<std::pair<Edit, double>> designs;
  Search_options search;
  search.tries = options.tries;
  search.tried = [&](const Edit& edit, const Design_energy& energy) {
    designs.emplace_back(edit, energy.total(search.weights));
  };
  if (const Result<Searched_extrema> found = search_extrema(*editor, Suggest{}, search); !found)
    return found.error();
  std::vector<Pair> pairs;
  for (auto& [edit, energy] : designs) {
    if (auto* set = std::get_if<Set_extrema>(&edit)) // vertices of the search's copy
      for (Set_extrema::Extremum& e : set->extrema) e.at.vertex = -1;
    if (!editor->apply(edit)) continue;
    const Result<Finished_design> finished = editor->finished_quads();
    editor->undo();
    if (!finished) continue;
    const Result<double> quality = judged(finished->quads.mesh, editor->input());
    if (!quality) return quality.error();
    pairs.push_back({energy, *quality});
  }
  return pairs;
}

Options read(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "-n" && i + 1 < argc)
      options.tries = std::max(2, std::atoi(argv[++i]));
    else if (word == "-q" && i + 1 < argc)
      options.quads = std::max(1, std::atoi(argv[++i]));
    else
      options.models.push_back(word);
  }
  return options;
}

} // namespace

int main(int argc, char** argv) {
  const Options options = read(argc, argv);
  double sum = 0;
  int models = 0;
  for (const std::string& model : options.models) {
    Json line{{"model", std::filesystem::path(model).filename().string()}};
    Result<Triangle_surface> surface = largest_component(model);
    Result<std::vector<Pair>> pairs = surface ? pairs_of(*surface, options) : surface.error();
    if (!pairs) {
      line["error"] = pairs.error().message;
    } else {
      line["designs"] = pairs->size();
      if (const std::optional<double> correlation = rank_correlation(*pairs)) {
        line["rank_correlation"] = *correlation;
        sum += *correlation;
        ++models;
      }
    }
    std::cout << line.dump() << std::endl;
  }
  if (models > 0)
    std::cout << Json{{"model", "mean"}, {"rank_correlation", sum / models}}.dump() << std::endl;
  return 0;
}
