// SPDX-License-Identifier: GPL-3.0-or-later
// Draw every texture operator, before and after, and how T-junctions are resolved: SVG files in the folder
// given, or here.
#include <CGAL/Reeb_quadrangulation/Texture_edit.h>
#include <CGAL/Reeb_quadrangulation/t_junctions.h>

#include <fstream>
#include <iostream>

using namespace CGAL::Reeb_quadrangulation;

// A flat quad mesh as SVG, `x` units to the right. Vertices inside that have not four quads get a dot, holes
// are grey.
static std::string drawing(const Quad_mesh& mesh, const std::vector<char>& inside, double x, double height) {
  std::string out;
  const auto at = [&](int v) {
    return std::to_string(50 * (x + mesh.points[v].x())) + "," +
           std::to_string(50 * (height - mesh.points[v].y()));
  };
  std::vector<int> quads(mesh.points.size(), 0);
  for (const Quad& q : mesh.quads) {
    out += "<polygon fill='#f4f1e8' stroke='#333' stroke-width='1.5' points='";
    for (int v : q) {
      out += at(v) + " ";
      ++quads[v];
    }
    out += "'/>\n";
  }
  for (std::size_t v = 0; v < quads.size(); ++v)
    if (inside[v] && quads[v] != 4 && quads[v] > 0) {
      const char* colour = quads[v] == 2   ? "#7b3294"
                           : quads[v] == 3 ? "#1a9641"
                           : quads[v] == 5 ? "#d95f0e"
                                           : "#2166ac";
      const std::string p = at(int(v));
      const std::size_t comma = p.find(',');
      out += "<circle r='5' fill='" + std::string(colour) + "' cx='" + p.substr(0, comma) + "' cy='" +
             p.substr(comma + 1) + "'/>\n";
    }
  return out;
}

static bool write(const std::string& file, const std::string& body, double width, double height) {
  std::ofstream out(file);
  out << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='-5 -5 " << 50 * width + 10 << " "
      << 50 * height + 10 << "'>\n"
      << body << "</svg>\n";
  return bool(out);
}

static std::string drawing(const Quad_texture& texture, double x) {
  Quad_mesh mesh;
  for (std::size_t i = 0; i < texture.v.size(); ++i) mesh.points.emplace_back(texture.v[i], texture.u[i], 0);
  for (std::size_t f = 0; f < texture.quads.size(); ++f)
    if (!texture.is_hole(int(f))) mesh.quads.push_back(texture.quads[f]);
  std::vector<char> inside(mesh.points.size(), 1);
  for (int v : texture.sides[0]) inside[v] = 0;
  return drawing(mesh, inside, x, 4);
}

// Coarse quads below, finer ones above: `t[i]` T-junctions on the i-th coarse edge between them.
static bool draw_t_junctions(const std::string& file, const std::vector<int>& t) {
  const int n = int(t.size()), rows = 2;
  Quad_mesh mesh;
  std::vector<Hanging_edge> hanging;
  for (int i = 0; i < (rows + 1) * (n + 1); ++i) mesh.points.emplace_back(i % (n + 1), rows - i / (n + 1), 0);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < n; ++x) {
      const int a = (y + 1) * (n + 1) + x;
      mesh.quads.push_back({a, a + 1, a - n, a - n - 1});
    }
  std::vector<int> line{0};
  for (int x = 0; x < n; ++x) {
    Hanging_edge edge{x, 2, {}};
    for (int k = 1; k <= t[x]; ++k) {
      line.push_back(int(mesh.points.size()));
      edge.vertices.insert(edge.vertices.begin(), line.back());
      mesh.points.emplace_back(x + double(k) / (t[x] + 1), rows, 0);
    }
    hanging.push_back(edge);
    line.push_back(x + 1);
  }
  const int above = int(mesh.points.size());
  for (int v : line) mesh.points.emplace_back(mesh.points[v].x(), rows + 0.6, 0);
  for (int i = 0; i + 1 < int(line.size()); ++i)
    mesh.quads.push_back({line[i], line[i + 1], above + i + 1, above + i});
  T_junction_options options;
  options.may_end_on_boundary = false;
  const auto resolved = resolve_t_junctions(mesh, hanging, options);
  if (!resolved) return false;
  std::vector<char> none(mesh.points.size(), 0), extraordinary(resolved->mesh.points.size(), 0);
  for (int v : resolved->extraordinary) extraordinary[v] = 1;
  return write(file,
               drawing(mesh, none, 0, rows + 0.6) + drawing(resolved->mesh, extraordinary, n + 1, rows + 0.6),
               2 * n + 1, rows + 0.6);
}

