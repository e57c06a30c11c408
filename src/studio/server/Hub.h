// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SERVER_HUB_H
#define REEBQUAD_SERVER_HUB_H

#include "server/Client.h"
#include "server/Request.h"
#include "server/Worker.h"
#include "session/Session.h"

#include <functional>
#include <set>

namespace reebquad {
namespace studio {

/// Joins the pages that are connected to the one session: takes their requests, has the worker carry them
/// out, and tells all pages what became of it. All functions are called on the sockets' thread.
class Hub {
public:
  /// Runs a function on the sockets' thread, from any thread.
  using Post = std::function<void(std::function<void()>)>;
  /// A download: the bytes, or why there are none.
  using Download = std::function<void(Result<std::string>)>;

  Hub(const Folder& folder, Post post);
  /// Ends the work and lets go of the pages.
  void stop();

  void add(const std::shared_ptr<Client>& client);
  void remove(const std::shared_ptr<Client>& client);
  std::size_t number_of_clients() const { return m_clients.size(); }

  /// A text message of a page; the reply goes to that page, what changed to all.
  void receive(const std::shared_ptr<Client>& client, std::string_view text);

  /// Opens a mesh file of the user's folder, as if a page had asked for it.
  void open_file(const std::string& name);
  /// Brings back what was open last, if there is anything.
  void resume();
  void upload(std::string name, std::string bytes, Download done);
  /// `what` is "recipe", "html" or the extension of a mesh format.
  void download(std::string what, Download done);

private:
  using Task = std::function<Result<Json>(Session&, Worker::Observer&)>;
  void start(const std::weak_ptr<Client>& client, const Request& request);
  /// How a task stands to others.
  struct Standing {
    bool replaceable = false, replaces = true;
    std::int64_t live_drag = 0; ///< of an edit while dragging; see `Worker::push()`
  };
  void enqueue(Task task, std::function<void(Result<Json>)> done) { enqueue(task, done, Standing()); }
  void enqueue(Task task, std::function<void(Result<Json>)> done, const Standing& standing);
  void cancel();
  void finish();
  /// Tells the pages the session as it is; called by the worker's thread.
  void publish_from_worker();
  void publish();
  /// Sends the layers that changed; where the client has `m_layers_before`, only what changed of them.
  void send_layers(Client& client) const;
  void broadcast(const std::string& key, const Json& json);

  Post m_post;
  std::set<std::shared_ptr<Client>> m_clients;
  /// The replies that are owed, and how to give them early.
  std::map<std::int64_t, std::function<void(Result<Json>)>> m_owed;
  std::int64_t m_next_owed = 0;
  Layers m_layers, m_layers_before; ///< as published last, and the time before
  Layers m_patches;                 ///< what makes those of these; some have none
  std::shared_ptr<const std::string> m_state;
  Json m_preferences; ///< that pages have asked to be kept
  /// \name The worker's
  /// @{
  std::unique_ptr<Session> m_session;
  std::int64_t m_published = -1;
  Layers m_published_layers;
  /// @}
  std::unique_ptr<Worker> m_worker; // last: it uses the others
};

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_SERVER_HUB_H
