// SPDX-License-Identifier: GPL-3.0-or-later
#include "server/Hub.h"

#include "view/Frame_patch.h"

#include <CGAL/Reeb_quadrangulation/IO/atomic_file.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace reebquad {
namespace studio {

using CGAL::Reeb_quadrangulation::Error;
using CGAL::Reeb_quadrangulation::Error_code;
using CGAL::Reeb_quadrangulation::make_error;

namespace {

std::shared_ptr<const std::string> text_of(const Json& json) {
  return std::make_shared<const std::string>(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

Json error_json(const Error& error) {
  return {{"code", CGAL::Reeb_quadrangulation::description(error.code)},
          {"cancelled", error.code == Error_code::cancelled},
          {"message", error.message},
          {"element", CGAL::Reeb_quadrangulation::name(error.element)},
          {"index", error.index}};
}

Json reply_json(std::int64_t id, const Result<Json>& result) {
  if (result) return {{"reply", id}, {"ok", true}, {"result", *result}};
  return {{"reply", id}, {"ok", false}, {"error", error_json(result.error())}};
}

Result<Json> done(const Result<void>& result) {
  if (!result) return result.error();
  return Json::object();
}

Json listed(const std::vector<Listed_file>& files) {
  Json list = Json::array();
  for (const Listed_file& file : files) list.push_back({{"name", file.name}, {"bytes", file.bytes}});
  return list;
}

Result<Json> list_files(const Session& session) {
  const Folder& folder = session.folder();
  return Json{{"folder", folder.path().filename().string()},
              {"files", listed(folder.meshes())},
              {"recipes", listed(folder.recipes())},
              {"sessions", session.sessions()}};
}

std::string extension_of(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? "" : name.substr(dot + 1);
}

/// What the page sends is a mesh or a recipe; this is told by the name.
bool is_recipe(const std::string& name) {
  return extension_of(name) == "json";
}

bool is_true(const Json& body, const char* name) {
  const auto member = body.find(name);
  return member != body.end() && *member == true;
}

/// Writes what the session gives into a file of the user's folder; an existing one is kept, unless the page
/// says otherwise.
Result<Json> save(const Session& session, const Json& body, const Result<std::string>& bytes) {
  const std::string name = body["name"];
  const bool replaces = is_true(body, "replace");
  if (!bytes) return bytes.error();
  Result<std::string> path = session.folder().resolve(name);
  if (!path) return path.error();
  const auto refused = [&](const char* why) {
    return make_error(Error_code::impossible_request, name + ": " + why);
  };
  if (session.is_open_file(*path)) return refused("this is the mesh that is open; give another name");
  std::error_code failed;
  if (!replaces && std::filesystem::exists(*path, failed))
    return refused("there is such a file already; give another name, or say that it is to be replaced");
  Result<void> written = CGAL::Reeb_quadrangulation::write_file_atomically(*path, *bytes);
  if (!written) return written.error();
  return Json{{"name", name}};
}

/// An optional integer member, or 0.
std::int64_t integer(const Json& body, const char* name) {
  const auto member = body.find(name);
  return member != body.end() && member->is_number_integer() ? member->get<std::int64_t>() : 0;
}

/// An optional text member, or "".
std::string text(const Json& body, const char* name) {
  const auto member = body.find(name);
  return member != body.end() && member->is_string() ? member->get<std::string>() : "";
}

Result<Json> execute(Session& session, const Request& request, Worker::Observer& observer) {
  const Json& body = request.body;
  switch (request.command) {
  case Command::list_files: return list_files(session);
  case Command::open_file: return done(session.open_file(body["name"], observer));
  case Command::open_recipe: return done(session.open_recipe_file(body["name"], observer));
  case Command::component: return done(session.choose(body["component"], observer));
  case Command::restore: return done(session.restore(observer, text(body, "digest")));
  case Command::forget: session.forget(text(body, "digest")); return Json::object();
  case Command::keep_picture: return done(session.keep_picture(body["picture"]));
  case Command::prefer: return done(session.store().save_preferences(body["preferences"]));
  case Command::cancel_drag: session.cancel_drag(integer(body, "drag")); return Json::object();
  case Command::edit:
    return session.edit(body["edit"], observer, integer(body, "drag"), is_true(body, "live"));
  case Command::preview: return session.preview(body["edit"], observer);
  case Command::offer: return session.offer(body["edit"], observer);
  case Command::hints: return session.hints(observer);
  case Command::undo: return done(session.undo());
  case Command::redo: return done(session.redo());
  case Command::go_to: return done(session.go_to(int(std::clamp<std::int64_t>(body["step"], -1, 1 << 30))));
  case Command::certify: return done(session.certify(observer));
  case Command::save_recipe: return save(session, body, session.recipe());
  case Command::export_quads:
    return save(session, body, session.export_quads(extension_of(body["name"]), observer));
  case Command::cancel: // by the hub, at once
  case Command::chart:
  case Command::deviation: break; // their frames go to one page only
  }
  return make_error(Error_code::internal_error, "the command is not carried out here");
}

} // namespace

Hub::Hub(const Folder& folder, Post post)
    : m_post(std::move(post)), m_session(std::make_unique<Session>(folder)),
      m_worker(std::make_unique<Worker>([this](const std::string& stage, double fraction) {
        m_post([this, stage, fraction] {
          broadcast("progress", {{"event", "progress"}, {"stage", stage}, {"fraction", fraction}});
        });
      })) {
  m_state = text_of(m_session->state());
  m_preferences = m_session->store().preferences();
}

void Hub::stop() {
  m_worker.reset();
  m_owed.clear();
  m_clients.clear();
}

void Hub::add(const std::shared_ptr<Client>& client) {
  m_clients.insert(client);
  client->send({"",
                text_of({{"event", "hello"}, {"version", protocol_version}, {"preferences", m_preferences}}),
                false});
  send_layers(*client);
  client->send({"state", m_state, false});
}

void Hub::remove(const std::shared_ptr<Client>& client) {
  m_clients.erase(client);
  finish(); // where it was dragging, nothing follows
}

// Who waits is told at once; the worker stops as soon as it notices.
void Hub::cancel() {
  m_worker->cancel();
  const auto owed = std::move(m_owed);
  m_owed.clear();
  for (const auto& [number, reply] : owed) reply(make_error(Error_code::cancelled, "cancelled"));
}

void Hub::enqueue(Task task, std::function<void(Result<Json>)> reply, const Standing& standing) {
  const std::int64_t number = m_next_owed++;
  m_owed[number] = std::move(reply);
  const auto done = [this, number](const Result<Json>& result) {
    const auto owed = m_owed.find(number);
    if (owed == m_owed.end()) return;
    const auto answer = std::move(owed->second);
    m_owed.erase(owed);
    answer(result);
  };
  // The reply follows the picture: when a page learns that its edit is done it has been sent what changed.
  const bool is_live = standing.live_drag != 0;
  const auto job = [this, task = std::move(task), done, is_live](Worker::Observer& observer) {
    Result<Json> result = task(*m_session, observer);
    publish_from_worker();
    m_post([done, result = std::move(result)] { done(result); });
    // The next one of a drag is not to wait for the end of this one.
    if (!is_live && !m_session->is_finished()) m_post([this] { finish(); });
  };
  const auto failed = [this, done](const std::string& what) {
    m_post([done, what] { done(make_error(Error_code::internal_error, "the work failed: " + what)); });
  };
  if (!m_worker->push(job, failed, standing.replaceable, standing.replaces, standing.live_drag))
    done(make_error(Error_code::impossible_request, "too many requests wait; this one is dropped"));
}

// The slow end of an edit: another job of its own, which gives way to the next edit.
void Hub::finish() {
  if (!m_worker) return;
  const auto trouble = [this](const std::string& sentence) {
    m_post([this, sentence] { broadcast("", {{"event", "trouble"}, {"message", sentence}}); });
  };
  const auto job = [this, trouble](Worker::Observer& observer) {
    const Result<void> done = m_session->finish(observer);
    if (done) return publish_from_worker();
    if (done.error().code != Error_code::cancelled) trouble(done.error().message);
  };
  m_worker->push(
      job, [trouble](const std::string& what) { trouble("the quads could not be relaxed: " + what); }, true,
      false);
}

void Hub::receive(const std::shared_ptr<Client>& client, std::string_view text) {
  Result<Request> request = parse_request(text);
  if (!request) {
    client->send({"", text_of(reply_json(request_id(text), request.error())), false});
    return;
  }
  if (request->command == Command::cancel) {
    cancel();
    client->send({"", text_of(reply_json(request->id, Json::object())), false});
    return;
  }
  start(client, *request);
}

void Hub::start(const std::weak_ptr<Client>& client, const Request& request) {
  const std::int64_t id = request.id;
  const auto reply = [client, id](Result<Json> result) {
    if (const auto there = client.lock()) there->send({"", text_of(reply_json(id, result)), false});
  };
  const auto task = [this, request, client](Session& session, Worker::Observer& observer) -> Result<Json> {
    const bool of_chart = request.command == Command::chart;
    if (!of_chart && request.command != Command::deviation) return execute(session, request, observer);
    Result<std::shared_ptr<const std::string>> frame =
        of_chart ? session.chart(request.body["chart"].get<int>()) : session.deviation(observer);
    if (!frame) return frame.error();
    m_post([client, of_chart, frame = *frame] {
      if (const auto there = client.lock()) there->send({of_chart ? "chart" : "deviation", frame, true});
    });
    return Json::object();
  };
  if (request.command == Command::prefer) m_preferences = request.body["preferences"];
  const bool live = request.command == Command::edit && is_true(request.body, "live");
  Standing standing;
  constexpr std::array questions{Command::preview, Command::offer, Command::hints, Command::deviation};
  standing.replaceable =
      live || std::find(questions.begin(), questions.end(), request.command) != questions.end();
  // Only looking makes nothing out of date.
  constexpr std::array looks{Command::chart, Command::deviation, Command::list_files, Command::keep_picture,
                             Command::prefer};
  standing.replaces = std::find(looks.begin(), looks.end(), request.command) == looks.end();
  if (live) standing.live_drag = integer(request.body, "drag");
  enqueue(task, reply, standing);
}

void Hub::open_file(const std::string& name) {
  enqueue([name](Session& session,
                 Worker::Observer& observer) { return done(session.open_file(name, observer)); },
          [this](Result<Json> result) {
            if (!result) broadcast("", {{"event", "trouble"}, {"message", result.error().message}});
          });
}

void Hub::resume() {
  enqueue([](Session& session, Worker::Observer& observer) { return done(session.resume(observer)); },
          [this](Result<Json> result) {
            if (!result) broadcast("", {{"event", "trouble"}, {"message", result.error().message}});
          });
}

void Hub::upload(std::string name, std::string bytes, Download done_) {
  enqueue(
      [name = std::move(name), bytes = std::move(bytes)](Session& session, Worker::Observer& observer) {
        const Result<void> taken = is_recipe(name) ? session.open_recipe(name, bytes, observer)
                                                   : session.open_upload(name, bytes, observer);
        if (!taken) return Result<Json>(taken.error());
        return Result<Json>(Json{{"revision", session.revision()}});
      },
      [done_](Result<Json> result) {
        if (result)
          done_(result->dump());
        else
          done_(result.error());
      });
}

void Hub::download(std::string what, Download done_) {
  const auto bytes = std::make_shared<std::string>();
  enqueue(
      [what = std::move(what), bytes](Session& session, Worker::Observer& observer) -> Result<Json> {
        Result<std::string> made = what == "recipe" ? session.recipe()
                                   : what == "html" ? session.html_report(observer)
                                                    : session.export_quads(what, observer);
        if (!made) return made.error();
        *bytes = std::move(*made);
        return Json::object();
      },
      [done_, bytes](Result<Json> result) {
        if (result)
          done_(std::move(*bytes));
        else
          done_(result.error());
      });
}

// A layer that is the same as before keeps its bytes, and so nobody is sent it again; but with a new surface
// the values on it are sent anew.
void Hub::publish_from_worker() {
  if (m_session->revision() == m_published) return;
  m_published = m_session->revision();
  Layers layers = m_session->layers(), patches;
  const auto before = [&](const std::string& name) -> std::shared_ptr<const std::string> {
    const auto found = m_published_layers.find(name);
    return found == m_published_layers.end() ? nullptr : found->second;
  };
  const auto same = [&](const std::string& name) {
    const auto now = layers.find(name);
    const auto old = before(name);
    return old && now != layers.end() && (old == now->second || *old == *now->second);
  };
  const bool same_surface = same("surface");
  for (auto& [name, bytes] : layers) {
    if (!same_surface && (name == "cuts" || name == "field" || name == "charts")) continue;
    if (same(name))
      bytes = before(name);
    else if (const auto old = before(name); old && same_surface)
      patches[name] = frame_patch(*old, *bytes);
  }
  m_published_layers = layers;
  auto state = text_of(m_session->state());
  m_post(
      [this, layers = std::move(layers), patches = std::move(patches), state = std::move(state)]() mutable {
        m_layers_before = std::move(m_layers);
        m_layers = std::move(layers);
        m_patches = std::move(patches);
        m_state = std::move(state);
        publish();
      });
}

void Hub::publish() {
  for (const auto& client : m_clients) {
    send_layers(*client);
    client->send({"state", m_state, false});
  }
}

void Hub::send_layers(Client& client) const {
  // The surface first: other layers give values to its vertices and faces.
  constexpr std::array order{"surface",  "cuts", "field",    "charts", "contours",
                             "critical", "reeb", "textures", "quads",  "others"};
  for (const char* name : order) {
    const auto current = m_layers.find(name);
    const auto bytes = current == m_layers.end() ? nullptr : current->second;
    auto& sent = client.layers[name];
    if (sent == bytes) continue;
    const std::string key = std::string("layer ") + name;
    const auto patch = m_patches.find(name), before = m_layers_before.find(name);
    const bool is_current = sent && before != m_layers_before.end() && before->second == sent;
    sent = bytes;
    if (bytes && is_current && patch != m_patches.end() && patch->second)
      client.send({key, patch->second, true, bytes});
    else if (bytes)
      client.send({key, bytes, true});
    else
      client.send({key, text_of({{"event", "no_layer"}, {"layer", name}}), false});
  }
}

void Hub::broadcast(const std::string& key, const Json& json) {
  const auto text = text_of(json);
  for (const auto& client : m_clients) client->send({key, text, false});
}

} // namespace studio
} // namespace reebquad
