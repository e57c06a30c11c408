// SPDX-License-Identifier: GPL-3.0-or-later
#include "Session.h"

#include "Edit_text.h"
#include "Html_report.h"

#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>
#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include <chrono>

namespace reebquad {
namespace studio {

using namespace CGAL::Reeb_quadrangulation;

namespace {

constexpr std::uint64_t largest_mesh = std::uint64_t(4) << 30;
constexpr int defects_listed_per_kind = 30;

class Stopwatch {
public:
  double milliseconds() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - m_start).count();
  }

private:
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

/// For work that nobody waits for: it can be stopped, but shows no progress.
class Quiet_observer : public Observer {
public:
  explicit Quiet_observer(const Observer& observer) : m_observer(observer) {}
  void progress(const std::string&, double) override {}
  bool cancelled() const override { return m_observer.cancelled(); }

private:
  const Observer& m_observer;
};

Error no_mesh() {
  return make_error(Error_code::impossible_request, "open a mesh first");
}

Json json_point(const Point& p) {
  return Json{p.x(), p.y(), p.z()};
}

/// Where the file is not a clean surface, relative to `origin`.
Json defects(const Polygon_soup& soup, const Point& origin) {
  Check_options options;
  options.listed_per_kind = defects_listed_per_kind;
  const Surface_check check = check_surface(soup, options);
  Json list = Json::array();
  for (const Defect& defect : check.defects)
    if (defect.where.allFinite())
      list.push_back(
          {{"kind", name(defect.kind)}, {"text", defect.text}, {"where", json_point(defect.where - origin)}});
  return list;
}

} // namespace

Session::Session(const Folder& folder) : m_folder(folder), m_store(folder) {}

Result<void> Session::open_file(const std::string& name, Observer& observer) {
  observer.progress("reading", 0);
  Result<std::string> path = m_folder.resolve(name);
  if (!path) return path.error();
  Result<std::string> bytes = read_file(*path, largest_mesh);
  if (!bytes) return make_error(bytes.error().code, name + ": " + bytes.error().message);
  Saved_session origin;
  origin.name = origin.file = name;
  return open(std::move(origin), *bytes, observer);
}

Result<void> Session::open_upload(const std::string& name, const std::string& bytes, Observer& observer) {
  Saved_session origin;
  origin.name = name;
  return open(std::move(origin), bytes, observer);
}

Result<void> Session::open(Saved_session origin, const std::string& bytes, Observer& observer) {
  const Stopwatch watch;
  observer.progress("reading", 0.2);
  Result<Polygon_soup> soup =
      parse_polygon_soup(bytes.data(), bytes.size(), format_of_extension(origin.name));
  if (!soup) return make_error(soup.error().code, origin.name + ": " + soup.error().message);
  observer.progress("checking", 0.4);
  Result<Mended_surface> mended = mend_surface(*soup);
  if (!mended) return make_error(mended.error().code, origin.name + ": " + mended.error().message);
  if (observer.cancelled()) return make_error(Error_code::cancelled, "cancelled");
  // The largest component is worked on; `file.components` tells the page that there are others.
  std::size_t largest = 0;
  for (std::size_t i = 1; i < mended->components.size(); ++i)
    if (mended->components[i].surface.triangles.size() > mended->components[largest].surface.triangles.size())
      largest = i;
  observer.progress("preparing", 0.6);
  Result<std::unique_ptr<Workpiece>> work =
      Workpiece::create(std::move(mended->components[largest].surface), &observer);
  if (!work) return work.error();
  if (observer.cancelled()) return make_error(Error_code::cancelled, "cancelled");

  const Triangle_surface& surface = (*work)->surface();
  origin.bytes = bytes.size();
  origin.digest = digest(bytes);
  if (origin.file.empty())
    if (Result<void> kept = m_store.save_upload(origin, bytes); !kept) return kept;
  m_work = std::move(*work);
  m_saved = std::move(origin);
  m_milliseconds.clear();
  Eigen::AlignedBox3d box;
  for (const Point& p : surface.points) box.extend(p);
  const int loops = int(boundary_loops(surface).size());
  const int chi = euler_characteristic(surface);
  Json mends = Json::array(), refused = Json::array();
  for (const Mend& mend : mended->mends) mends.push_back(mend.text);
  for (const Error& error : mended->refused) refused.push_back(error.message);
  m_file = {{"name", m_saved.name},
            {"points", surface.number_of_vertices()},
            {"triangles", surface.number_of_faces()},
            {"euler_characteristic", chi},
            {"genus", (2 - chi - loops) / 2},
            {"boundary_loops", loops},
            {"components", mended->components.size() + mended->refused.size()},
            {"mends", mends},
            {"refused", refused},
            {"origin", json_point(middle(surface))},
            {"diagonal", box.diagonal().norm()},
            {"defects", defects(*soup, middle(surface))}};
  changed(watch.milliseconds(), "opened " + m_saved.name);
  return {};
}

Result<void> Session::restore(Observer& observer) {
  const std::optional<Saved_session> last = m_store.load();
  if (!last) return make_error(Error_code::unreadable_file, "there is no earlier session in this folder");
  Result<std::string> bytes = m_store.load_mesh(*last);
  if (!bytes) return bytes.error();
  Session restored(m_folder);
  Saved_session origin = *last;
  origin.edits = Json::array();
  origin.applied = 0;
  if (Result<void> opened = restored.open(std::move(origin), *bytes, observer); !opened) return opened;
  for (const Json& edit : last->edits)
    if (Result<Json> done = restored.edit(edit, observer); !done) {
      // What could be repeated is worth more than nothing; the sentence says where it ended.
      restored.m_last = {{"ok", false},
                         {"text", "restored up to an edit that is refused now: " + done.error().message}};
      *this = std::move(restored);
      return {};
    }
  if (Result<void> there = restored.go_to(last->applied); !there) return there;
  const std::int64_t revision = m_revision + restored.m_revision;
  *this = std::move(restored);
  m_revision = revision;
  m_last = {{"ok", true}, {"text", "the last session is back"}};
  return {};
}

void Session::forget() {
  m_store.forget();
}

Result<Json> Session::edit(const Json& edit, Observer& observer, std::int64_t drag, bool live) {
  if (!m_work) return no_mesh();
  const Stopwatch watch;
  const bool replaces = drag > 0 && drag == m_drag;
  if (replaces)
    if (Result<void> undone = m_work->undo(); !undone) return undone.error();
  Result<Json> done = m_work->apply(edit, &observer, live);
  if (!done) {
    // The edit before is back, unless this one was stopped when it had taken its place already.
    if (replaces && !m_work->redo()) changed(watch.milliseconds(), "stopped dragging");
    return done;
  }
  m_milliseconds.resize(std::size_t(m_work->applied() - 1), 0);
  m_milliseconds.push_back(watch.milliseconds());
  changed(m_milliseconds.back(), edit_text(edit), !live);
  m_drag = drag;
  return done;
}

Result<Json> Session::preview(const Json& edit, Observer& observer) const {
  if (!m_work) return no_mesh();
  return m_work->preview(edit, &observer);
}

Result<Json> Session::hints(Observer& observer) const {
  if (!m_work) return no_mesh();
  Quiet_observer quiet(observer);
  return m_work->hints(&quiet);
}

Result<void> Session::step(bool forward) {
  return forward ? m_work->redo() : m_work->undo();
}

Result<void> Session::undo() {
  if (!m_work) return no_mesh();
  const Stopwatch watch;
  if (Result<void> done = step(false); !done) return done;
  changed(watch.milliseconds(), "undid: " + edit_text(m_work->edits()[std::size_t(m_work->applied())]));
  return {};
}

Result<void> Session::redo() {
  if (!m_work) return no_mesh();
  const Stopwatch watch;
  if (Result<void> done = step(true); !done) return done;
  changed(watch.milliseconds(), "redid: " + edit_text(m_work->edits()[std::size_t(m_work->applied() - 1)]));
  return {};
}

Result<void> Session::go_to(int target) {
  if (!m_work) return no_mesh();
  if (target < 0 || target > int(m_work->edits().size()))
    return make_error(Error_code::impossible_request, "the history has no such step");
  const Stopwatch watch;
  while (m_work->applied() != target)
    if (Result<void> done = step(m_work->applied() < target); !done) return done;
  changed(watch.milliseconds(), "went to step " + std::to_string(target));
  return {};
}

void Session::changed(double milliseconds, const std::string& text, bool save) {
  ++m_revision;
  m_drag = 0;
  m_layers_are_stale = true;
  m_saved.edits = m_work->edits();
  m_saved.applied = m_work->applied();
  measure();
  m_last = {{"ok", true}, {"text", text}, {"milliseconds", milliseconds}};
  if (!save) return;
  if (Result<void> saved = m_store.save(m_saved); !saved) {
    // The work itself is done; the page says that it is not kept.
    m_last["warning"] = "the session could not be saved: " + saved.error().message;
  }
}

Result<void> Session::finish(Observer& observer) {
  if (is_finished()) return {};
  observer.progress("relaxing the quads", 0);
  if (Result<void> done = m_work->finish(&observer); !done) return done;
  ++m_revision;
  m_layers_are_stale = true;
  measure();
  certify_quads(false, nullptr);
  return {};
}

Result<void> Session::certify(Observer& observer) {
  if (!m_work || !m_work->quads())
    return make_error(Error_code::impossible_request, "there are no quads yet");
  const Stopwatch watch;
  if (Result<void> finished = finish(observer); !finished) return finished;
  observer.progress("certificate", 0);
  certify_quads(true, &observer);
  ++m_revision;
  m_last = {{"ok", true}, {"text", "certified"}, {"milliseconds", watch.milliseconds()}};
  return {};
}

// What every edit is followed by is linear in the quads only; the certificate, which also reads the surface, comes when the
// quads are finished.
void Session::measure() {
  m_certificate.reset();
  m_statistics.reset();
  if (const Stitched_mesh* quads = m_work->quads()) m_statistics = quad_statistics(quads->mesh);
}

void Session::certify_quads(bool wholly, const Observer* observer) {
  const Stitched_mesh quads = with_paired_fans(*m_work->quads(), m_work->fans());
  Certificate_options options;
  options.measure_distance = options.find_self_intersections = wholly;
  options.observer = observer;
  m_certificate = CGAL::Reeb_quadrangulation::certify(
      {quads.mesh, &m_work->surface(), quads.valences, quads.components}, options);
}

const Layers& Session::layers() {
  if (m_layers_are_stale) m_layers = m_work ? m_work->layers() : Layers();
  m_layers_are_stale = false;
  return m_layers;
}

Result<std::shared_ptr<const std::string>> Session::chart(int index) const {
  if (!m_work) return no_mesh();
  return m_work->chart(index);
}

Result<std::string> Session::export_quads(const std::string& extension, Observer& observer) {
  if (!m_work || !m_work->quads())
    return make_error(Error_code::impossible_request, "there are no quads yet");
  if (Result<void> finished = finish(observer); !finished) return finished.error();
  const Mesh_format format = format_of_extension("quads." + extension);
  Result<Encoded_mesh> encoded = encode_mesh(with_fans(m_work->quads()->mesh, m_work->fans()), format);
  if (!encoded) return encoded.error();
  return std::move(encoded->bytes);
}

Result<std::string> Session::html_report(Observer& observer) {
  if (Result<void> certified = certify(observer); !certified) return certified.error();
  Html_report report;
  report.title = m_saved.name;
  Json mends = Json::array(), edits = Json::array(), axis = {0, 1, 0};
  for (const Json& text : m_file["mends"]) mends.push_back({{"text", text}});
  const Json all = history();
  for (int i = 0; i < m_work->applied(); ++i) {
    edits.push_back({{"text", all[i]["text"]}, {"milliseconds", all[i]["milliseconds"]}});
    axis = all[i]["edit"].value("axis", axis);
  }
  report.facts = {
      {"version", REEBQUAD_VERSION},
      {"input", {{"file", m_saved.name}, {"points", m_file["points"]}, {"faces", m_file["triangles"]}}},
      {"axis", axis},
      {"mends", mends},
      {"components", Json::array({{{"triangles", m_file["triangles"]},
                                   {"genus", m_file["genus"]},
                                   {"quads", m_work->quads()->mesh.quads.size()}}})},
      {"certificate", Json::parse(to_json(*m_certificate))},
      {"statistics", Json::parse(to_json(*m_statistics))},
      {"edits", edits}};
  report.parts.push_back(layers());
  return html_text(report);
}

Result<std::string> Session::recipe() const {
  if (!m_work) return no_mesh();
  return m_work->recipe();
}

Json Session::history() const {
  Json list = Json::array();
  const std::vector<Json> edits = m_work->edits();
  for (std::size_t i = 0; i < edits.size(); ++i)
    list.push_back({{"text", edit_text(edits[i])},
                    {"edit", edits[i]},
                    {"milliseconds", i < m_milliseconds.size() ? m_milliseconds[i] : 0.0}});
  return list;
}

// Sum of 4 - valence over interior, of 3 - valence over boundary vertices, is 4 (V - E + F): so the surface says how many
// extraordinary vertices there must be, and the statistics how many there are.
Json Session::budget() const {
  Json interior = Json::object(), boundary = Json::object();
  if (m_statistics) {
    // Two triangles of a fan count as a quad: the sum is the same.
    const Mesh_statistics statistics =
        m_work->fans().empty() ? *m_statistics
                               : quad_statistics(with_paired_fans(*m_work->quads(), m_work->fans()).mesh);
    for (const auto& [valence, number] : statistics.interior_valences)
      interior[std::to_string(valence)] = number;
    for (const auto& [valence, number] : statistics.boundary_valences)
      boundary[std::to_string(valence)] = number;
  }
  return {{"needed", 4 * m_file["euler_characteristic"].get<int>()},
          {"interior", interior},
          {"boundary", boundary}};
}

Json Session::state() const {
  Json state{{"event", "state"}, {"revision", m_revision}, {"file", m_file}, {"last", m_last}};
  if (!m_work) {
    const std::optional<Saved_session> last = m_store.load();
    if (last) state["last_session"] = {{"name", last->name}, {"edits", last->edits.size()}};
    return state;
  }
  state["history"] = history();
  state["applied"] = m_work->applied();
  state["facts"] = m_work->facts();
  state["finished"] = m_work->is_finished();
  state["budget"] = budget();
  if (m_certificate) state["certificate"] = Json::parse(to_json(*m_certificate));
  if (m_statistics) state["statistics"] = Json::parse(to_json(*m_statistics));
  return state;
}

} // namespace studio
} // namespace reebquad
