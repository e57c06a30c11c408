// SPDX-License-Identifier: GPL-3.0-or-later
// reebquad run FILE -o QUADS: the whole pipeline from a file to certified quads.
#include "Run.h"
#include "Attributes.h"
#include "Guides_input.h"
#include "Guides_output.h"
#include "Input.h"
#include "Interruption.h"
#include "Mirror_output.h"
#include "Sizes_input.h"
#include "Sizes_output.h"
#include "Terminal_observer.h"

#include "automatic/components.h"
#include "base/stage_recorder.h"
#include "keep_freed_memory.h"
#include "surface/size_at.h"
#include <CGAL/Reeb_quadrangulation/IO/atomic_file.h>
#include <CGAL/Reeb_quadrangulation/IO/recipe.h>
#include <CGAL/Reeb_quadrangulation/surface_as_read.h>
#include <CGAL/Reeb_quadrangulation/transfer_mesh_attributes.h>

#include "view/Html_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <set>

namespace reebquad {

using namespace CGAL::Reeb_quadrangulation;

namespace {

class Runner {
public:
  explicit Runner(Run_options options)
      : m_options(std::move(options)), m_observer(options.quiet), m_recorder(&m_observer, own_stages()) {}

  Exit_code execute() {
    begin("reading");
    m_input = read_attributed_soup(m_options.input, &m_run.notes);
    end();
    m_run.input_points = m_input.soup.number_of_points();
    m_run.input_faces = m_input.soup.number_of_polygons();
    if (m_options.marks.any())
      m_options.pipeline.marks = read_marks(m_options.marks, m_options.input, m_input);
    if (!m_options.guides.empty()) m_options.pipeline.guides = read_guides(m_options.guides, m_input.soup);
    if (!m_options.sizes.empty()) m_sizes = read_sizes(m_options.sizes, m_input.soup);
    mend(m_input.soup);
    if (!m_options.attributes) m_input.attributes = {};
    if (m_input.attributes.empty()) m_input.soup = {}; // nobody asks again
    mesh_components();
    decide_status();
    if (m_run.is_written()) certify_all();
    write_outputs();
    return m_run.status;
  }

private:
  void begin(const std::string& stage) {
    if (interrupted()) throw Failure(Exit_code::interrupted, "interrupted; nothing is written");
    m_recorder.progress(stage, 0);
  }
  void end() { m_recorder.end(); }

  /// Those outside the components' own.
  static std::set<std::string> own_stages() {
    return {"reading",  "mending",     "certificate", "statistics",
            "pictures", "HTML report", "attributes",  "writing"};
  }

  /// A component is left out.
  void note_failure(const Error& error) {
    if (error.code == Error_code::cancelled)
      throw Failure(Exit_code::interrupted, "interrupted; nothing is written");
    if (m_failure == Exit_code::success) m_failure = exit_code(error.code);
  }

  void mend(const Polygon_soup& soup) {
    begin("mending");
    Result<Mended_surface> mended = mend_surface(soup, m_options.mending);
    end();
    if (!mended) {
      m_run.refused.push_back(mended.error());
    } else {
      take_component(*mended);
      // Of a file of which one component is asked for, the others are not missed.
      m_run.as_read = m_options.component > 0 ? joined(*mended) : surface_as_read(soup, *mended);
      m_run.mends = std::move(mended->mends);
      m_run.refused = std::move(mended->refused);
      for (Mended_component& component : mended->components)
        m_run.components.push_back({std::move(component.surface), std::nullopt, {}, {}});
    }
    for (const Error& error : m_run.refused) note_failure(error);
    m_observer.clear();
    if (m_options.quiet) return;
    for (const std::string& note : m_run.notes)
      std::cerr << "reebquad: " << m_options.input << ": " << note << '\n';
    for (const Mend& change : m_run.mends)
      std::cerr << "reebquad: " << m_options.input << ": " << change.text << '\n';
  }

  /// Leaves only the component that is asked for, if one is.
  void take_component(Mended_surface& mended) {
    const std::size_t number = mended.components.size();
    m_component = number > 1 ? m_options.component : 0;
    succeed_or_fail(internal::leave_component(mended, m_options.component, "file"), m_options.input);
    if (m_options.component > 0) return;
    if (number > 1 && !m_options.recipe.empty()) {
      throw Failure(Exit_code::usage, m_options.input +
                                          ": --write-recipe is for one component, this file has " +
                                          std::to_string(number) + "; --component says which");
    } else if (number > 1 && m_options.pipeline.mirror) {
      throw Failure(Exit_code::usage, m_options.input + ": --mirror is for one component, this file has " +
                                          std::to_string(number) + "; --component says which");
    }
  }

