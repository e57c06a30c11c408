// SPDX-License-Identifier: GPL-3.0-or-later
#include "tiny_surfaces.h"

#include <CGAL/Reeb_quadrangulation/render.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>

using namespace CGAL::Reeb_quadrangulation;

namespace {

struct Pixel {
  int r, g, b, a;
};

Pixel at(const Image& image, int x, int y) {
  const unsigned char* p = &image.rgba[(std::size_t(y) * image.width + x) * 4];
  return {p[0], p[1], p[2], p[3]};
}

Pixel centre(const Image& image) {
  return at(image, image.width / 2, image.height / 2);
}

bool is_white(const Pixel& p) {
  return p.r == 255 && p.g == 255 && p.b == 255 && p.a == 255;
}
bool is_reddish(const Pixel& p) {
  return p.r > 120 && p.g < p.r / 3 && p.b < p.r / 3;
}
bool is_bluish(const Pixel& p) {
  return p.b > 120 && p.r < p.b / 3 && p.g < p.b / 2;
}

int number_of_pixels_not_white(const Image& image) {
  int number = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) number += !is_white(at(image, x, y));
  return number;
}

constexpr Colour red{230, 10, 10}, blue{10, 10, 230}, black{0, 0, 0};

Camera from_above() {
  Camera c;
  c.direction = Point(0, 0, -1);
  c.field_of_view = 0;
  return c;
}

/// A square of side 2 at height z, seen from above from its front.
void add_square(Scene& scene, double z, Colour colour) {
  const int n = int(scene.points.size());
  for (const Point& p : {Point(-1, -1, z), Point(1, -1, z), Point(1, 1, z), Point(-1, 1, z)})
    scene.points.push_back(p);
  scene.faces.push_back({n, n + 1, n + 2, n + 3});
  scene.face_colours.push_back(colour);
}

Scene red_square() {
  Scene scene;
  add_square(scene, 0, red);
  return scene;
}

/// The six sides of a cube.
Quad_mesh quad_cube() {
  Quad_mesh cube;
  for (int i = 0; i < 8; ++i) cube.points.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  cube.quads = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return cube;
}

Quad_mesh quad_torus(int m, int n) {
  Quad_mesh mesh;
  mesh.points = tiny::torus(m, n).points;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j)
      mesh.quads.push_back(
          {i * n + j, (i + 1) % m * n + j, (i + 1) % m * n + (j + 1) % n, i * n + (j + 1) % n});
  return mesh;
}

std::vector<unsigned char> bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

} // namespace

TEST_CASE("An empty scene is the background") {
  const Image image = render(Scene(), Camera(), 40, 30);
  REQUIRE(image.rgba.size() == 40u * 30u * 4u);
  CHECK(number_of_pixels_not_white(image) == 0);
  Render_options options;
  options.background = blue;
  const Pixel p = centre(render(Scene(), Camera(), 40, 30, options));
  CHECK((p.r == 10 && p.g == 10 && p.b == 230 && p.a == 255));
  options.transparent = true;
  CHECK(centre(render(Scene(), Camera(), 40, 30, options)).a == 0);
}

TEST_CASE("A red face gives red pixels where it is and background where it is not") {
  const Image image = render(red_square(), from_above(), 120, 100);
  CHECK(is_reddish(centre(image)));
  CHECK(is_white(at(image, 1, 50)));
  CHECK(is_white(at(image, 118, 50)));
  // The square fills the height but for the margin of 3.5 % on both sides: 93 by 93 pixels.
  CHECK(number_of_pixels_not_white(image) >= 91 * 91);
  CHECK(number_of_pixels_not_white(image) <= 95 * 95);
}

TEST_CASE("Both triangles of a quad, and two triangles with a common side, leave no gap") {
  Scene halves = red_square();
  halves.faces = {{0, 1, 2, -1}, {0, 2, 3, -1}};
  halves.face_colours = {red, red};
  for (const Scene& scene : {red_square(), halves})
    for (const Point& direction : {Point(0, 0, -1), Point(0.3, 0.2, -1), Point(-0.7, 0.1, -0.4)}) {
      Camera camera;
      camera.direction = direction;
      Render_options options;
      options.transparent = true;
      const Image image = render(scene, camera, 97, 61, options);
      // On each row the covered pixels are one run: no pixel within is less than opaque.
      for (int y = 0; y < image.height; ++y) {
        int first = image.width, last = -1;
        for (int x = 0; x < image.width; ++x)
          if (at(image, x, y).a == 255) first = std::min(first, x), last = x;
        for (int x = first; x <= last; ++x) CHECK(at(image, x, y).a == 255);
      }
    }
}

