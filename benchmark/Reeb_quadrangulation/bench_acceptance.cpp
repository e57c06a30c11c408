// SPDX-License-Identifier: GPL-3.0-or-later
// Tries the edits of contours, saddles and extrema mechanically on suggested designs and prints how many are
// accepted, how long an accepted one takes, and which sentences refuse the others: one JSON line a model and
// kind of edit, then the sums of all models. Usage: bench_acceptance [-n TRIES] [-q QUADS] [-k WORD]
// [--certify] [--offers] FILE|FOLDER|globe:K...
//   -n: at most so many tries of a kind on one model (default 10), spread evenly over the elements; -k: only
//   kinds with this word
//   --certify: the quads of every accepted edit pass the certificate, or count as "not certified"
//   --offers: after each refusal, whether something near works (offer_after.h), and how long it took to find
//   globe:K: a ball of K lobes, whose maxima meet in one degenerate saddle (K = 3: a monkey saddle)
#include "bench_tools.h"
#include "globe.h"

#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/offer_after.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <ctime>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

using namespace bench;
using Json = nlohmann::ordered_json;
using Eigen::Vector3d;

namespace {

constexpr double pi = 3.14159265358979323846;

struct Options {
  int tries = 10, quads = 2500;
  std::string word;
  bool certify = false, offers = false;
  std::vector<std::string> models;
};

struct Tally {
  int tried = 0, accepted = 0, not_certified = 0, offered = 0;
  std::vector<double> milliseconds, offer_milliseconds;
  std::map<std::string, int> refusals;

  void add(const Tally& o) {
    tried += o.tried;
    accepted += o.accepted;
    not_certified += o.not_certified;
    offered += o.offered;
    offer_milliseconds.insert(offer_milliseconds.end(), o.offer_milliseconds.begin(),
                              o.offer_milliseconds.end());
    milliseconds.insert(milliseconds.end(), o.milliseconds.begin(), o.milliseconds.end());
    for (const auto& [sentence, n] : o.refusals) refusals[sentence] += n;
  }
  Json json() const {
    Json line{{"tried", tried}, {"accepted", accepted}};
    line["percent"] = tried > 0 ? std::round(1000.0 * accepted / tried) / 10 : 0.0;
    if (!milliseconds.empty()) line["median_ms"] = std::round(median(milliseconds));
    if (not_certified > 0) line["not_certified"] = not_certified;
    if (!refusals.empty()) line["refusals"] = refusals;
    if (!offer_milliseconds.empty()) {
      line["offered"] = offered;
      line["median_offer_ms"] = std::round(median(offer_milliseconds));
    }
    return line;
  }
};

std::string sentence(const Error& error) {
  const std::string text =
      error.code == Error_code::infeasible_sampling ? "infeasible counts" : error.message;
  return text.substr(0, text.find(':'));
}

// One closed or open contour edge of the present design, as points.
struct Curve {
  std::vector<Point> points;
  Vector3d normal = Vector3d::Zero(); // of the plane that fits best around it
  Point middle = Point::Zero();       // halfway along
  Point centre = Point::Zero();
};

class Trial {
public:
  Trial(Editor& editor, const Options& options) : m_editor(editor), m_options(options) {}

  std::map<std::string, Tally> run() {
    reorient();
    parts();
    plain_contours();
    move_saddles();
    straighten();
    rings_by_field();
    split_after_align();
    degenerate_saddles();
    extrema();
    return std::move(m_tallies);
  }

private:
  const Design& design() const { return m_editor.design(); }
  const Triangle_surface& surface() const { return m_editor.working_surface(); }
  Surface_point at(int v) const { return {surface().points[v], v}; }

  bool is_asked(const std::string& kind) const { return kind.find(m_options.word) != std::string::npos; }

  // At most as many elements as tries are wanted, spread evenly.
  template <class T> std::vector<T> spread(const std::vector<T>& all, int wanted = 0) const {
    const int n = int(all.size()), k = std::min(n, wanted > 0 ? wanted : m_options.tries);
    std::vector<T> some;
    for (int i = 0; i < k; ++i) some.push_back(all[std::size_t(i) * std::size_t(n) / std::size_t(k)]);
    return some;
  }

  void attempt(const std::string& kind, const Edit& edit) {
    if (!is_asked(kind)) return;
    Tally& tally = m_tallies[kind];
    ++tally.tried;
    const std::clock_t begin = std::clock();
    const Result<Edit_report> done = m_editor.apply(edit);
    if (!done) {
      ++tally.refusals[sentence(done.error())];
      if (m_options.offers) look_for_offer(tally, edit, done.error());
      return;
    }
    tally.milliseconds.push_back(1000.0 * double(std::clock() - begin) / CLOCKS_PER_SEC);
    ++tally.accepted;
    if (m_options.certify) {
      const Stitched_mesh quads = m_editor.quads();
      const Certificate seal = certify({quads.mesh, &surface(), quads.valences});
      if (!seal.passed) ++tally.not_certified;
    }
    m_editor.undo();
  }

