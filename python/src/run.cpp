// SPDX-License-Identifier: GPL-3.0-or-later
#include "run.h"

#include "Mirror_output.h"
#include "components.h"

#include "automatic/components.h"

#include <CGAL/Reeb_quadrangulation/Surface_projector.h>
#include <CGAL/Reeb_quadrangulation/quad_parameters.h>
#include <CGAL/Reeb_quadrangulation/sized_quads.h>
#include <CGAL/Reeb_quadrangulation/surface_as_read.h>

#include <algorithm>

namespace reebquad {
namespace python {

using namespace CGAL::Reeb_quadrangulation;

namespace {

/// The weights of a triangle's corners at the point of it that is nearest.
Point barycentrics(const Point& a, const Point& b, const Point& c, const Point& p) {
  const Point normal = (b - a).cross(c - a);
  const double squared_area = normal.squaredNorm();
  if (!(squared_area > 0)) return Point::Constant(1.0 / 3);
  const Point weights((c - b).cross(p - b).dot(normal) / squared_area,
                      (a - c).cross(p - c).dot(normal) / squared_area,
                      (b - a).cross(p - a).dot(normal) / squared_area);
  const Point inside = weights.cwiseMax(0);
  return inside / inside.sum();
}

class Runner {
public:
  Runner(const Polygon_soup& soup, const Request& request, Python_observer& observer)
      : m_soup(soup), m_request(request), m_observer(observer) {}

  Result<Outcome> execute() {
    if (Result<void> mended = mend(); !mended) return mended.error();
    for (std::size_t c = 0; c < m_components.size(); ++c) {
      Result<Quadrangulation> quads = mesh(c);
      if (quads) {
        append(c, *quads);
        run().components[c].result = std::move(*quads);
      } else if (quads.error().code == Error_code::cancelled) {
        return quads.error();
      } else {
        note_failure(c, quads.error());
      }
    }
    if (Result<void> fine = decide(); !fine) return fine.error();
    measure();
    if (m_observer.cancelled()) return make_error(Error_code::cancelled, "cancelled");
    collect_warnings();
    return std::move(m_outcome);
  }

private:
  Run& run() { return m_outcome.run; }

  Result<void> mend() {
    run().input_points = m_soup.number_of_points();
    run().input_faces = m_soup.number_of_polygons();
    Result<Mended_surface> mended = mend_surface(m_soup, m_request.options.mending);
    if (!mended) return mended.error();
    m_options = deal(m_request.options.pipeline, mended->components);
    if (Result<void> found = deal_features(m_request, m_soup, mended->components, m_options); !found)
      return found;
    if (Result<void> chosen = choose(*mended); !chosen) return chosen;
    if (m_request.options.pipeline.mirror && mended->components.size() > 1)
      return make_error(Error_code::impossible_request, "a mirror is for one component, this mesh has " +
                                                            std::to_string(mended->components.size()) +
                                                            "; component says which");
    run().mends = std::move(mended->mends);
    run().refused = std::move(mended->refused);
    m_components = std::move(mended->components);
    for (const Mended_component& component : m_components)
      run().components.push_back({component.surface, std::nullopt, {}, {}});
    return {};
  }

  /// Leaves only the component that is asked for, if one is; of a mesh of which one is, the others are not
  /// missed.
  Result<void> choose(Mended_surface& mended) {
    const std::size_t asked = std::size_t(m_request.options.component), number = mended.components.size();
    if (Result<void> left = internal::leave_component(mended, int(asked), "mesh"); !left) return left;
    for (std::size_t c = 1; c <= number; ++c)
      if (asked == 0 || c == asked) m_outcome.component_number.push_back(number > 1 ? int(c) : 0);
    if (asked == 0) {
      run().as_read = surface_as_read(m_soup, mended);
      return {};
    }
    run().as_read = mended.components[0].surface;
    m_options = deal(m_request.options.pipeline, mended.components);
    std::vector<Quadrangulation_options> with_features = m_options;
    // What is no edge of this component is one of another.
    (void)deal_features(m_request, m_soup, mended.components, with_features);
    m_options = std::move(with_features);
    return {};
  }

  Result<Quadrangulation> mesh(std::size_t c) {
    const Triangle_surface& surface = m_components[c].surface;
    internal::Component_observer observer(m_observer, c, m_components.size());
    if (m_request.sizes.empty()) return quadrangulate(surface, m_options[c], &observer);
    const std::vector<double> sizes = sizes_of(m_request.sizes, m_soup, m_components[c]);
    const Surface_projector projector(surface);
    projector.build();
    const auto size = [&](const Point& p) {
      const Closest_point at = projector.closest(p);
      const Triangle& t = surface.triangles[std::size_t(at.face)];
      const Point weights = barycentrics(surface.points[std::size_t(t[0])], surface.points[std::size_t(t[1])],
                                         surface.points[std::size_t(t[2])], at.point);
      return weights.dot(Point(sizes[std::size_t(t[0])], sizes[std::size_t(t[1])], sizes[std::size_t(t[2])]));
    };
    return quadrangulate(surface, size, m_options[c], &observer);
  }

  void note_failure(std::size_t c, Error error) {
    if (m_components.size() > 1) error.message = "component " + std::to_string(c) + ": " + error.message;
    run().components[c].error = std::move(error);
  }