TEST_CASE("The nearer of two faces is seen, in whatever order they are given") {
  for (const bool near_first : {true, false}) {
    Scene scene;
    add_square(scene, near_first ? 1 : 0, near_first ? red : blue);
    add_square(scene, near_first ? 0 : 1, near_first ? blue : red);
    CHECK(is_reddish(centre(render(scene, from_above(), 60, 60))));
    Camera below = from_above();
    below.direction = Point(0, 0, 1);
    const Pixel p = centre(render(scene, below, 60, 60)); // the blue square's back
    CHECK(p.b > 2 * p.r);
  }
}

TEST_CASE("A line that lies on a face is seen, one behind it is not, and x-ray vision shows it dimmed") {
  Scene scene = red_square();
  add_polyline(scene, {Point(-0.5, 0, 0), Point(0.5, 0, 0)}, black, 5);
  Render_options options;
  options.occlusion = 0;
  const Pixel on = centre(render(scene, from_above(), 101, 101, options));
  CHECK(on.r < 30);

  scene.lines.clear();
  add_polyline(scene, {Point(-0.5, 0, -1), Point(0.5, 0, -1)}, black, 5);
  const Pixel hidden = centre(render(scene, from_above(), 101, 101, options));
  CHECK(is_reddish(hidden));

  scene.lines[0].xray = 0.5;
  const Pixel dimmed = centre(render(scene, from_above(), 101, 101, options));
  CHECK(dimmed.r < hidden.r * 0.6);
  CHECK(dimmed.r > hidden.r * 0.4);
}

TEST_CASE("A dot has its colour and its radius") {
  Scene scene = red_square();
  scene.dots.push_back({Point(0, 0, 0), blue, 10});
  const Image image = render(scene, from_above(), 101, 101);
  CHECK(is_bluish(centre(image)));
  CHECK(is_bluish(at(image, 50 + 8, 50)));
  CHECK(is_reddish(at(image, 50 + 12, 50)));
  CHECK(is_reddish(at(image, 50, 50 - 12)));
}

TEST_CASE("The drawn sides of a face are dark and the others are not") {
  Scene scene = red_square();
  scene.drawn_sides = {1}; // the lower side
  scene.side_width = 4;
  const Image image = render(scene, from_above(), 100, 100);
  CHECK(at(image, 50, 95).r < 100); // the square ends at 96.5
  CHECK(is_reddish(at(image, 50, 5)));
  CHECK(is_reddish(at(image, 5, 50)));
  CHECK(is_reddish(centre(image)));
}

TEST_CASE("Isolines lie where the field takes their values") {
  Scene scene = red_square();
  scene.face_colours.clear();
  scene.scalar = {0, 1, 1, 0}; // grows from left to right
  scene.scalar_colours = {{255, 255, 255}};
  scene.isolines = 3;
  scene.isoline_width = 2;
  const Image image = render(scene, from_above(), 200, 200);
  // The square spans 7 to 193; the lines are at its quarters, and between them it is light.
  for (const int x : {53, 100, 146}) CHECK(std::min(at(image, x - 1, 60).r, at(image, x, 60).r) < 110);
  for (const int x : {20, 76, 123, 180}) CHECK(at(image, x, 60).r > 180);
}