  void write_recipe() const {
    Recipe recipe = m_run.components[0].result->recipe;
    recipe.component = m_component;
    recipe.fill_holes = m_options.mending.fill_holes;
    const Uninterruptible whole;
    succeed_or_fail(write_file_atomically(m_options.recipe, to_json(recipe)), m_options.recipe);
  }

  void mesh_components() {
    if (m_options.all_or_nothing && m_failure != Exit_code::success) return;
    std::vector<const Triangle_surface*> surfaces;
    for (const Component_run& component : m_run.components) surfaces.push_back(&component.surface);
    const std::vector<Quadrangulation_options> options =
        internal::options_of_components(m_options.pipeline, surfaces);
    for (std::size_t c = 0; c < m_run.components.size(); ++c) {
      Component_run& component = m_run.components[c];
      internal::Component_observer observer(m_observer, c, m_run.components.size());
      Result<Quadrangulation> result = make_quads(component, options[c], observer);
      if (!result) {
        component.error = result.error();
        if (m_run.components.size() > 1)
          component.error.message = "component " + std::to_string(c) + ": " + component.error.message;
        note_failure(component.error);
        continue;
      }
      component.result = std::move(*result);
      append(component.surface, component.result->mesh);
    }
    warn_of_specks(options);
  }

  Result<Quadrangulation> make_quads(Component_run& component, const Quadrangulation_options& options,
                                     Observer& observer) const {
    if (!m_sizes) return quadrangulate(component.surface, options, &observer);
    component.sizes = m_sizes->on(component.surface);
    const Surface_projector projector(component.surface);
    const CGAL::Reeb_quadrangulation::internal::Size_at size(projector, component.sizes);
    Result<Quadrangulation> result = quadrangulate(component.surface, size, options, &observer);
    if (result) component.met_sizes = size_report(result->mesh, size);
    return result;
  }

  /// Every component has a least number of quads, whatever share of the quads it should get.
  void warn_of_specks(const std::vector<Quadrangulation_options>& options) {
    const int asked = m_options.pipeline.quads;
    const std::size_t quads = m_run.quads.quads.size();
    if (m_options.pipeline.edge_length > 0 || m_sizes || double(quads) < 1.25 * asked) return;
    std::size_t specks = 0, least = quads;
    for (std::size_t c = 0; c < m_run.components.size(); ++c) {
      const Component_run& component = m_run.components[c];
      if (!component.result || component.result->mesh.quads.size() < 2 * std::size_t(options[c].quads))
        continue;
      ++specks;
      least = std::min(least, component.result->mesh.quads.size());
    }
    if (specks == 0 || m_run.components.size() == 1 || m_options.quiet) return;
    m_observer.clear();
    std::cerr << "reebquad: " << m_options.input << ": warning: " << quads << " quads, " << asked
              << " asked: " << specks << (specks == 1 ? " component needs" : " components need")
              << " at least " << least << (specks == 1 ? "" : " each")
              << "; --drop-components-below leaves small ones out\n";
  }

  /// In part, if some components are left out and that is allowed; a failure, if nothing is left.
  void decide_status() {
    std::size_t meshed = 0;
    for (const Component_run& component : m_run.components) meshed += component.result.has_value();
    if (m_failure == Exit_code::success) return;
    m_run.status = meshed == 0 || m_options.all_or_nothing ? m_failure : Exit_code::in_part;
    m_observer.clear();
    if (m_run.status == Exit_code::in_part) return;
    for (const Error& error : left_out())
      std::cerr << "reebquad: " << sentence(m_options.input, error) << '\n';
  }

  std::vector<Error> left_out() const {
    std::vector<Error> errors = m_run.refused;
    for (const Component_run& component : m_run.components)
      if (!component.error.message.empty()) errors.push_back(component.error);
    return errors;
  }

