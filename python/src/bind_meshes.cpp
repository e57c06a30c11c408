// SPDX-License-Identifier: GPL-3.0-or-later
// Files of meshes, what is wrong with one, and the certificate of any.
#include "Python_observer.h"
#include "arrays.h"
#include "bind.h"
#include "options.h"

#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>
#include <CGAL/Reeb_quadrangulation/certificate.h>
#include <CGAL/Reeb_quadrangulation/mesh_statistics.h>
#include <CGAL/Reeb_quadrangulation/shapes.h>
#include <CGAL/Reeb_quadrangulation/surface_intersections.h>

#include <pybind11/stl.h>

namespace reebquad {
namespace python {

using namespace CGAL::Reeb_quadrangulation;

namespace {

py::tuple read_mesh(const std::string& path) {
  Python_observer observer{py::none()};
  std::vector<std::string> notes;
  const Polygon_soup soup =
      without_lock(observer, [&] { return read_polygon_soup(path, largest_mesh_file, &notes); });
  return py::make_tuple(to_array(soup.points), faces_of(soup), notes);
}

std::vector<std::string> write_faces(const std::string& path, const py::object& vertices,
                                     const py::list& faces, bool ascii, const std::string& comment) {
  Polygon_soup soup = soup_from(vertices, py::list());
  for (const py::handle& list : faces) {
    const Polygon_soup more = soup_from(vertices, py::reinterpret_borrow<py::object>(list));
    const int corners = int(soup.corner.size());
    soup.corner.insert(soup.corner.end(), more.corner.begin(), more.corner.end());
    for (std::size_t p = 1; p < more.begin.size(); ++p) soup.begin.push_back(corners + more.begin[p]);
  }
  if (comment.find_first_of("\r\n") != std::string::npos) refuse("the comment is one line");
  Write_options options;
  options.ascii = ascii;
  options.comment = comment;
  if (format_of_extension(path) == Mesh_format::automatic)
    throw Failed(
        make_error(Error_code::unsupported_format,
                   path + ": the extension is not one of obj, off, ply, vtk, vtu, inp, msh, stl, glb"));
  Python_observer observer{py::none()};
  return without_lock(observer, [&] { return write_mesh(path, soup, options); });
}

struct Findings {
  Surface_check check;
  Mended_surface mended;
  Surface_intersections intersections;
};

Result<Findings> findings(const Polygon_soup& soup, const Mend_options& mending,
                          const Check_options& options) {
  Findings found;
  found.check = check_surface(soup, options);
  Result<Mended_surface> mended = mend_surface(soup, mending);
  if (mended)
    found.mended = std::move(*mended);
  else
    found.mended.refused = {mended.error()};
  Triangle_surface all;
  for (const Mended_component& component : found.mended.components) {
    const int first = all.number_of_vertices();
    all.points.insert(all.points.end(), component.surface.points.begin(), component.surface.points.end());
    for (const Triangle& t : component.surface.triangles)
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  found.intersections = surface_intersections(all);
  return found;
}

py::dict check_mesh(const py::object& vertices, const py::object& faces, const py::dict& given) {
  const Polygon_soup soup = soup_from(vertices, faces, Coordinates::any);
  Keywords keywords(given);
  Mend_options mending;
  Check_options options;
  keywords.read("listed_per_kind", options.listed_per_kind);
  read_mending(keywords, mending);
  keywords.end();
  options.weld = mending.weld;
  Python_observer observer{py::none()};
  const Findings found = without_lock(observer, [&] { return findings(soup, mending, options); });
  const Mended_surface& mended = found.mended;
  py::list mends, refused;
  for (const Mend& mend : mended.mends) mends.append(py::make_tuple(mend.count, mend.text));
  for (const Error& error : mended.refused)
    refused.append(py::make_tuple(error.message, name(error.element), error.index));
  py::dict out;
  out["check"] = to_json(found.check);
  out["mends"] = mends;
  out["refused"] = refused;
  out["components"] = mended.components.size();
  out["within"] = found.intersections.within;
  out["between"] = found.intersections.between;
  return out;
}

py::tuple certify_quads(const py::object& vertices, const py::object& quads, const py::object& reference,
                        const py::object& valences, const py::object& progress) {
  Quad_mesh mesh;
  mesh.points = points_from(vertices, "the vertices", Coordinates::any);
  mesh.quads = quads_of(soup_from(vertices, quads, Coordinates::any));
  Certificate_input input{mesh};
  Triangle_surface surface;
  if (!reference.is_none()) {
    const auto [points, faces] = reference.cast<std::pair<py::object, py::object>>();
    const Polygon_soup soup = soup_from(points, faces);
    surface.points = soup.points;
    surface.triangles = triangles_of(soup);
    input.input = &surface;
  }
  if (!valences.is_none()) input.predicted_valences = valences.cast<std::map<int, int>>();
  Python_observer observer(progress);
  Certificate_options options;
  options.observer = &observer;
  struct Measured {
    Certificate certificate;
    Mesh_statistics statistics;
  };
  const Measured measured = without_lock(observer, [&]() -> Result<Measured> {
    Measured result{certify(input, options), quad_statistics(mesh, input.input)};
    if (observer.cancelled()) return make_error(Error_code::cancelled, "cancelled");
    return result;
  });
  return py::make_tuple(to_json(measured.certificate), to_json(measured.statistics));
}

py::tuple shape(const std::string& name, int triangles) {
  Python_observer observer{py::none()};
  const Triangle_surface surface = without_lock(observer, [&] { return make_shape(name, triangles); });
  return py::make_tuple(to_array(surface.points), to_array(surface.triangles));
}

} // namespace

void bind_meshes(py::module_& module) {
  module.def("read_mesh", &read_mesh, py::arg("path"));
  module.def("write_mesh", &write_faces, py::arg("path"), py::arg("vertices"), py::arg("faces"),
             py::arg("ascii"), py::arg("comment"));
  module.def("check", &check_mesh, py::arg("vertices"), py::arg("faces"), py::arg("options"));
  module.def("certify", &certify_quads, py::arg("vertices"), py::arg("quads"), py::arg("reference"),
             py::arg("valences"), py::arg("progress"));
  module.def("make_shape", &shape, py::arg("name"), py::arg("triangles"));
}

} // namespace python
} // namespace reebquad