TEST_CASE("The same scene gives the same bytes, and a picture survives its way to a file") {
  const Scene scene = quad_scene(quad_torus(12, 8));
  const Image first = render(scene, camera(View::three_quarter), 160, 120);
  CHECK(first.rgba == render(scene, camera(View::three_quarter), 160, 120).rgba);
  const auto png = encode_png(first);
  REQUIRE(png.size() > 100);
  CHECK(png == encode_png(first));
  CHECK((png[0] == 0x89 && png[1] == 'P' && png[2] == 'N' && png[3] == 'G'));
  const std::string path = "test_pictures_written.png";
  REQUIRE(bool(write_png(first, path)));
  CHECK(bytes_of(path) == png);
  std::remove(path.c_str());
  const auto refused = write_png(first, "no_such_folder/picture.png");
  REQUIRE_FALSE(bool(refused));
  CHECK(refused.error().code == Error_code::unwritable_file);
}

TEST_CASE("The picture depends on the shape, not on its size or place") {
  Quad_mesh mesh = quad_torus(12, 8);
  const Image image = render(quad_scene(mesh), camera(View::three_quarter), 120, 90);
  for (Point& p : mesh.points) p = 1024 * p + Point(4096, -4096, 8192); // exact: powers of two
  const Image moved = render(quad_scene(mesh), camera(View::three_quarter), 120, 90);
  int different = 0;
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    different += std::abs(image.rgba[i] - moved.rgba[i]) > 8;
  CHECK(different < int(image.rgba.size() / 200));
}

TEST_CASE("Degenerate and non-finite input is left out and the rest is drawn") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  Scene scene = red_square();
  const Image clean = render(scene, from_above(), 80, 80);
  for (const Point& bad : {Point(nan, 0, 0), Point(0, inf, 0), Point(0, 0, -inf), Point(1e300, 0, 0)}) {
    Scene dirty = scene;
    dirty.points.push_back(bad);
    dirty.faces.push_back({0, 1, 4, -1});
    dirty.faces.push_back({0, 1, 2, 4});
    dirty.face_colours.insert(dirty.face_colours.end(), 2, blue);
    dirty.lines.push_back({Point(0, 0, 0), bad, blue});
    dirty.dots.push_back({bad, blue});
    CHECK(render(dirty, from_above(), 80, 80).rgba == clean.rgba);
  }
  scene.faces.push_back({0, 0, 1, -1});
  scene.faces.push_back({2, 2, 2, 2});
  scene.face_colours.insert(scene.face_colours.end(), 2, blue);
  CHECK(render(scene, from_above(), 80, 80).rgba == clean.rgba);

  Scene point;
  point.dots.push_back({Point(3, 4, 5), blue, 6});
  CHECK(is_bluish(centre(render(point, Camera(), 50, 50))));

  Camera odd;
  odd.direction = Point(0, 0, 0);
  odd.up = Point(nan, 0, 0);
  CHECK(number_of_pixels_not_white(render(red_square(), odd, 40, 40)) > 0);
  odd.direction = Point(0, 1, 0); // along up
  odd.up = Point(0, 2, 0);
  CHECK(number_of_pixels_not_white(render(quad_scene(quad_cube()), odd, 40, 40)) > 0);

  Triangle_surface surface = tiny::octahedron();
  const std::vector<double> field{0, nan, 1, inf, -inf, 2};
  const Scene fielded = scalar_scene(surface, field, 10);
  CHECK(fielded.scalar_low == 0);
  CHECK(fielded.scalar_high == 2);
  CHECK(number_of_pixels_not_white(render(fielded, Camera(), 60, 60)) > 500);
}

TEST_CASE("A vertex's valence is the number of its quads, and a regular boundary counts as regular") {
  const auto cube = vertex_valences(quad_cube());
  CHECK(std::all_of(cube.begin(), cube.end(), [](int v) { return v == 3; }));
  const auto torus = vertex_valences(quad_torus(5, 4));
  CHECK(std::all_of(torus.begin(), torus.end(), [](int v) { return v == 4; }));
  Quad_mesh strip; // two quads side by side, and a point without a quad
  strip.points = {Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0), Point(0, 1, 0),
                  Point(1, 1, 0), Point(2, 1, 0), Point(9, 9, 9)};
  strip.quads = {{0, 1, 4, 3}, {1, 2, 5, 4}};
  CHECK(vertex_valences(strip) == std::vector<int>{3, 4, 3, 3, 4, 3, 0});
  CHECK(quad_scene(quad_cube()).dots.size() == 8);
  CHECK(quad_scene(quad_torus(5, 4)).dots.empty());
  CHECK(quad_scene(strip).dots.size() == 4);
}

