// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_SERVER_CLIENT_H
#define REEBQUAD_SERVER_CLIENT_H

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>

namespace reebquad {
namespace studio {

/// A message to a page. Of messages with the same key only the newest is worth sending; an empty key is
/// always worth it.
struct Message {
  std::string key;
  std::shared_ptr<const std::string> bytes;
  bool is_binary = false;
  /// Where `bytes` only say what changed since the message before with the same key: what to send if that was
  /// not sent.
  std::shared_ptr<const std::string> whole = nullptr;
};

/// The messages that a page has not taken yet. A page that is slow gets fewer of those that replace each
/// other, and one that takes nothing at all is given up.
class Outbox {
public:
  /// False if too many messages wait: the page is to be given up.
  bool push(Message message);
  bool empty() const { return m_messages.empty(); }
  Message pop();
  std::size_t size() const { return m_messages.size(); }

private:
  std::deque<Message> m_messages;
};

/// A page that is connected. The hub tells it messages; it sends them when it can.
class Client {
public:
  virtual ~Client() = default;
  virtual void send(Message message) = 0;

  /// The layers it was sent last, to send only what changed.
  std::map<std::string, std::shared_ptr<const std::string>> layers;
};

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_SERVER_CLIENT_H
