// SPDX-License-Identifier: GPL-3.0-or-later
#include "server/Client.h"

#include <algorithm>

namespace reebquad {
namespace studio {

namespace {
constexpr std::size_t most_messages = 1000;
}

bool Outbox::push(Message message) {
  if (!message.key.empty()) {
    const auto same = [&](const Message& other) { return other.key == message.key; };
    const auto replaced = std::remove_if(m_messages.begin(), m_messages.end(), same);
    if (replaced != m_messages.end() && message.whole) message.bytes = message.whole;
    m_messages.erase(replaced, m_messages.end());
  }
  if (m_messages.size() >= most_messages) return false;
  m_messages.push_back(std::move(message));
  return true;
}

Message Outbox::pop() {
  Message first = std::move(m_messages.front());
  m_messages.pop_front();
  return first;
}

} // namespace studio
} // namespace reebquad