  void look_for_offer(Tally& tally, const Edit& edit, const Error& refusal) {
    const std::clock_t begin = std::clock();
    const Result<std::optional<Offer>> offer = offer_after(m_editor, edit, refusal);
    tally.offer_milliseconds.push_back(1000.0 * double(std::clock() - begin) / CLOCKS_PER_SEC);
    if (offer && *offer) ++tally.offered;
  }

  Curve curve(int e) const {
    const std::vector<int>& v = design().network.edges[e].vertices;
    Curve c;
    for (int i : v) c.points.push_back(design().network.position(surface(), i));
    for (const Point& p : c.points) c.centre += p / double(c.points.size());
    for (std::size_t i = 0; i < c.points.size(); ++i) {
      const Point &p = c.points[i], &q = c.points[(i + 1) % c.points.size()];
      c.normal += (p - c.centre).cross(q - c.centre);
    }
    c.normal.normalize();
    c.middle = c.points[c.points.size() / 2];
    return c;
  }

  bool is_saddle(int node) const { return design().network.nodes[node].kind == Node_kind::saddle; }

  std::vector<int> edges_where(const std::function<bool(const Contour_edge&)>& wanted) const {
    std::vector<int> found;
    for (std::size_t e = 0; e < design().network.edges.size(); ++e) {
      const std::array<int, 2> sides = design().atlas.charts_of_edge[e];
      const Contour_edge& edge = design().network.edges[e];
      if (!design().network.is_removed(edge) && sides[0] >= 0 && sides[1] >= 0 && wanted(edge))
        found.push_back(int(e));
    }
    return found;
  }
  std::vector<int> saddle_loops() const {
    return edges_where([&](const Contour_edge& e) { return e.from == e.to && is_saddle(e.from); });
  }
  std::vector<int> plain_loops() const {
    return edges_where([&](const Contour_edge& e) {
      return e.from == e.to && design().network.nodes[e.from].kind == Node_kind::regular;
    });
  }
  std::vector<int> saddles() const {
    std::vector<int> nodes;
    for (int e : edges_where([](const Contour_edge&) { return true; }))
      for (int n : {design().network.edges[e].from, design().network.edges[e].to})
        if (is_saddle(n) && std::find(nodes.begin(), nodes.end(), n) == nodes.end()) nodes.push_back(n);
    return nodes;
  }
  Surface_point point_of(int node) const {
    const int v = design().network.nodes[node].vertex;
    return {design().network.position(surface(), v), v < surface().number_of_vertices() ? v : -1};
  }

  // The normal turned by an angle about the i-th of four axes in the plane.
  static Vector3d tilted(const Vector3d& normal, double degrees, int i) {
    Vector3d a = normal.unitOrthogonal();
    a = Eigen::AngleAxisd(i * pi / 4, normal) * a;
    return Eigen::AngleAxisd(degrees * pi / 180, a) * normal;
  }

  void reorient() {
    int i = 0;
    for (int e : spread(saddle_loops())) {
      const Curve c = curve(e);
      for (int degrees : {0, 20, 45})
        attempt("reorient saddle's loop " + std::to_string(degrees),
                Move_contour{{c.middle, -1}, c.points[0], tilted(c.normal, degrees, i), {}});
      attempt("reorient by field 20",
              Move_contour{{c.middle, -1}, c.points[0], tilted(c.normal, 20, i), {}, Enforcement::field});
      ++i;
    }
  }

  void parts() {
    int i = 0;
    const auto part = [&](const std::string& kind, int e) {
      const Curve c = curve(e);
      const std::size_t n = c.points.size();
      attempt(kind, Move_contour{{c.middle, -1},
                                 c.points[0],
                                 tilted(c.normal, 15, i++),
                                 {{c.points[n / 4], -1}, {c.points[3 * n / 4], -1}}});
    };
    for (int e : spread(saddle_loops())) part("part between anchors, at saddles", e);
    for (int e : spread(plain_loops())) part("part between anchors, on plain contours", e);
  }

  void plain_contours() {
    int i = 0;
    const double h = design().edge_length;
    for (int e : spread(plain_loops())) {
      const Curve c = curve(e);
      const Point moved = c.centre + (i % 2 == 0 ? h : -h) * c.normal;
      attempt("move plain contour", Move_contour{{c.middle, -1}, moved, tilted(c.normal, 15, i++), {}});
    }
  }

