// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/Frame_patch.h"

#include "view/Frame.h"

#include <algorithm>
#include <map>

namespace reebquad {
namespace studio {

namespace {

constexpr double worth_while = 0.7; ///< of the whole message

/// How an array is made of an older one: what is copied, and the numbers that are new.
template <class T> struct Difference {
  std::vector<std::uint8_t> steps;
  std::vector<T> fresh;
};

/// Seven bits a byte, the lowest first; all but the last have the highest bit.
void append_number(std::vector<std::uint8_t>& bytes, std::uint64_t number) {
  for (; number >= 128; number >>= 7) bytes.push_back(std::uint8_t(number | 128));
  bytes.push_back(std::uint8_t(number));
}

void append_signed(std::vector<std::uint8_t>& bytes, std::int64_t number) {
  append_number(bytes, number < 0 ? 2 * std::uint64_t(-(number + 1)) + 1 : 2 * std::uint64_t(number));
}

/// Finds what of the new array stands in the old one: first where it would be if nothing was put in or taken
/// out, then, where the lengths say that something was, anywhere, by the blocks of the old array.
template <class T> class Comparison {
public:
  /// If it `repeats`, the new numbers of a step are all the same and stand once.
  Comparison(const std::vector<T>& before, const std::vector<T>& after, bool repeats)
      : m_before(before), m_after(after), m_repeats(repeats) {
    if (before.size() == after.size()) return;
    for (std::size_t at = 0; at + block <= before.size(); at += block)
      m_blocks.push_back({hash(before.data() + at), at});
    std::sort(m_blocks.begin(), m_blocks.end());
  }

  Difference<T> run() const {
    Difference<T> result;
    std::size_t from = 0, at = 0; // in the old array, in the new one
    while (at < m_after.size()) {
      std::size_t source = from, length = 0, fresh = 0;
      if (stands(from, at, source)) length = common(source, at);
      append_number(result.steps, length);
      if (length > 0) append_signed(result.steps, std::int64_t(source) - std::int64_t(from));
      from = source + length;
      at += length;
      while (at + fresh < m_after.size() && !stands(from + fresh, at + fresh, source) &&
             !(m_repeats && m_after[at + fresh] != m_after[at]))
        ++fresh;
      append_number(result.steps, fresh);
      const auto begin = m_after.begin() + std::ptrdiff_t(at);
      result.fresh.insert(result.fresh.end(), begin,
                          begin + std::ptrdiff_t(m_repeats ? std::min<std::size_t>(fresh, 1) : fresh));
      from += fresh;
      at += fresh;
    }
    return result;
  }

private:
  static constexpr std::size_t block = 8;
  /// A copy costs a few bytes: fewer numbers than these are not worth it.
  static constexpr std::size_t least = sizeof(T) == 1 ? 6 : 2;

  static std::uint64_t hash(const T* values) {
    std::uint64_t h = 14695981039346656037u;
    for (std::size_t i = 0; i < block; ++i) h = (h ^ std::uint64_t(values[i])) * 1099511628211u;
    return h;
  }

  std::size_t common(std::size_t from, std::size_t at) const {
    std::size_t n = 0;
    while (from + n < m_before.size() && at + n < m_after.size() && m_before[from + n] == m_after[at + n])
      ++n;
    return n;
  }

  /// Whether what follows in the new array stands in the old one, and where.
  bool stands(std::size_t from, std::size_t at, std::size_t& source) const {
    source = from;
    if (const std::size_t n = common(from, at); n >= least || (n > 0 && at + n == m_after.size()))
      return true;
    if (m_blocks.empty() || at + block > m_after.size()) return false;
    // The first such block from there on, else the first at all.
    const std::uint64_t wanted = hash(m_after.data() + at);
    auto found = std::lower_bound(m_blocks.begin(), m_blocks.end(), std::make_pair(wanted, from));
    if (found == m_blocks.end() || found->first != wanted)
      found = std::lower_bound(m_blocks.begin(), m_blocks.end(), std::make_pair(wanted, std::size_t(0)));
    if (found == m_blocks.end() || found->first != wanted) return false;
    source = found->second;
    return common(source, at) >= block;
  }

  const std::vector<T>&m_before, &m_after;
  bool m_repeats;
  std::vector<std::pair<std::uint64_t, std::size_t>>
      m_blocks; ///< hash and place of the blocks of the old array
};

/// What most of the places with a number have instead of it now, where that is another one: a chart that is
/// cut gets a new identity, and so all its faces have.
std::vector<std::pair<std::uint32_t, std::uint32_t>> renamed(const std::vector<std::uint32_t>& before,
                                                             const std::vector<std::uint32_t>& after) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> result;
  if (before.size() != after.size()) return result;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> number;
  for (std::size_t i = 0, j = 0; i < before.size(); i = j) {
    while (j < before.size() && before[j] == before[i] && after[j] == after[i]) ++j;
    number[{before[i], after[i]}] += j - i;
  }
  for (auto i = number.begin(); i != number.end();) {
    auto most = i;
    const std::uint32_t old = i->first.first;
    for (; i != number.end() && i->first.first == old; ++i)
      if (i->second > most->second) most = i;
    if (most->first.second != old) result.push_back(most->first);
  }
  return result;
}

template <class T> void add_steps(Frame& frame, const std::string& name, const Difference<T>& difference) {
  frame.add(name + ".steps", difference.steps);
  frame.add(name, difference.fresh);
}

// Numbers are compared by their bits: -0 is not 0, and what is not a number is itself.
void add_difference(Frame& frame, const std::string& name, std::vector<std::uint32_t> before,
                    const std::vector<std::uint32_t>& after, bool are_names) {
  if (are_names) {
    const auto names = renamed(before, after);
    std::vector<std::uint32_t> from, to;
    for (const auto& [old, now] : names) {
      from.push_back(old);
      to.push_back(now);
    }
    if (!names.empty()) {
      frame.add(name + ".from", from);
      frame.add(name + ".to", to);
      for (std::uint32_t& value : before) {
        const auto at = std::lower_bound(from.begin(), from.end(), value);
        if (at != from.end() && *at == value) value = to[std::size_t(at - from.begin())];
      }
    }
  }
  add_steps(frame, name, Comparison<std::uint32_t>(before, after, are_names).run());
}

} // namespace

std::shared_ptr<const std::string> frame_patch(const std::string& before, const std::string& after) {
  const Frame_view old(before), now(after);
  Frame frame(now.header["layer"]);
  frame.data = now.header["data"];
  frame.patch = Json::array();
  for (const Json& array : now.header["arrays"]) {
    const std::string name = array["name"], type = array["type"];
    frame.patch.push_back({{"name", name}, {"type", type}, {"length", array["length"]}});
    if (type == "u8")
      add_steps(frame, name, Comparison<std::uint8_t>(old.bytes(name), now.bytes(name), false).run());
    else
      add_difference(frame, name, old.words(name), now.words(name), type == "i32");
  }
  auto bytes = frame.encode();
  return double(bytes->size()) < worth_while * double(after.size()) ? bytes : nullptr;
}

} // namespace studio
} // namespace reebquad
