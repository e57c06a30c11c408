// SPDX-License-Identifier: GPL-3.0-or-later
// Response times of edits, from the command to all touched charts mapped and meshed, beside a full rebuild
// and CHOLMOD's factorization and solve of the whole surface in the same run: JSON lines, wall seconds.
// Usage: bench_editor [shape [triangles [edits of each kind]]]
#include "bench_tools.h"

#include "keep_freed_memory.h"
#include <CGAL/Reeb_quadrangulation/shapes.h>

#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <tuple>

using namespace bench;
using Json = nlohmann::ordered_json;

namespace {

// The share of the surface in the charts that are new.
double touched(const Editor& editor, const Edit_report& report) {
  double faces = 0, all = 0;
  for (const auto& chart : editor.design().charts) {
    const double n = chart->chart->mesh.number_of_faces();
    all += n;
    const bool is_new = std::binary_search(report.new_charts.begin(), report.new_charts.end(), chart->id);
    if (is_new) faces += n;
  }
  return faces / all;
}

void measure(Editor& editor, const std::string& kind, int wanted, double rebuild, double cholmod,
             const std::function<Edit()>& make) {
  std::vector<double> seconds, shares;
  int refused = 0;
  while (int(seconds.size()) < wanted && refused < 40 * wanted) {
    const Edit edit = make();
    const double begin = now();
    const Result<Edit_report> done = editor.apply(edit);
    if (!done) {
      ++refused;
      continue;
    }
    editor.quads();
    seconds.push_back(now() - begin);
    shares.push_back(touched(editor, *done));
    editor.undo();
  }
  Json line{{"edit", kind}, {"edits", seconds.size()}, {"refused", refused}};
  if (!seconds.empty()) {
    line["median_seconds"] = median(seconds);
    line["longest_seconds"] = *std::max_element(seconds.begin(), seconds.end());
    line["median_touched_share"] = median(shares);
    line["of_rebuild"] = median(seconds) / rebuild;
    line["of_cholmod"] = median(seconds) / cholmod;
  }
  std::cout << line.dump() << std::endl;
}

// Seconds to design the surface from nothing: a session keeps its factorization.
double rebuild_seconds(const Triangle_surface& surface) {
  std::vector<double> seconds;
  for (int i = 0; i < 3; ++i) {
    Result<Editor> fresh = Editor::create(surface);
    if (!fresh) fail(fresh.error());
    const double begin = now();
    if (const Result<Edit_report> done = fresh->apply(Suggest{}); !done) fail(done.error());
    fresh->quads();
    seconds.push_back(now() - begin);
  }
  return median(seconds);
}

using Run = std::function<void(const char* kind, const std::function<Edit()>& make)>;

void run_layout_edits(Editor& editor, Random_elements& random, const Run& run) {
  run("subdivide_chart", [&] { return Subdivide_chart{random.vertex()}; });
  run("move_contour", [&] {
    const Surface_point c = random.contour(true);
    return Move_contour{c, c.point, random.direction(), {}, Enforcement::contour};
  });
  run("move_saddle", [&] {
    const Surface_point s = random.saddle();
    return Move_saddle{s, random.beside(s, 2)};
  });
  run("drag_contour", [&] { return Drag_contour{random.contour(true), random.vertex()}; });
  run("straighten_contour", [&] { return Straighten_contour{random.contour(true)}; });
  run("move_extremum", [&] {
    const Surface_point e = random.extremum();
    return Move_extremum{e, random.beside(e, 10), Edit_scope::chart};
  });
  run("add_extremum", [&] { return Add_extremum{random.vertex(), random.below(2) == 0}; });
  const int designed = editor.position();
  for (int tries = 0; tries < 100 && editor.position() < designed + 4; ++tries) // some that can go again
    (void)editor.apply(Add_extremum{random.vertex(), true});
  run("remove_extremum", [&] { return Remove_extremum{random.extremum()}; });
  while (editor.position() > designed) editor.undo();
  run("move_extremum on the whole surface", [&] {
    const Surface_point e = random.extremum();
    return Move_extremum{e, random.beside(e, 10), Edit_scope::surface};
  });
}

void run_chart_edits(Random_elements& random, const Run& run) {
  run("collapse_chart", [&] { return Collapse_chart{random.vertex()}; });
  run("split_saddle half", [&] { return Split_saddle{random.saddle(), Saddle_kind::half, {}, 0}; });
  run("split_saddle quarter", [&] { return Split_saddle{random.saddle(), Saddle_kind::quarter, {}, 0}; });
  run("split_pole half", [&] { return Split_pole{random.extremum(), Pole_kind::half, {}}; });
  run("move_corner", [&] { return Move_corner{random.extremum(), random.contour(true)}; });
  run("set_rows", [&] { return Set_rows{random.vertex(), 4 + int(random.below(20))}; });
  run("set_columns", [&] { return Set_columns{random.vertex(), 8 + 2 * int(random.below(20))}; });
  run("set_shift", [&] { return Set_shift{random.vertex(), 1 + int(random.below(5))}; });
  for (const auto& [kind, operation, scope] :
       {std::tuple{"insert_polychord", Texture_operator::insert_polychord, Edit_scope::chart},
        std::tuple{"insert_polychord through all charts", Texture_operator::insert_polychord,
                   Edit_scope::surface},
        std::tuple{"inset_quads", Texture_operator::inset_quads, Edit_scope::chart},
        std::tuple{"subdivide one chart", Texture_operator::subdivide, Edit_scope::chart}})
    run(kind, [&, o = operation, s = scope] { return Edit_texture{o, {random.vertex()}, 0.5, s}; });
  run("drag_vertices", [&] {
    const Surface_point p = random.vertex();
    return Drag_vertices{{p}, random.beside(p, 5), 0, Falloff::smooth, 2, 3};
  });
  run("fit_texture", [&] { return Fit_texture{random.vertex()}; }); // of a shape with sharp edges
  run("set_target", [&] { return Set_target{2000 + int(random.below(2000)), 0}; });
}

} // namespace

int main(int argc, char** argv) {
  internal::keep_freed_memory();
  const Arguments arguments = arguments_of(argc, argv);
  const Result<Triangle_surface> surface = make_shape(arguments.shape, arguments.triangles);
  if (!surface) fail(surface.error());
  Editor editor = suggested_session(*surface);
  const double rebuild = rebuild_seconds(*surface), cholmod = cholmod_seconds(editor.working_surface());
  std::cout << Json{{"shape", arguments.shape},
                    {"triangles", editor.working_surface().number_of_faces()},
                    {"charts", editor.design().charts.size()},
                    {"rebuild_seconds", rebuild},
                    {"cholmod_factor_and_solve_seconds", cholmod}}
                   .dump()
            << std::endl;
  Random_elements random(editor);
  const Run run = [&](const char* kind, const std::function<Edit()>& make) {
    measure(editor, kind, arguments.wanted, rebuild, cholmod, make);
  };
  run_layout_edits(editor, random, run);
  run_chart_edits(random, run);
}