  void append(const Triangle_surface& surface, const Quad_mesh& mesh) {
    const int first = int(m_run.quads.points.size()), corner = int(m_run.surface.points.size());
    m_run.surface.points.insert(m_run.surface.points.end(), surface.points.begin(), surface.points.end());
    for (const Triangle& t : surface.triangles)
      m_run.surface.triangles.push_back({t[0] + corner, t[1] + corner, t[2] + corner});
    m_run.quads.points.insert(m_run.quads.points.end(), mesh.points.begin(), mesh.points.end());
    for (const Quad& q : mesh.quads)
      m_run.quads.quads.push_back({q[0] + first, q[1] + first, q[2] + first, q[3] + first});
  }

  void certify_all() {
    std::map<int, int> predicted;
    for (const Component_run& component : m_run.components)
      if (component.result)
        for (const auto& [valence, number] : component.result->valences) predicted[valence] += number;
    Certificate_options options;
    options.observer = &m_observer;
    begin("certificate");
    Certificate_input input{m_run.quads, &m_run.surface, predicted};
    input.as_read = &m_run.as_read;
    if (m_options.pipeline.edge_length == 0 && !m_sizes) input.quads_asked = m_options.pipeline.quads;
    m_run.certificate = certify(input, options);
    end();
    begin("statistics");
    measure_marks();
    warn_of_guides();
    m_run.statistics = quad_statistics(m_run.quads);
    if (m_run.certificate->shape) add_shape(*m_run.statistics, *m_run.certificate->shape);
    end();
    if (interrupted()) throw Failure(Exit_code::interrupted, "interrupted; nothing is written");
    if (const Mirror_report* report = m_run.mirror_report())
      m_run.mirror = check_mirror(m_run.quads, report->mirror.plane, report->image);
    const bool mirrored = !m_run.mirror || is_kept(*m_run.mirror_report(), *m_run.mirror);
    const bool good = m_options.validate ? m_run.certificate->valid_as_input : m_run.certificate->passed;
    const bool warned = m_options.strict && !m_run.certificate->warnings.empty();
    if (!good || !mirrored || warned) m_run.status = Exit_code::certificate_failed;
  }

  void measure_marks() {
    const Marks& marks = m_options.pipeline.marks;
    if (marks.empty()) return;
    std::vector<const Marks_outcome*> outcomes;
    for (Component_run& component : m_run.components) {
      if (!component.result) continue;
      component.marks = marks_outcome(component.result->mesh, component.surface, marks,
                                      m_options.pipeline.features.feature_angle);
      outcomes.push_back(&*component.marks);
    }
    const std::string warning = marks_warning(outcomes, marks);
    m_observer.clear();
    if (!warning.empty() && !m_options.quiet)
      std::cerr << "reebquad: " << m_options.input << ": warning: " << warning << '\n';
  }

  void warn_of_guides() {
    for (const Component_run& component : m_run.components) {
      if (!component.result || m_options.quiet) continue;
      const std::string warning =
          guides_warning(component.result->guides, component.result->editor.design().edge_length);
      m_observer.clear();
      if (!warning.empty()) std::cerr << "reebquad: " << m_options.input << ": warning: " << warning << '\n';
    }
  }

  void write_outputs() {
    if (!m_options.thumbnail.empty() && (m_run.is_written() || !m_run.as_read.triangles.empty())) {
      begin("pictures");
      write_thumbnail(m_run, m_options);
      end();
    }
    if (m_run.certificate) {
      if (m_run.is_written() && !m_options.pictures.empty()) {
        begin("pictures");
        write_pictures(m_run, m_options);
        end();
      }
      if (m_run.is_written() && !m_options.html.empty()) {
        begin("HTML report");
        const std::string html = report_html(m_run, m_options);
        const Uninterruptible whole;
        succeed_or_fail(write_file_atomically(m_options.html, html), m_options.html);
        end();
      }
      if (m_run.is_written() && !m_options.recipe.empty()) write_recipe();
      if (m_run.is_written()) write_quads();
    }
    m_observer.clear();
    m_run.stages = m_recorder.finish();
    if (!m_options.report.empty()) {
      const Uninterruptible whole;
      succeed_or_fail(write_file_atomically(m_options.report, report_json(m_run, m_options)),
                      m_options.report);
    }
    if (m_run.certificate) print_outcome();
    if (m_options.timings) print_timings();
  }

  void write_quads() {
    const Polygon_soup quads = polygon_soup(m_run.quads);
    Mesh_attributes attributes = m_input.attributes;
    if (!attributes.empty()) {
      begin("attributes");
      attributes = transfer_mesh_attributes(m_input.soup, attributes, quads);
      end();
    }
    if (m_options.charts) add_charts(m_run.components, attributes);
    begin("writing");
    m_observer.clear();
    reebquad::write_quads(m_options.output, quads, attributes, m_options.quiet);
    end();
  }

