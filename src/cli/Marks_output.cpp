// SPDX-License-Identifier: GPL-3.0-or-later
#include "Marks_output.h"

#include <algorithm>
#include <sstream>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;
using Json = nlohmann::ordered_json;

namespace {

// A chain, or all of them, is kept if edges of quads lie on this part of it.
constexpr double enough = 0.98;

std::string place(const Point& p) {
  std::ostringstream text;
  text.precision(4);
  text << '(' << p.x() << ", " << p.y() << ", " << p.z() << ')';
  return text.str();
}

} // namespace

int Marks_outcome::kept_chains() const {
  return int(std::count_if(chains.begin(), chains.end(),
                           [](const Kept_chain& c) { return c.on >= enough * c.length; }));
}

Marks_outcome marks_outcome(const Quad_mesh& mesh, const Triangle_surface& surface, const Marks& marks,
                            double feature_angle) {
  Result<Marked_features> marked = marked_features(surface, marks, feature_angle);
  Feature_edges& edges = marked->features.edges;
  edges.chains.erase(std::remove_if(edges.chains.begin(), edges.chains.end(),
                                    [](const Feature_chain& c) { return c.boundary; }),
                     edges.chains.end());
  Marks_outcome outcome;
  outcome.chains = kept_chains(mesh, surface, edges);
  for (const Feature_chain& chain : edges.chains) outcome.is_closed.push_back(chain.closed);
  outcome.found = std::move(marked->found);
  return outcome;
}

Json marks_json(const Marks_outcome& outcome) {
  Json chains = Json::array();
  for (std::size_t i = 0; i < outcome.chains.size(); ++i) {
    const Kept_chain& c = outcome.chains[i];
    chains.push_back({{"length", c.length},
                      {"on", c.on},
                      {"near", c.near},
                      {"lost", c.lost()},
                      {"closed", bool(outcome.is_closed[i])},
                      {"missed", c.missed},
                      {"missed_at", {c.missed_at.x(), c.missed_at.y(), c.missed_at.z()}}});
  }
  const auto missing =
      std::count_if(outcome.found.begin(), outcome.found.end(), [](double part) { return part < 0.5; });
  return {{"kept", kept_part(outcome.chains)},
          {"kept_chains", outcome.kept_chains()},
          {"marks", outcome.found.size()},
          {"not_on_surface", missing},
          {"chains", std::move(chains)}};
}

std::string marks_text(const Marks_outcome& outcome) {
  std::ostringstream text;
  text.precision(3);
  text << "marks: edges of quads lie on " << 100 * kept_part(outcome.chains) << " % of the features, on "
       << outcome.kept_chains() << " of " << outcome.chains.size() << " chains from end to end\n";
  const auto worst =
      std::max_element(outcome.chains.begin(), outcome.chains.end(),
                       [](const Kept_chain& a, const Kept_chain& b) { return a.missed < b.missed; });
  if (worst != outcome.chains.end() && worst->missed > 0)
    text << "  the longest stretch that is missed has length " << worst->missed << ", at "
         << place(worst->missed_at) << '\n';
  return text.str();
}

std::string marks_warning(const std::vector<const Marks_outcome*>& outcomes, const Marks& marks) {
  std::vector<double> found(marks.marked.size(), 0);
  double on = 0, length = 0;
  for (const Marks_outcome* outcome : outcomes) {
    for (std::size_t i = 0; i < found.size(); ++i) found[i] += outcome->found[i];
    for (const Kept_chain& c : outcome->chains) {
      on += c.on;
      length += c.length;
    }
  }
  std::ostringstream text;
  text.precision(3);
  const auto missing = std::find_if(found.begin(), found.end(), [](double part) { return part < 0.5; });
  if (missing != found.end())
    text << std::count_if(found.begin(), found.end(), [](double part) { return part < 0.5; }) << " of "
         << found.size() << " marks lie on no edges of the mended surface, first the one at "
         << place(marks.marked[std::size_t(missing - found.begin())].from);
  if (on < enough * length)
    text << (text.tellp() > 0 ? "; " : "") << 100 * (1 - on / length)
         << " % of the marked and sharp edges are not edges of quads";
  return text.str();
}

} // namespace reebquad