  // A vertex whose distance from another is between two bounds and that lies in the i-th of eight directions.
  std::optional<int> vertex_beside(int v, double least, double most, int i) const {
    std::vector<int> ring;
    std::vector<std::pair<double, int>> queue{{0, v}};
    std::map<int, double> distance{{v, 0}};
    while (!queue.empty()) {
      std::pop_heap(queue.begin(), queue.end(), std::greater<>());
      const auto [d, w] = queue.back();
      queue.pop_back();
      if (d > distance[w]) continue;
      if (d >= least) ring.push_back(w);
      const int first = surface().outgoing[w];
      int h = first;
      do {
        const int u = surface().target(h);
        const double far = d + (surface().points[u] - surface().points[w]).norm();
        const auto known = distance.find(u);
        if (far <= most && (known == distance.end() || far < known->second)) {
          distance[u] = far;
          queue.push_back({far, u});
          std::push_heap(queue.begin(), queue.end(), std::greater<>());
        }
        h = surface().rotate_ccw(h);
      } while (h >= 0 && h != first);
    }
    if (ring.empty()) return {};
    std::sort(ring.begin(), ring.end());
    return ring[std::size_t(i) * ring.size() / 8];
  }

  void move_saddles() {
    const double h = design().edge_length;
    const std::vector<int> nodes = saddles();
    const int each = nodes.empty() ? 0 : std::max(1, m_options.tries / int(nodes.size()));
    for (int node : spread(nodes))
      for (int i = 0; i < each; ++i) {
        const Surface_point from = point_of(node);
        if (from.vertex < 0) continue;
        const int direction = (3 * i + node) % 8;
        if (const auto to = vertex_beside(from.vertex, h, 3 * h, direction))
          attempt("move saddle by 1 to 3 edges", Move_saddle{from, at(*to)});
        if (const auto to = vertex_beside(from.vertex, 3 * h, 6 * h, direction))
          attempt("move saddle by 3 to 6 edges", Move_saddle{from, at(*to)});
      }
  }

  void straighten() {
    for (int e : spread(saddle_loops()))
      attempt("straighten saddle's loop", Straighten_contour{{curve(e).middle, -1}});
    for (int e : spread(plain_loops()))
      attempt("straighten plain contour", Straighten_contour{{curve(e).middle, -1}});
  }

  // A ring in the middle of an annulus, then moved by the field alone.
  void rings_by_field() {
    if (!is_asked("ring by field")) return;
    std::vector<int> annuli;
    for (std::size_t c = 0; c < design().charts.size(); ++c)
      if (design().charts[c]->chart->kind == Chart_kind::annulus) annuli.push_back(int(c));
    int i = 0;
    for (int c : spread(annuli, (m_options.tries + 1) / 2)) {
      const Design_chart& chart = *design().charts[c];
      int best = -1;
      double least = 1;
      for (std::size_t v = 0; v < chart.chart->vertex_origin.size(); ++v)
        if (const int o = chart.chart->vertex_origin[v]; o >= 0 && o < surface().number_of_vertices())
          if (const double d = std::abs(chart.map->u()[v] - 0.5); d < least) {
            least = d;
            best = o;
          }
      if (best < 0) continue;
      const Point p = surface().points[best];
      if (!m_editor.apply(Subdivide_chart{at(best)})) continue;
      for (int e : plain_loops()) {
        const Curve ring = curve(e);
        const auto on_ring = [&](const Point& q) { return q == p; };
        if (std::none_of(ring.points.begin(), ring.points.end(), on_ring)) continue;
        attempt("ring by field",
                Move_contour{
                    {ring.middle, -1}, ring.centre, tilted(ring.normal, 10, i++), {}, Enforcement::field});
      }
      m_editor.undo();
    }
  }

  void split_after_align() {
    if (!is_asked("split after align")) return;
    const std::vector<int> nodes = saddles();
    int aligned = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (std::size_t j = i + 1; j < nodes.size() && aligned < (m_options.tries + 1) / 2; ++j) {
        const std::array<Surface_point, 2> pair{point_of(nodes[i]), point_of(nodes[j])};
        if (!m_editor.apply(Align_saddles{pair[0], pair[1]})) continue;
        ++aligned;
        for (const Surface_point& p : pair)
          for (Saddle_kind kind : {Saddle_kind::half, Saddle_kind::quarter})
            attempt(std::string("split after align, ") + (kind == Saddle_kind::half ? "half" : "quarter"),
                    Split_saddle{p, kind, {}});
        m_editor.undo();
      }
  }

  void degenerate_saddles() {
    const double h = design().edge_length;
    for (int node : saddles()) {
      if (design().network.nodes[node].multiplicity < 2) continue;
      const Surface_point p = point_of(node);
      attempt("split degenerate saddle, half", Split_saddle{p, Saddle_kind::half, {}});
      attempt("split degenerate saddle, quarter", Split_saddle{p, Saddle_kind::quarter, {}});
      for (int i = 0; i < 8; i += 2)
        if (const auto to = vertex_beside(p.vertex, h, 3 * h, i))
          attempt("move degenerate saddle", Move_saddle{p, at(*to)});
    }
  }