  std::vector<Error> left_out() {
    std::vector<Error> errors = run().refused;
    for (const Component_run& component : run().components)
      if (!component.error.message.empty()) errors.push_back(component.error);
    return errors;
  }

  Result<void> decide() {
    const std::vector<Error> errors = left_out();
    if (errors.empty()) return {};
    if (run().quads.quads.empty() || m_request.options.all_or_nothing) return errors.front();
    run().status = Exit_code::in_part;
    return {};
  }

  void append(std::size_t c, const Quadrangulation& result) {
    Run& all = run();
    const Triangle_surface& surface = m_components[c].surface;
    const int corner = int(all.surface.points.size()), first = int(all.quads.points.size());
    all.surface.points.insert(all.surface.points.end(), surface.points.begin(), surface.points.end());
    for (const Triangle& t : surface.triangles)
      all.surface.triangles.push_back({t[0] + corner, t[1] + corner, t[2] + corner});
    const Quad_mesh& mesh = result.mesh;
    all.quads.points.insert(all.quads.points.end(), mesh.points.begin(), mesh.points.end());
    for (const Quad& q : mesh.quads)
      all.quads.quads.push_back({q[0] + first, q[1] + first, q[2] + first, q[3] + first});
    for (const auto& [valence, number] : result.valences) m_predicted[valence] += number;
    m_outcome.component_of_quad.insert(m_outcome.component_of_quad.end(), mesh.quads.size(), int(c));
    m_outcome.chart_of_quad.insert(m_outcome.chart_of_quad.end(), result.chart_of_quad.begin(),
                                   result.chart_of_quad.end());
    append_uv(result);
    append_places(m_components[c], mesh);
  }

  void append_uv(const Quadrangulation& result) {
    const Result<std::vector<Quad_parameters>> parameters = quad_parameters(result);
    m_has_uv = m_has_uv && bool(parameters);
    if (!m_has_uv) {
      m_outcome.uv.clear();
      return;
    }
    for (const Quad_parameters& corners : *parameters) {
      std::array<double, 8> uv{};
      for (std::size_t i = 0; i < 4; ++i) {
        uv[2 * i] = corners[i].y();
        uv[2 * i + 1] = corners[i].x();
      }
      m_outcome.uv.push_back(uv);
    }
  }

  void append_places(const Mended_component& component, const Quad_mesh& mesh) {
    const Triangle_surface& surface = component.surface;
    const Surface_projector projector(surface);
    Places& places = m_outcome.places;
    int hint = -1;
    for (const Point& point : mesh.points) {
      const Closest_point at = projector.closest(point, hint);
      hint = at.face;
      const Triangle& t = surface.triangles[std::size_t(at.face)];
      places.face.push_back(component.face_of_triangle[std::size_t(at.face)]);
      places.points.push_back({component.point_of_vertex[std::size_t(t[0])],
                               component.point_of_vertex[std::size_t(t[1])],
                               component.point_of_vertex[std::size_t(t[2])]});
      places.weights.push_back(barycentrics(surface.points[std::size_t(t[0])],
                                            surface.points[std::size_t(t[1])],
                                            surface.points[std::size_t(t[2])], at.point));
    }
  }

  void measure() {
    Run& all = run();
    if (const Mirror_report* report = all.mirror_report())
      all.mirror = check_mirror(all.quads, report->mirror.plane, report->image);
    const bool mirrored = !all.mirror || is_kept(*all.mirror_report(), *all.mirror);
    if (!mirrored) all.status = Exit_code::certificate_failed;
    if (m_request.certify) {
      m_observer.progress("certificate", 0);
      Certificate_options options;
      options.observer = &m_observer;
      Certificate_input input{all.quads, &all.surface, m_predicted};
      input.as_read = &all.as_read;
      if (m_request.options.pipeline.edge_length == 0 && m_request.sizes.empty())
        input.quads_asked = m_request.options.pipeline.quads;
      all.certificate = certify(input, options);
      const Run_options& asked = m_request.options;
      const bool good = asked.validate ? all.certificate->valid_as_input : all.certificate->passed;
      if (!good || (asked.strict && !all.certificate->warnings.empty()))
        all.status = Exit_code::certificate_failed;
    }
    all.statistics = quad_statistics(all.quads);
    if (all.certificate && all.certificate->shape) add_shape(*all.statistics, *all.certificate->shape);
  }

  void collect_warnings() {
    if (run().mirror && !run().mirror->message.empty())
      m_outcome.warnings.push_back("mirror: " + run().mirror->message);
    for (const Mend& mend : run().mends) m_outcome.warnings.push_back(mend.text);
    for (const Error& error : left_out()) m_outcome.warnings.push_back("left out: " + error.message);
    if (run().certificate)
      for (const Shape_warning& warning : run().certificate->warnings)
        m_outcome.warnings.push_back(warning.text);
  }

  const Polygon_soup& m_soup;
  const Request& m_request;
  Python_observer& m_observer;
  std::vector<Mended_component> m_components;
  std::vector<Quadrangulation_options> m_options;
  std::map<int, int> m_predicted; ///< numbers of inner vertices by valence
  bool m_has_uv = true;
  Outcome m_outcome;
};

} // namespace

Result<Outcome> run(const Polygon_soup& soup, const Request& request, Python_observer& observer) {
  return Runner(soup, request, observer).execute();
}

} // namespace python
} // namespace reebquad
