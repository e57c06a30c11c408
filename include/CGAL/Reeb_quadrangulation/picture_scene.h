// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_PICTURE_SCENE_H
#define CGAL_REEB_QUADRANGULATION_PICTURE_SCENE_H

#include <CGAL/Reeb_quadrangulation/IO/polygon_soup.h>

#include <array>
#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_quadrangulation {

/// An opaque colour, sRGB, 0 to 255.
struct Colour {
  unsigned char r = 0, g = 0, b = 0;
};

inline bool operator==(const Colour& a, const Colour& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
}
inline bool operator!=(const Colour& a, const Colour& b) {
  return !(a == b);
}

/// Colours at equal distances; a parameter in [0, 1] is interpolated between the two nearest.
using Colour_map = std::vector<Colour>;

/// The colour at `t`, clamped to [0, 1]; grey where `t` is not a number. \pre `map` is not empty.
Colour colour_at(const Colour_map& map, double t);

/// Blue over sand to red, lightest in the middle: scalar fields.
Colour_map field_colours();

/// Dark red over yellow to green: element quality from worst to best.
Colour_map quality_colours();

/// Twelve soft colours that are easy to tell apart.
std::vector<Colour> chart_palette();

/// A segment in space, drawn as a round rod of constant width on the picture.
struct Scene_line {
  Point a, b;
  Colour colour;
  double width = 2; ///< in pixels
  double xray = 0;  ///< opacity where a face hides it, 0 (hidden) to 1 (drawn as if nothing were in front)
  double lift = 3;  ///< pixels towards the eye, so that lines that lie on the surface show
};

/// A ball of constant size on the picture.
struct Scene_dot {
  Point centre;
  Colour colour;
  double radius = 5; ///< in pixels
  double xray = 0;   ///< opacity where a face hides it
  double lift = 1;   ///< pixels towards the eye
};

/// One line of a legend: a dot of that colour and a text.
struct Legend_entry {
  Colour colour;
  std::string text;
};

/// What the colours mean. Drawn along the lower margin, from the left: title, colour bar (if `bar` is not
/// empty), entries.
struct Legend {
  std::string title;
  Colour_map bar;
  double low = 0, high = 1; ///< the values at the two ends of the bar
  std::vector<Legend_entry> entries;

  bool empty() const { return title.empty() && bar.empty() && entries.empty(); }
};

/// What a picture shows: faces with colours and drawn sides, lines, dots and a legend. A plain value.
///
/// Faces are triangles or quads; a triangle's last index is -1. A face's colour is, in this order: the colour
/// map at the interpolated scalar if `scalar` is given, its own colour, `surface_colour`. Faces, lines and
/// dots with a coordinate that is not finite (or above 1e150) are left out.
struct Scene {
  using Face = std::array<int, 4>;

  std::vector<Point> points;
  std::vector<Face> faces;
  std::vector<Colour> face_colours;            ///< empty, or one a face
  std::vector<Eigen::Vector3f> corner_normals; ///< empty (flat), or four a face; see `shade_smoothly()`
  Colour surface_colour{226, 218, 205};

  std::vector<unsigned char> drawn_sides; ///< empty, or one a face: bit i stands for the side after corner i
  Colour side_colour{52, 50, 56};
  double side_width = 1.1; ///< in pixels; sides fade where faces are smaller than a few widths

  std::vector<double> scalar; ///< empty, or one a point
  double scalar_low = 0, scalar_high = 1;
  Colour_map scalar_colours;
  int isolines =
      0; ///< number of equidistant values, strictly between low and high, whose level lines are drawn
  Colour isoline_colour{40, 38, 48};
  double isoline_width = 1.0; ///< in pixels

  std::vector<Scene_line> lines;
  std::vector<Scene_dot> dots;
  Legend legend;
};

/// Gives the scene corner normals: the mean normal, weighted by angle, of the faces around the corner's point
/// whose normals differ from the corner's face by less than `crease_angle` degrees. Zero gives flat faces,
/// with one normal for a whole quad. O(sum of squared valences).
void shade_smoothly(Scene& scene, double crease_angle = 40);

/// The surface in one colour, smoothly shaded. Base of the other scenes.
Scene surface_scene(const Triangle_surface& surface);

/// The field in colours with `isolines` level lines; the range is that of the finite values.
/// \pre one value a vertex
Scene scalar_scene(const Triangle_surface& surface, const std::vector<double>& field, int isolines = 30);

/// Regions (charts, components) in colours of `chart_palette()`; neighbours get different ones as far as
/// twelve colours go (greedy, in the order of the region numbers). Faces of region -1 stay in the surface's
/// colour. \pre one region a face
Scene face_colour_scene(const Triangle_surface& surface, const std::vector<int>& region);

/// How `quad_scene()` looks.
struct Quad_scene_options {
  bool smooth = true;    ///< smooth shading with creases, or one normal a quad
  bool legend = true;    ///< name the valences that occur and how often
  double dot_radius = 5; ///< in pixels; 0 draws no dots
  double dot_xray = 0;   ///< opacity of hidden dots
};

/// Quads in light clay with thin dark sides; extraordinary vertices as dots: green shades below valence 4,
/// blue shades above it, darker the further from 4 (the colours of figure 15 of the source paper). A boundary
/// vertex counts as regular with two quads.
Scene quad_scene(const Quad_mesh& mesh, const Quad_scene_options& options = {});
/// The same of a mesh that is not all quads; the legend counts its other polygons.
Scene quad_scene(const Polygon_soup& mesh, const Quad_scene_options& options = {});

/// Polygons with dark sides, smoothly shaded, in one colour or in one a polygon; those of more than four
/// sides as fans of triangles without the sides inside. \pre `colours` is empty or has one colour a polygon;
/// polygons have at least three sides
Scene polygon_scene(const Polygon_soup& mesh, const std::vector<Colour>& colours = {});

/// The colour of a vertex of that valence in `quad_scene()`. \pre `valence != 4`
Colour valence_colour(int valence);

/// Valence of each vertex; at the boundary the number of polygons plus two, so that regular is 4 everywhere.
/// Vertices without a polygon get 0.
std::vector<int> vertex_valences(const Quad_mesh& mesh);
std::vector<int> vertex_valences(const Polygon_soup& mesh);

/// Scaled Jacobian of each quad: the smallest over its corners of the sine of the corner's angle, measured
/// against the quad's mean normal; at most 1, negative for an inverted corner, 0 for a degenerate quad.
/// (Knupp's measure, as in the Verdict library's report.)
std::vector<double> scaled_jacobians(const Quad_mesh& mesh);

/// Quads coloured by scaled Jacobian from 0 to 1, inverted ones in magenta, with a legend.
Scene quality_scene(const Quad_mesh& mesh);

/// Adds a curve; with `closed` also the segment from the last to the first point.
void add_polyline(Scene& scene, const std::vector<Point>& points, Colour colour, double width = 2,
                  bool closed = false, double xray = 0);

/// Adds a graph that shows through the surface: balls at the nodes, rods along the arcs.
/// `node_colours` and `arc_colours` are empty (dark grey) or one an element. \pre sizes agree
void add_graph(Scene& scene, const std::vector<Point>& nodes, const std::vector<std::vector<Point>>& arcs,
               const std::vector<Colour>& node_colours = {}, const std::vector<Colour>& arc_colours = {});

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_PICTURE_SCENE_H