  void extrema() {
    const double h = design().edge_length;
    std::vector<int> vertices;
    for (int v = 0; v < surface().number_of_vertices(); ++v) vertices.push_back(v);
    int i = 0;
    for (int v : spread(vertices)) attempt("add extremum", Add_extremum{at(v), i++ % 2 == 0});
    std::vector<int> poles;
    std::array<int, 2> number{{0, 0}}; // of minima and of maxima: the last one of a kind has to stay
    for (const Design_extremum& e : design().extrema) {
      poles.push_back(e.vertex);
      ++number[e.is_maximum ? 1 : 0];
    }
    const auto is_last = [&](int v) {
      for (const Design_extremum& e : design().extrema)
        if (e.vertex == v) return number[e.is_maximum ? 1 : 0] == 1;
      return false;
    };
    for (int v : spread(poles)) {
      if (!is_last(v)) attempt("remove extremum", Remove_extremum{at(v)});
      if (const auto to = vertex_beside(v, h, 3 * h, i++ % 8))
        attempt("move extremum", Move_extremum{at(v), at(*to)});
    }
  }

  Editor& m_editor;
  const Options& m_options;
  std::map<std::string, Tally> m_tallies;
};

Edit globe_extrema(const Triangle_surface& s, int lobes) {
  Set_extrema edit;
  edit.extrema.push_back({{s.points.back(), int(s.points.size()) - 1}, false, -1});
  for (const Point& tip : globe::tips(lobes)) edit.extrema.push_back({{tip, -1}, true, -1});
  return edit;
}

// The largest component of a file, or a globe, and the edit that designs it.
Result<std::pair<Triangle_surface, Edit>> load(const std::string& model) {
  if (model.rfind("globe:", 0) == 0) {
    const int lobes = std::max(2, std::atoi(model.c_str() + 6));
    Triangle_surface s = globe::ball(lobes);
    if (const Result<void> connected = s.connect(); !connected) return connected.error();
    const Edit edit = globe_extrema(s, lobes);
    return std::make_pair(std::move(s), edit);
  }
  Result<Triangle_surface> surface = largest_component(model);
  if (!surface) return surface.error();
  return std::make_pair(std::move(*surface), Edit(Suggest{}));
}

Options read(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool has_value = i + 1 < argc;
    if (word == "-n" && has_value)
      options.tries = std::max(1, std::atoi(argv[++i]));
    else if (word == "-q" && has_value)
      options.quads = std::max(1, std::atoi(argv[++i]));
    else if (word == "-k" && has_value)
      options.word = argv[++i];
    else if (word == "--certify")
      options.certify = true;
    else if (word == "--offers")
      options.offers = true;
    else if (std::filesystem::is_directory(word)) {
      std::vector<std::string> files;
      for (const auto& entry : std::filesystem::directory_iterator(word))
        if (const std::string suffix = entry.path().extension(); suffix == ".obj" || suffix == ".off")
          files.push_back(entry.path().string());
      std::sort(files.begin(), files.end());
      options.models.insert(options.models.end(), files.begin(), files.end());
    } else
      options.models.push_back(word);
  }
  return options;
}

} // namespace

int main(int argc, char** argv) {
  const Options options = read(argc, argv);
  std::map<std::string, Tally> all;
  for (const std::string& model : options.models) {
    const std::string file = std::filesystem::path(model).filename().string();
    Result<std::pair<Triangle_surface, Edit>> loaded = load(model);
    if (!loaded) {
      std::cout << Json{{"model", file}, {"error", loaded.error().message}}.dump() << std::endl;
      continue;
    }
    Editor_options editor_options;
    editor_options.quads = options.quads;
    editor_options.threads = 1;
    Result<Editor> editor = Editor::create(std::move(loaded->first), editor_options);
    if (!editor) fail(editor.error());
    if (const Result<Edit_report> done = editor->apply(loaded->second); !done) {
      std::cout << Json{{"model", file}, {"error", done.error().message}}.dump() << std::endl;
      continue;
    }
    for (const auto& [kind, tally] : Trial(*editor, options).run()) {
      Json line{{"model", file}, {"edit", kind}};
      line.update(tally.json());
      std::cout << line.dump() << std::endl;
      all[kind].add(tally);
    }
  }
  for (const auto& [kind, tally] : all) {
    Json line{{"model", "all"}, {"edit", kind}};
    line.update(tally.json());
    std::cout << line.dump() << std::endl;
  }
  return 0;
}
