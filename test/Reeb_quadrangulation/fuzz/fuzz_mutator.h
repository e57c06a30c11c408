// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FUZZ_MUTATOR_H
#define FUZZ_MUTATOR_H

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fuzz {

/// The files of a folder, in the order of their names.
inline std::vector<std::string> files_of(const std::string& folder) {
  std::vector<std::filesystem::path> paths;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> files;
  for (const auto& path : paths) {
    std::ifstream in(path, std::ios::binary);
    files.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return files;
}

/// Changes good files at random; the same seed gives the same changes. \pre there is a file
class Mutator {
public:
  Mutator(std::uint64_t seed, std::vector<std::string> files)
      : m_state(seed * 2654435761u + 88172645463325252u), m_files(std::move(files)) {}

  std::string next() {
    std::string file = m_files[below(m_files.size())];
    for (std::size_t steps = 1 + below(6); steps > 0; --steps) change(file);
    return file;
  }

private:
  // xorshift, after G. Marsaglia, "Xorshift RNGs", 2003
  std::size_t below(std::size_t n) {
    m_state ^= m_state << 13;
    m_state ^= m_state >> 7;
    m_state ^= m_state << 17;
    return std::size_t(m_state % n);
  }

  void change(std::string& file) {
    using namespace std::string_view_literals;
    static constexpr std::string_view words[] = {"0"sv,
                                                 "-1"sv,
                                                 "4294967296"sv,
                                                 "2147483647"sv,
                                                 "1e999"sv,
                                                 "nan"sv,
                                                 "-"sv,
                                                 "\\\n"sv,
                                                 "#"sv,
                                                 "\n"sv,
                                                 " 3 0 1 2 "sv,
                                                 "element"sv,
                                                 "list"sv,
                                                 "uint"sv,
                                                 "OFF "sv,
                                                 "f "sv,
                                                 "v 1 1 1\n"sv,
                                                 "\0\0\0\0"sv,
                                                 "\xff\xff\xff\xff"sv,
                                                 "solid "sv,
                                                 "facet "sv,
                                                 "end_header\n"sv,
                                                 "[[[["sv,
                                                 "{\"edit\":"sv,
                                                 "1e308"sv,
                                                 "\"\\ud800\""sv,
                                                 "null"sv,
                                                 "},{"sv,
                                                 "true"sv,
                                                 "max 1 0 0\n"sv};
    const std::size_t at = below(file.size() + 1), length = std::min(below(20), file.size() - at);
    switch (below(7)) {
    case 0: file.resize(at); break;
    case 1: file.erase(at, length); break;
    case 2: file.insert(at, file.substr(below(file.size() + 1), length)); break;
    case 3: file.insert(at, words[below(std::size(words))]); break;
    case 4: {
      const std::string& other = m_files[below(m_files.size())];
      const std::size_t from = below(other.size());
      file.replace(at, length, other.substr(from, below(60)));
      break;
    }
    case 5:
      if (at < file.size()) file[at] = char(file[at] ^ char(1 << below(8)));
      break;
    default:
      if (at < file.size()) file[at] = char(below(256));
      break;
    }
  }

  std::uint64_t m_state;
  std::vector<std::string> m_files;
};

} // namespace fuzz

#endif // FUZZ_MUTATOR_H