TEST_CASE("A legend that is wider than the picture shrinks to fit") {
  Scene scene;
  for (int i = 0; i < 9; ++i) scene.legend.entries.push_back({black, "a long name of a colour"});
  const Image image = render(scene, Camera(), 300, 200);
  int last = 0, number = 0;
  for (int x = 0; x < image.width; ++x)
    for (int y = 0; y < image.height; ++y)
      if (!is_white(at(image, x, y))) last = x, ++number;
  CHECK(number > 100);
  CHECK(last > 280);
  CHECK(last < 296);
}

TEST_CASE("Low valences are green and high ones blue") {
  for (const int v : {1, 2, 3}) CHECK(valence_colour(v).g > valence_colour(v).b);
  for (const int v : {5, 6, 7, 8, 40}) CHECK(valence_colour(v).b > valence_colour(v).g);
  CHECK(valence_colour(5) != valence_colour(6));
}

TEST_CASE(
    "The scaled Jacobian is 1 on squares, the sine on rhombi, 0 on slivers and negative on arrowheads") {
  Quad_mesh mesh;
  const double s = 0.5, c = std::sqrt(3.0) / 2;
  mesh.points = {Point(0, 0, 0),     Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0),
                 Point(1 + c, s, 0), Point(c, s, 0), Point(2, 0, 0), Point(0.2, 0.2, 0)};
  mesh.quads = {{0, 1, 2, 3}, {0, 1, 4, 5}, {0, 1, 6, 6}, {0, 1, 7, 3}};
  const auto jacobian = scaled_jacobians(mesh);
  CHECK(jacobian[0] == Approx(1));
  CHECK(jacobian[1] == Approx(0.5));
  CHECK(jacobian[2] == Approx(0).margin(1e-12));
  CHECK(jacobian[3] < 0);
  const Scene scene = quality_scene(mesh);
  CHECK(scene.face_colours[2] == scene.face_colours[3]);
  CHECK(scene.face_colours[0] == quality_colours().back());
  REQUIRE(scene.legend.entries.size() == 1);
}

TEST_CASE("Neighbouring regions get different colours") {
  const Triangle_surface torus = tiny::torus(12, 9);
  std::vector<int> region(torus.triangles.size());
  for (int f = 0; f < torus.number_of_faces(); ++f)
    region[f] = (f / 18 / 2) * 7 + 3; // six rings, numbered with gaps
  region[5] = -1;
  const Scene scene = face_colour_scene(torus, region);
  CHECK(scene.face_colours[5] == scene.surface_colour);
  for (int h = 0; h < torus.number_of_halfedges(); ++h) {
    const int f = h / 3, g = torus.opposite[h] / 3;
    if (region[f] >= 0 && region[g] >= 0)
      CHECK((scene.face_colours[f] == scene.face_colours[g]) == (region[f] == region[g]));
  }
}

TEST_CASE("Smooth shading follows round shapes and stops at creases") {
  Scene cube = quad_scene(quad_cube());
  shade_smoothly(cube, 40);
  for (int f = 0; f < 6; ++f)
    for (int i = 1; i < 4; ++i)
      CHECK((cube.corner_normals[4 * f + i] - cube.corner_normals[4 * f]).norm() < 1e-6f);
  Scene torus = quad_scene(quad_torus(24, 16));
  const auto& faces = torus.faces;
  shade_smoothly(torus, 40);
  std::vector<Eigen::Vector3f> normal(torus.points.size(), Eigen::Vector3f::Zero());
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (int i = 0; i < 4; ++i) {
      Eigen::Vector3f& n = normal[faces[f][i]];
      if (n.norm() > 0) CHECK((n - torus.corner_normals[4 * f + i]).norm() < 1e-5f);
      n = torus.corner_normals[4 * f + i];
    }
}

TEST_CASE("A graph inside a surface shines through it") {
  Scene scene = surface_scene(tiny::octahedron());
  const Image bare = render(scene, Camera(), 90, 90);
  add_graph(scene, {Point(0, 0, -0.2), Point(0.2, 0, 0)}, {{Point(0, 0, -0.2), Point(0.2, 0, 0)}},
            {blue, blue}, {red});
  CHECK(scene.dots.size() == 2);
  CHECK(scene.lines.size() == 1);
  const Pixel with = centre(render(scene, Camera(), 90, 90)), without = centre(bare);
  CHECK(with.r < without.r / 2);
  CHECK(with.b > with.r);
}

