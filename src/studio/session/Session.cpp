// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/Session.h"

#include "session/Edit_text.h"
#include "view/Html_report.h"

#include <CGAL/Reeb_quadrangulation/IO/read_file.h>
#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>
#include <CGAL/Reeb_quadrangulation/IO/write_mesh.h>
#include <CGAL/Reeb_quadrangulation/surface_check.h>

#include <chrono>
#include <filesystem>
#include <utility>

namespace reebquad {
namespace studio {

using namespace CGAL::Reeb_quadrangulation;

namespace {

constexpr std::uint64_t largest_recipe = std::uint64_t(256) << 20;
constexpr std::size_t sessions_with_pictures = 24;
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

/// Points of all layers are relative to the middle of the whole file.
Point middle(const std::vector<Mended_component>& components, double& diagonal) {
  Eigen::AlignedBox3d box;
  for (const Mended_component& component : components)
    for (const Point& p : component.surface.points) box.extend(p);
  diagonal = box.diagonal().norm();
  return box.center();
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

/// About sessions that cannot be read; empty if there are none.
std::string notice_of(const std::vector<std::string>& unreadable) {
  std::string names;
  for (const std::string& name : unreadable) names += (names.empty() ? "" : ", ") + name;
  return names.empty() ? "" : "sessions that this program cannot read are kept as they are: " + names;
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
  return begin(std::move(origin), *bytes, observer);
}

Result<void> Session::open_upload(const std::string& name, const std::string& bytes, Observer& observer) {
  Saved_session origin;
  origin.name = name;
  return begin(std::move(origin), bytes, observer);
}

// Another session takes the place of this one when all of it is there.
Result<void> Session::begin(Saved_session origin, const std::string& bytes, Observer& observer) {
  origin.bytes = bytes.size();
  origin.digest = digest(bytes);
  const std::optional<Saved_session> saved = m_store.load(origin.digest);
  Session next(m_folder);
  next.m_keeps = false; // what is kept stays as it is until then
  if (Result<void> opened = next.open(origin, bytes, observer); !opened) return opened;
  if (!saved) {
    // A file in the way is of another version, or damaged: it may still be of use to someone.
    Result<std::string> kept = m_store.set_aside(origin.digest);
    if (!kept) return kept.error();
    if (!kept->empty())
      next.m_notice = "an earlier session of this mesh cannot be read; it is kept as " + *kept;
  } else if (saved->number_of_edits() > 0) {
    if (Result<void> repeated = next.repeat_all(*saved, observer); !repeated) return repeated;
  }
  // The page lists them only while nothing is open.
  if (!part() && next.m_notice.empty()) next.m_notice = notice_of(m_store.unreadable());
  if (origin.file.empty())
    if (Result<void> kept = m_store.save_upload(origin, bytes); !kept) return kept;
  bool has_edits = false;
  for (const auto& each : m_parts) has_edits = has_edits || (each->work() && !each->work()->edits().empty());
  if (part() && !has_edits && m_saved.digest != origin.digest) m_store.forget(m_saved.digest);
  const std::int64_t revision = m_revision + next.m_revision;
  *this = std::move(next);
  m_keeps = true;
  m_revision = revision;
  save();
  return {};
}

// What could be repeated is worth more than nothing; the sentence says where it ended, and all of it is kept.
Result<void> Session::repeat_all(const Saved_session& saved, Observer& observer) {
  const Stopwatch watch;
  Json text{{"ok", true}, {"text", "your work on " + m_saved.name + " is back"}};
  for (const Saved_part& each : saved.parts) {
    const Result<void> done = repeat(each, observer);
    if (done) continue;
    if (done.error().code == Error_code::cancelled) return done;
    Result<std::string> kept = m_store.set_aside(saved.digest);
    if (!kept) return kept.error();
    const std::string where = kept->empty() ? "" : "; the whole of it is kept as " + *kept;
    text = {{"ok", false},
            {"text", "restored up to an edit that is refused now: " + done.error().message + where}};
  }
  if (Result<void> chosen = choose(saved.component, observer); !chosen) return chosen;
  text["milliseconds"] = watch.milliseconds();
  m_last = text;
  return {};
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
  observer.progress("preparing", 0.6);
  double diagonal = 0;
  const Point centre = middle(mended->components, diagonal);
  Parts parts;
  std::size_t largest = 0;
  for (Mended_component& component : mended->components) {
    parts.push_back(std::make_unique<Part>(std::move(component.surface), centre));
    if (parts.back()->surface().triangles.size() > parts[largest]->surface().triangles.size())
      largest = parts.size() - 1;
  }
  if (Result<void> begun = parts[largest]->begin(&observer); !begun) return begun;
  if (observer.cancelled()) return make_error(Error_code::cancelled, "cancelled");

  m_parts = std::move(parts);
  m_part = largest;
  m_centre = centre;
  m_others_of = nullptr;
  m_saved = std::move(origin);
  Json mends = Json::array(), refused = Json::array();
  for (const Mend& mend : mended->mends) mends.push_back(mend.text);
  for (const Error& error : mended->refused) refused.push_back(error.message);
  m_file = {{"name", m_saved.name},         {"mends", mends},       {"refused", refused},
            {"origin", json_point(centre)}, {"diagonal", diagonal}, {"defects", defects(*soup, centre)}};
  changed(watch.milliseconds(), "opened " + m_saved.name);
  return {};
}

Result<void> Session::choose(std::int64_t component, Observer& observer) {
  if (!part()) return no_mesh();
  if (component < 1 || component > std::int64_t(m_parts.size()))
    return make_error(Error_code::impossible_request, "the mesh has no part of that number");
  const Stopwatch watch;
  const auto chosen = std::size_t(component - 1);
  observer.progress("preparing", 0);
  if (Result<void> begun = m_parts[chosen]->begin(&observer); !begun) return begun;
  m_part = chosen;
  changed(watch.milliseconds(), "went to part " + std::to_string(component));
  return {};
}

Result<void> Session::restore(Observer& observer, const std::string& wanted) {
  const std::optional<Saved_session> last = wanted.empty() ? m_store.load() : m_store.load(wanted);
  if (!last) return make_error(Error_code::unreadable_file, "there is no such session in this folder");
  Result<std::string> bytes = m_store.load_mesh(*last);
  if (!bytes) return bytes.error();
  Saved_session origin = *last;
  origin.parts.clear();
  return begin(std::move(origin), *bytes, observer);
}

Result<void> Session::resume(Observer& observer) {
  const std::vector<Saved_session> all = m_store.sessions();
  return all.empty() ? Result<void>() : restore(observer, all.front().digest);
}

Result<void> Session::repeat(const Saved_part& saved, Observer& observer) {
  if (Result<void> chosen = choose(saved.component, observer); !chosen) return chosen;
  if (!saved.base.is_null()) {
    const Result<Recipe> base = recipe_from_json(saved.base.dump());
    if (!base) return base.error();
    if (Result<void> begun = part()->follow(*base, observer); !begun) return begun;
  }
  for (const Json& each : saved.edits)
    if (Result<Json> done = edit(each, observer); !done) return done.error();
  return go_to(saved.applied);
}

void Session::forget(const std::string& wanted) {
  const std::optional<Saved_session> last = wanted.empty() ? m_store.load() : m_store.load(wanted);
  if (last) m_store.forget(last->digest);
}

bool Session::is_open_file(const std::string& path) const {
  const Result<std::string> open = m_folder.resolve(m_saved.file);
  std::error_code failed;
  return open && std::filesystem::equivalent(*open, path, failed);
}

Result<Json> Session::edit(const Json& edit, Observer& observer, std::int64_t drag, bool live) {
  if (!work()) return no_mesh();
  const Stopwatch watch;
  const bool replaces = drag > 0 && drag == m_drag;
  if (replaces)
    if (Result<void> undone = work()->undo(); !undone) return undone.error();
  Result<Json> done = work()->apply(edit, &observer, live);
  if (!done) {
    // While dragging the edit before is back, unless this one was stopped when it had taken its place
    // already.
    if (replaces && live && !work()->redo()) changed(watch.milliseconds(), "stopped dragging");
    if (replaces && !live) {
      work()->forget_undone();
      changed(watch.milliseconds(), "the place was refused: everything is as it was before the drag");
    }
    return done;
  }
  part()->took(watch.milliseconds());
  changed(watch.milliseconds(), edit_text(edit), !live);
  m_drag = drag;
  return done;
}

void Session::cancel_drag(std::int64_t drag) {
  if (!work() || drag <= 0 || drag != m_drag) return;
  const Stopwatch watch;
  work()->take_back();
  changed(watch.milliseconds(), "the drag was taken back");
}

Result<void> Session::open_recipe_file(const std::string& name, Observer& observer) {
  Result<std::string> path = m_folder.resolve(name);
  if (!path) return path.error();
  Result<std::string> bytes = read_file(*path, largest_recipe);
  if (!bytes) return make_error(bytes.error().code, name + ": " + bytes.error().message);
  return open_recipe(name, *bytes, observer);
}

Result<void> Session::open_recipe(const std::string& name, const std::string& text, Observer& observer) {
  if (!work()) return make_error(Error_code::impossible_request, "open the mesh of the recipe first");
  const Stopwatch watch;
  Result<Recipe> recipe = recipe_from_json(text);
  if (!recipe) return make_error(recipe.error().code, name + ": " + recipe.error().message);
  const std::size_t wanted = recipe->component > 0 ? std::size_t(recipe->component) - 1 : m_part;
  if (wanted >= m_parts.size())
    return make_error(Error_code::impossible_request, name + " is for part " +
                                                          std::to_string(recipe->component) +
                                                          ", which this mesh has not");
  Part& part = *m_parts[wanted];
  if (recipe->mirror)
    return make_error(
        Error_code::impossible_request,
        name + " designs one half of a mirrored mesh, which the studio would show alone: `reebquad "
               "replay` makes both of it");
  if (recipe->fill_holes > 0 && part.facts()["boundary_loops"] != 0)
    return make_error(Error_code::impossible_request,
                      name + " fills the holes of the mesh first: open the mesh with its holes filled");
  if (Result<void> done = part.follow(*recipe, observer); !done)
    return make_error(done.error().code, name + ": " + done.error().message);
  m_part = wanted;
  changed(watch.milliseconds(), "followed the recipe " + name);
  return {};
}

Json Session::sessions() const {
  Json list = Json::array();
  for (const Saved_session& each : m_store.sessions()) {
    list.push_back({{"name", each.name},
                    {"edits", each.number_of_edits()},
                    {"digest", each.digest},
                    {"saved", each.saved}});
    if (list.size() <= sessions_with_pictures) list.back()["picture"] = m_store.picture(each.digest);
  }
  return list;
}

Result<void> Session::keep_picture(const std::string& picture) const {
  if (!part()) return no_mesh();
  return m_store.save_picture(m_saved.digest, picture);
}

Result<Json> Session::preview(const Json& edit, Observer& observer) const {
  if (!work()) return no_mesh();
  return work()->preview(edit, &observer);
}

Result<Json> Session::offer(const Json& edit, Observer& observer) const {
  if (!work()) return no_mesh();
  Quiet_observer quiet(observer);
  return work()->offer(edit, &quiet);
}

Result<Json> Session::hints(Observer& observer) const {
  if (!work()) return no_mesh();
  Quiet_observer quiet(observer);
  Result<Json> hints = work()->hints(&quiet);
  if (hints)
    for (Json& hint : *hints) hint["text"] = edit_text(hint["edit"]);
  return hints;
}

Result<void> Session::step(bool forward) {
  return forward ? work()->redo() : work()->undo();
}

Result<void> Session::undo() {
  if (!work()) return no_mesh();
  const Stopwatch watch;
  if (Result<void> done = step(false); !done) return done;
  changed(watch.milliseconds(), "undid: " + edit_text(work()->edits()[std::size_t(work()->applied())]));
  return {};
}

Result<void> Session::redo() {
  if (!work()) return no_mesh();
  const Stopwatch watch;
  if (Result<void> done = step(true); !done) return done;
  changed(watch.milliseconds(), "redid: " + edit_text(work()->edits()[std::size_t(work()->applied() - 1)]));
  return {};
}

Result<void> Session::go_to(int target) {
  if (!work()) return no_mesh();
  if (target < 0 || target > int(work()->edits().size()))
    return make_error(Error_code::impossible_request, "the history has no such step");
  const Stopwatch watch;
  while (work()->applied() != target)
    if (Result<void> done = step(work()->applied() < target); !done) return done;
  changed(watch.milliseconds(), "went to step " + std::to_string(target));
  return {};
}

void Session::changed(double milliseconds, const std::string& text, bool keep) {
  ++m_revision;
  m_drag = 0;
  m_layers_are_stale = true;
  // A part that is only looked at keeps its certificate.
  if (!part()->is_finished() || !part()->has_quads()) part()->measure();
  m_last = {{"ok", true}, {"text", text}, {"milliseconds", milliseconds}};
  if (keep && m_keeps) save();
}

void Session::save() {
  if (!m_notice.empty()) m_last["warning"] = std::exchange(m_notice, "");
  m_saved.component = int(m_part) + 1;
  m_saved.parts.clear();
  for (std::size_t i = 0; i < m_parts.size(); ++i) {
    const Workpiece* each = m_parts[i]->work();
    const std::vector<Json> edits = each ? each->edits() : std::vector<Json>();
    if (!edits.empty()) m_saved.parts.push_back({int(i) + 1, edits, each->applied(), m_parts[i]->base()});
  }
  if (Result<void> saved = m_store.save(m_saved); !saved) {
    // The work itself is done; the page says that it is not kept.
    m_last["warning"] = "the session could not be saved: " + saved.error().message;
  }
}

Result<void> Session::finish(Observer& observer) {
  if (is_finished()) return {};
  if (Result<void> done = part()->finish(observer); !done) return done;
  ++m_revision;
  m_layers_are_stale = true;
  return {};
}

// Fails where there are no quads at all.
Result<void> Session::finish_all(Observer& observer) {
  bool has_quads = false;
  for (const auto& each : m_parts) {
    has_quads = has_quads || each->has_quads();
    if (each.get() == part()) {
      if (Result<void> done = finish(observer); !done) return done;
    } else if (Result<void> done = each->finish(observer); !done) {
      return done;
    }
  }
  if (!has_quads) return make_error(Error_code::impossible_request, "there are no quads yet");
  return {};
}

Result<void> Session::certify(Observer& observer) {
  if (!part() || !part()->has_quads())
    return make_error(Error_code::impossible_request, "there are no quads yet");
  const Stopwatch watch;
  if (Result<void> finished = finish(observer); !finished) return finished;
  observer.progress("certificate", 0);
  part()->certify(true, &observer);
  ++m_revision;
  m_last = {{"ok", true}, {"text", "certified"}, {"milliseconds", watch.milliseconds()}};
  return {};
}

const Layers& Session::layers() {
  if (!m_layers_are_stale) return m_layers;
  const auto others = m_layers.find("others");
  const auto kept = others != m_layers.end() && m_others_of == part() ? others->second : nullptr;
  m_layers = work() ? work()->layers() : Layers();
  if (m_parts.size() > 1) m_layers["others"] = kept ? kept : others_layer(m_parts, m_part, m_centre);
  m_others_of = part();
  m_layers_are_stale = false;
  return m_layers;
}

Result<std::shared_ptr<const std::string>> Session::chart(int index) const {
  if (!work()) return no_mesh();
  return work()->chart(index);
}

Result<std::shared_ptr<const std::string>> Session::deviation(const Observer& observer) const {
  if (!work()) return no_mesh();
  return work()->deviation(&observer);
}

Result<std::string> Session::export_quads(const std::string& extension, Observer& observer) {
  if (Result<void> finished = finish_all(observer); !finished) return finished.error();
  const Mesh_format format = format_of_extension("quads." + extension);
  Result<Encoded_mesh> encoded = encode_mesh(joined_polygons(m_parts), format);
  if (!encoded) return encoded.error();
  return std::move(encoded->bytes);
}

Result<std::string> Session::html_report(Observer& observer) {
  if (Result<void> finished = finish_all(observer); !finished) return finished.error();
  observer.progress("certificate", 0);
  const Measured_parts measured = measure_together(m_parts, observer);
  Html_report report;
  report.title = m_saved.name;
  Json mends = Json::array(), edits = Json::array(), axis = {0, 1, 0}, components = Json::array();
  for (const Json& text : m_file["mends"]) mends.push_back({{"text", text}});
  std::size_t points = 0, faces = 0;
  for (std::size_t i = 0; i < m_parts.size(); ++i) {
    const Part& each = *m_parts[i];
    components.push_back(each.facts());
    points += each.surface().points.size();
    faces += each.surface().triangles.size();
    if (!each.has_quads()) continue;
    const Json all = each.history();
    const std::string which = m_parts.size() > 1 ? "part " + std::to_string(i + 1) + ": " : "";
    for (int k = 0; k < each.work()->applied(); ++k) {
      edits.push_back(
          {{"text", which + all[k]["text"].get<std::string>()}, {"milliseconds", all[k]["milliseconds"]}});
      axis = all[k]["edit"].value("axis", axis);
    }
    report.parts.push_back(each.work()->layers());
  }
  report.facts = {{"version", REEBQUAD_VERSION},
                  {"input", {{"file", m_saved.name}, {"points", points}, {"faces", faces}}},
                  {"axis", axis},
                  {"mends", mends},
                  {"components", components},
                  {"certificate", Json::parse(to_json(measured.certificate))},
                  {"statistics", Json::parse(to_json(measured.statistics))},
                  {"edits", edits}};
  return html_text(report);
}

Result<std::string> Session::recipe() const {
  if (!work()) return no_mesh();
  Recipe recipe = work()->recipe();
  if (m_parts.size() > 1) recipe.component = int(m_part) + 1;
  return to_json(recipe);
}

Json Session::state() const {
  Json state{{"event", "state"}, {"revision", m_revision}, {"file", m_file}, {"last", m_last}};
  if (!work()) {
    const std::optional<Saved_session> last = m_store.load();
    if (last) state["last_session"] = {{"name", last->name}, {"edits", last->number_of_edits()}};
    state["sessions"] = sessions();
    state["unreadable_sessions"] = m_store.unreadable();
    return state;
  }
  state["file"].update(part()->facts());
  state["file"]["component"] = m_part + 1;
  state["file"]["digest"] = m_saved.digest;
  state["file"]["components"] = Json::array();
  for (const auto& each : m_parts) state["file"]["components"].push_back(each->facts());
  state["history"] = part()->history();
  state["applied"] = work()->applied();
  state["facts"] = work()->facts();
  state["finished"] = part()->is_finished();
  state["budget"] = part()->budget();
  if (part()->certificate()) state["certificate"] = Json::parse(to_json(*part()->certificate()));
  if (part()->statistics()) state["statistics"] = Json::parse(to_json(*part()->statistics()));
  return state;
}

} // namespace studio
} // namespace reebquad
