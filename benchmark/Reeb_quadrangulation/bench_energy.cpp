// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the energy that a search predicts for a design orders designs as their finished quads would: makes
// the quads of every design that the search tries and prints Spearman's rank correlation of the energy and of
// the same energy of the finished quads, of the whole and of each part; one JSON line a model, then the mean
// over the models and the correlation over all designs. Usage: bench_energy [-n TRIES] [-q QUADS] [-d TABLE]
// FILE...
//   -d TABLE: also writes the parts of each design, predicted and judged, separated by tabs
#include "bench_tools.h"

#include <CGAL/Reeb_quadrangulation/deviation.h>
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>
#include <CGAL/Reeb_quadrangulation/search_extrema.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <optional>

using namespace bench;
using Json = nlohmann::ordered_json;

namespace {

struct Options {
  int tries = 40, quads = 3000;
  std::string table;
  std::vector<std::string> models;
};

// What a design is said to be, and what its finished quads are.
struct Pair {
  Design_energy predicted, judged;
};

// A number that both sides have.
struct Part {
  const char* name;
  double (*of)(const Design_energy&);
};

const Part parts[] = {
    {"total", [](const Design_energy& e) { return e.total(Energy_weights()); }},
    {"shape", [](const Design_energy& e) { return e.shape; }},
    {"farthest", [](const Design_energy& e) { return e.farthest; }},
    {"angle", [](const Design_energy& e) { return e.angle; }},
    {"size", [](const Design_energy& e) { return e.size; }},
    {"extraordinary", [](const Design_energy& e) { return double(e.extraordinary); }},
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
std::optional<double> rank_correlation(const std::vector<Pair>& pairs, const Part& part) {
  std::vector<double> x, y;
  for (const Pair& p : pairs) {
    x.push_back(part.of(p.predicted));
    y.push_back(part.of(p.judged));
  }
  x = ranks(x);
  y = ranks(y);
  const double mean = 0.5 * double(pairs.size()) - 0.5;
  double xx = 0, yy = 0, xy = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    xx += (x[i] - mean) * (x[i] - mean);
    yy += (y[i] - mean) * (y[i] - mean);
    xy += (x[i] - mean) * (y[i] - mean);
  }
  if (!(xx > 0 && yy > 0)) return {};
  return xy / std::sqrt(xx * yy);
}

Json correlations(const std::vector<Pair>& pairs) {
  Json line;
  for (const Part& part : parts)
    if (const std::optional<double> c = rank_correlation(pairs, part)) line[part.name] = *c;
  return line;
}

double variance_of_logarithms(const Quad_mesh& mesh) {
  double sum = 0, squares = 0;
  for (const Quad& q : mesh.quads) {
    const Point d = mesh.points[q[2]] - mesh.points[q[0]], e = mesh.points[q[3]] - mesh.points[q[1]];
    const double x = std::log(std::max(0.5 * d.cross(e).norm(), 1e-300));
    sum += x;
    squares += x * x;
  }
  const double n = double(mesh.quads.size());
  return squares / n - (sum / n) * (sum / n);
}

// The energy of quads as they are, measured independently of the search's samples.
Result<Design_energy> judged(const Quad_mesh& quads, const Triangle_surface& surface) {
  const Result<Deviation> deviation = measure_deviation(quads, surface);
  if (!deviation) return deviation.error();
  const double edge = std::sqrt(area(surface) / double(quads.quads.size()));
  Design_energy energy;
  for (double d : deviation->of_surface) {
    energy.shape += d * d / (edge * edge * double(deviation->of_surface.size()));
    energy.farthest = std::max(energy.farthest, d / edge);
  }
  const Mesh_statistics statistics = quad_statistics(quads);
  energy.angle = 1 - statistics.scaled_jacobian.mean;
  energy.size = variance_of_logarithms(quads);
  energy.extraordinary = statistics.extraordinary_vertices;
  return energy;
}

// The designs that a search tries, each with its finished quads.
Result<std::vector<Pair>> pairs_of(const Triangle_surface& surface, const Options& options) {
  Editor_options session;
  session.quads = options.quads;
  session.threads = 1;
  Result<Editor> editor = Editor::create(surface, session);
  if (!editor) return editor.error();
  std::vector<std::pair<Edit, Design_energy>> designs;
  Search_options search;
  search.tries = options.tries;
  search.tried = [&](const Edit& edit, const Design_energy& energy) { designs.emplace_back(edit, energy); };
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
    const Result<Design_energy> quality = judged(finished->quads.mesh, editor->input());
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
    else if (word == "-d" && i + 1 < argc)
      options.table = argv[++i];
    else
      options.models.push_back(word);
  }
  return options;
}

void write(std::ostream& table, const std::string& model, const std::vector<Pair>& pairs) {
  for (const Pair& pair : pairs) {
    table << model;
    for (const Design_energy* e : {&pair.predicted, &pair.judged})
      for (const Part& part : parts) table << '\t' << part.of(*e);
    table << '\n';
  }
}

void write_means(std::map<std::string, std::vector<double>>& found, const std::vector<Pair>& all) {
  Json line{{"model", "mean"}};
  for (const auto& [part, values] : found)
    line["rank_correlation"][part] =
        std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
  std::cout << line.dump() << std::endl;
  std::cout << Json{{"model", "all designs"},
                    {"designs", all.size()},
                    {"rank_correlation", correlations(all)}}
                   .dump()
            << std::endl;
}

} // namespace

int main(int argc, char** argv) {
  const Options options = read(argc, argv);
  std::map<std::string, std::vector<double>> found;
  std::vector<Pair> all;
  std::ofstream table;
  if (!options.table.empty()) table.open(options.table);
  for (const std::string& model : options.models) {
    Json line{{"model", std::filesystem::path(model).filename().string()}};
    Result<Triangle_surface> surface = largest_component(model);
    Result<std::vector<Pair>> pairs = surface ? pairs_of(*surface, options) : surface.error();
    if (!pairs) {
      line["error"] = pairs.error().message;
    } else {
      line["designs"] = pairs->size();
      line["rank_correlation"] = correlations(*pairs);
      for (const auto& [part, value] : line["rank_correlation"].items()) found[part].push_back(value);
      all.insert(all.end(), pairs->begin(), pairs->end());
      if (table.is_open()) write(table, line["model"], *pairs);
    }
    std::cout << line.dump() << std::endl;
  }
  write_means(found, all);
  return 0;
}