int main(int argc, char** argv) {
  const std::string folder = argc > 1 ? std::string(argv[1]) + "/" : "";
  const Quad_texture grid = regular_disc_texture(4, 4, false), coarse = regular_disc_texture(2, 2, false);
  const auto doublet = edit_texture(grid, Insert_doublet{{1.1, 1.1}}),
             hole = edit_texture(grid, Delete_quads{{{1.5, 1.5}}});
  const auto fine = edit_texture(coarse, Subdivide_texture{});
  if (!doublet || !hole || !fine) return 1;
  Move_vertices move;
  move.vertices = {{2.1, 2.1}};
  move.dv = 0.5;
  move.du = 0.4;
  move.steps = 4;
  const auto moved = edit_texture(grid, move);
  if (!moved) return 1;
  const std::vector<std::pair<Quad_texture, Texture_edit>> edits{
      {coarse, Subdivide_texture{}},
      {fine->texture, Coarsen_texture{}},
      {grid, Insert_polychord{{1.5, 1.99}, 0.5}},
      {grid, Delete_polychord{{1.5, 1.99}, 0.5}},
      {grid, Inset_quads{{{1.5, 1.5}, {2.5, 1.5}, {1.5, 2.5}}, 0.5}},
      {grid, Open_quad{{1.5, 1.99}, {2.5, 1.99}, 0.5}},
      {grid, Close_quad{{1.1, 1.1}, 0.5}},
      {grid, Rotate_edge{{1.99, 2.5}, true}},
      {grid, Rotate_vertex{{2.1, 2.1}}},
      {grid, Insert_doublet{{1.1, 1.1}}},
      {doublet->texture, Remove_doublet{{1.49, 1.5}}},
      {grid, Delete_quads{{{1.5, 1.5}, {2.5, 1.5}}}},
      {hole->texture, Restore_quads{{{1.5, 1.5}}}},
      {grid, move},
      {moved->texture, Relax_vertices{{}, 20, {}}}};
  for (const auto& [texture, edit] : edits) {
    const auto after = edit_texture(texture, edit);
    if (!after) {
      std::cerr << name(edit) << ": " << after.error().message << "\n";
      return 1;
    }
    // The coarse grid is drawn as large as the others.
    auto scaled = [](Quad_texture t, bool small) {
      for (std::size_t i = 0; small && i < t.v.size(); ++i) {
        t.v[i] *= 2;
        t.u[i] *= 2;
      }
      return t;
    };
    const bool small = edit.index() < 2;
    if (!write(folder + "texture_" + name(edit) + ".svg",
               drawing(scaled(texture, small), 0) + drawing(scaled(after->texture, small), 5), 9, 4))
      return 1;
  }
  const bool drawn = draw_t_junctions(folder + "t_junctions_two_edges.svg", {0, 1, 1, 0}) &&
                     draw_t_junctions(folder + "t_junctions_one_edge.svg", {0, 2, 0}) &&
                     draw_t_junctions(folder + "t_junctions_nested.svg", {0, 6, 0}) &&
                     draw_t_junctions(folder + "t_junctions_row.svg", {1, 1, 1, 1, 1, 1}) &&
                     draw_t_junctions(folder + "t_junctions_odd.svg", {0, 3, 0, 1, 0});
  return drawn ? 0 : 1;
}