  void print_outcome() const {
    if (!m_options.quiet) {
      std::cout << to_text(*m_run.certificate) << '\n' << to_text(*m_run.statistics);
      for (const Component_run& component : m_run.components) {
        if (component.marks) std::cout << marks_text(*component.marks);
        if (component.result) std::cout << guides_text(component.result->guides);
        if (component.met_sizes) std::cout << sizes_text(*component.met_sizes);
      }
    }
    if (m_run.mirror && !m_options.quiet) std::cout << mirror_text(*m_run.mirror_report(), *m_run.mirror);
    if (m_run.is_written()) {
      const std::size_t warnings = m_run.certificate->warnings.size();
      const char* note = warnings == 0 ? "" : warnings == 1 ? ", with a warning" : ", with warnings";
      if (!m_options.quiet) std::cout << "\ncertified: " << m_options.output << note << '\n';
      std::cout.flush();
      if (m_run.status == Exit_code::in_part) list_what_is_left_out();
      return;
    }
    std::cout.flush();
    print_failure();
    std::cerr << "reebquad: nothing is written to " << m_options.output << '\n';
  }

  // The first check that failed; with --strict the first warning otherwise.
  void print_failure() const {
    for (const Certificate_check& check : m_run.certificate->checks)
      if (check.status == Check_status::failed) {
        std::cerr << "reebquad: " << m_options.input << ": the certificate failed: " << check.name << ": "
                  << check.message << '\n';
        return;
      }
    if (m_run.mirror && !is_kept(*m_run.mirror_report(), *m_run.mirror))
      std::cerr << "reebquad: " << m_options.input
                << ": the quads do not equal their mirror image: " << m_run.mirror->message << '\n';
    else if (!m_run.certificate->warnings.empty())
      std::cerr << "reebquad: " << m_options.input
                << ": the shape is not kept: " << m_run.certificate->warnings.front().text << '\n';
  }

  void list_what_is_left_out() const {
    const std::vector<Error> errors = left_out();
    const std::size_t meshed = m_run.refused.size() + m_run.components.size() - errors.size();
    std::cerr << "reebquad: " << m_options.input << ": in part: " << meshed
              << (meshed == 1 ? " component is" : " components are") << " written, " << errors.size()
              << (errors.size() == 1 ? " is" : " are")
              << " left out (--all-or-nothing writes nothing then):\n";
    for (const Error& error : errors) std::cerr << "  " << error.message << '\n';
  }

  static void print_timings(const std::vector<Stage_time>& stages, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < std::min(last, stages.size()); ++i) {
      const Stage_time& stage = stages[i];
      std::fprintf(stderr, "  %-16s %8.3f s %8.3f s cpu %8.0f MB\n", stage.name.c_str(), stage.seconds,
                   stage.cpu_seconds, stage.peak_megabytes);
    }
  }

  void print_timings() const {
    std::cout.flush();
    constexpr std::size_t before_meshing = 2; // reading and mending
    print_timings(m_run.stages, 0, before_meshing);
    for (const Component_run& component : m_run.components)
      if (component.result) print_timings(component.result->stages, 0, component.result->stages.size());
    print_timings(m_run.stages, before_meshing, m_run.stages.size());
  }

  Run_options m_options;
  Attributed_soup m_input; ///< without its soup where it has no attributes
  Run m_run;
  std::optional<Given_sizes> m_sizes;       ///< if they are asked for
  int m_component = 0;                      ///< the one that is meshed, of several
  Exit_code m_failure = Exit_code::success; ///< of the first component that was refused or failed
  Terminal_observer m_observer;
  CGAL::Reeb_quadrangulation::internal::Stage_recorder m_recorder;
};

} // namespace

Exit_code execute_run(const Arguments& arguments) {
  const std::optional<Run_options> options = parse_run_options(arguments);
  if (!options) return Exit_code::success;
  require_writable_format(options->output);
  if (!options->html.empty()) value_or_fail(studio::html_text({}), options->html); // not every build can
  watch_for_interruption();
  CGAL::Reeb_quadrangulation::internal::keep_freed_memory();
  return Runner(*options).execute();
}

} // namespace reebquad