TEST_CASE("A histogram's bars are as high as their bins") {
  Histogram histogram;
  histogram.bins = {0, 1, 4, std::numeric_limits<double>::quiet_NaN(), -3};
  histogram.title = "Title";
  histogram.x_label = "value";
  histogram.note = "first\nsecond";
  const Image image = histogram_image(histogram, 500, 300);
  std::vector<int> height(5, 0);
  for (int bin = 0; bin < 5; ++bin) {
    const double left = 4.2 * 15, right = 500 - 1.6 * 15; // 15 is the text's height
    const int x = int(left + (right - left) * (bin + 0.5) / 5);
    for (int y = 0; y < image.height; ++y) {
      const Pixel p = at(image, x, y);
      height[bin] += p.b > p.r + 60;
    }
  }
  CHECK(height[0] == 0);
  CHECK(height[3] == 0);
  CHECK(height[4] == 0);
  CHECK(height[1] > 20);
  CHECK(std::abs(height[2] - 4 * height[1]) <= 5);
  CHECK(histogram_image(Histogram()).rgba.size() == 640u * 400u * 4u);
  CHECK(histogram_image(histogram, 3, 2).rgba.size() == 24u);
}

TEST_CASE("Any direction points up on the picture, and the four views stand around it") {
  for (const Point& up : {Point(0, 0, 2), Point(0, -1, 0), Point(3, 1, -1), Point(-1e200, 2e200, 1e200)}) {
    const Point unit = up.stableNormalized();
    const Camera front = camera(View::front, up), side = camera(View::side, up),
                 back = camera(View::back, up), oblique = camera(View::three_quarter, up);
    for (const Camera& c : {front, side, back, oblique}) CHECK((c.up - unit).norm() < 1e-12);
    CHECK(std::abs(front.direction.dot(unit)) < 1e-12);
    CHECK((front.direction + back.direction).norm() < 1e-12);
    // To the right of the front view: the eye went right, so the line of sight points left.
    CHECK((side.direction + front.direction.cross(unit)).norm() < 1e-12);
    CHECK(oblique.direction.dot(unit) < 0);
  }
  const Camera by_axis = camera(View::three_quarter, Up_axis::z),
               by_direction = camera(View::three_quarter, Point(0, 0, 5));
  CHECK((by_axis.direction == by_direction.direction && by_axis.up == by_direction.up));
}

TEST_CASE("A contact sheet holds four views that differ, and composing keeps the pictures") {
  Scene scene = quad_scene(quad_cube());
  scene.points[7] *= 1.7;
  const Image sheet = contact_sheet(scene, Up_axis::z, 200, 170);
  REQUIRE(sheet.width == 200);
  REQUIRE(sheet.height == 170);
  const auto part = [&](int left, int top) {
    std::vector<unsigned char> pixels;
    for (int y = top; y < top + 50; ++y)
      for (int x = left; x < left + 100; ++x) pixels.push_back((unsigned char)at(sheet, x, y).r);
    return pixels;
  };
  const auto is_empty = [](const std::vector<unsigned char>& p) {
    return std::all_of(p.begin(), p.end(), [](unsigned char v) { return v == 255; });
  };
  std::vector<std::vector<unsigned char>> views{part(0, 0), part(100, 0), part(0, 76), part(100, 76)};
  for (const auto& view : views) CHECK_FALSE(is_empty(view));
  std::sort(views.begin(), views.end());
  CHECK(std::adjacent_find(views.begin(), views.end()) == views.end());
  const Image one = render(red_square(), from_above(), 30, 20), two = render(Scene(), Camera(), 10, 40);
  const Image both = compose({one, two}, 2, 4);
  CHECK(both.width == 64);
  CHECK(both.height == 40);
  CHECK(is_reddish(at(both, 15, 20)));
  CHECK(is_white(at(both, 49, 20)));
}
