// SPDX-License-Identifier: GPL-3.0-or-later
#include "Batch_jobs.h"

#include "Failure.h"

#include <CGAL/Reeb_quadrangulation/IO/read_polygon_soup.h>

#include "session/Store.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

namespace reebquad {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_part = 200; // of a path; file systems take 255 bytes

/// The number of bytes of the UTF-8 character at the front of `text` that prints; 0 if there is none.
std::size_t printable_size(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char c = byte(0);
  if (c < 0x80) return c >= 32 && c != 127 && c != '\\' ? 1 : 0;
  const std::size_t size = c >= 0xf0 ? 4 : c >= 0xe0 ? 3 : 2;
  if (c < 0xc2 || c > 0xf4 || text.size() < size) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  const unsigned char second = byte(1);
  if ((c == 0xc2 && second < 0xa0) || (c == 0xe0 && second < 0xa0) || (c == 0xed && second >= 0xa0)) return 0;
  // Marks that turn the direction of the text around them, and the separators of lines.
  if (c == 0xe2 && (second == 0x80 || second == 0x81) && byte(2) >= 0xa6 && byte(2) <= 0xae) return 0;
  if (c == 0xe2 && second == 0x80 && byte(2) >= 0x8e && byte(2) <= 0x8f) return 0;
  return (c == 0xf0 && second < 0x90) || (c == 0xf4 && second >= 0x90) ? 0 : size;
}

/// Inverse of `one_line()`.
std::string exact(std::string_view line) {
  std::string text;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::string digits(line.substr(std::min(line.size(), i + 2), 2));
    const bool is_code = line[i] == '\\' && digits.size() == 2 && line[i + 1] == 'x' &&
                         digits.find_first_not_of("0123456789abcdef") == std::string::npos;
    text += is_code ? char(std::stoi(digits, nullptr, 16)) : line[i];
    if (is_code) i += 3;
  }
  return text;
}

/// A name that file systems take, where a part of the path is too long.
std::string shortened(const std::string& name) {
  std::string result;
  for (const fs::path& whole : fs::path(name)) {
    std::string part = whole.string();
    if (part.size() > longest_part) {
      std::size_t size = longest_part - 32;
      while ((part[size] & 0xc0) == 0x80) --size;
      part = part.substr(0, size) + '~' + studio::digest(part);
    }
    result += (result.empty() ? "" : "/") + part;
  }
  return result;
}

fs::path absolute_path(const std::string& input) {
  const fs::path path = fs::absolute(input).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

bool is_mesh_file(const fs::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  if (extension.size() < 2) return false;
  const std::string known =
      " off obj ply stl glb gltf " + CGAL::Reeb_quadrangulation::other_mesh_formats() + ' ';
  return known.find(' ' + extension.substr(1) + ' ') != std::string::npos;
}

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw Failure(Exit_code::unreadable_file, one_line(path.string()) + ": " + why);
}

class Finder {
public:
  explicit Finder(const std::string& results) : m_results(results) {}

  void add(const std::string& input) {
    const fs::path path = absolute_path(input);
    std::error_code failed;
    if (fs::is_directory(path, failed))
      walk(path);
    else if (fs::exists(path, failed))
      take(path, path.filename().string());
    else
      refuse(input, "there is no such file or folder");
  }

  std::vector<Batch_job> jobs() && {
    make_distinct();
    const auto before = [](const Batch_job& a, const Batch_job& b) { return a.name < b.name; };
    std::sort(m_jobs.begin(), m_jobs.end(), before);
    return std::move(m_jobs);
  }

private:
  void walk(const fs::path& folder) {
    std::error_code failed, ignored;
    fs::recursive_directory_iterator at(folder, failed), end;
    if (failed) refuse(folder, "the folder cannot be read: " + failed.message());
    while (at != end) {
      const fs::directory_entry entry = *at;
      const bool is_hidden = entry.path().filename().string().front() == '.';
      if (entry.is_directory(ignored) && (is_hidden || fs::equivalent(entry.path(), m_results, ignored)))
        at.disable_recursion_pending();
      else if (!is_hidden && is_mesh_file(entry.path()) && entry.is_regular_file(ignored))
        take(entry.path(), (folder.filename() / entry.path().lexically_relative(folder)).string());
      at.increment(failed);
      if (failed) refuse(entry.path(), "a folder here cannot be read: " + failed.message());
    }
  }

  void take(const fs::path& file, const std::string& name) {
    if (m_taken.insert(file.string()).second) m_jobs.push_back({shortened(one_line(name)), file.string()});
  }

  void make_distinct() {
    std::map<std::string, int> number; // of jobs with that name
    for (const Batch_job& job : m_jobs) ++number[job.name];
    std::set<std::string> folders; // that others will lie in
    for (const Batch_job& job : m_jobs)
      for (std::size_t slash = job.name.find('/'); slash != std::string::npos;
           slash = job.name.find('/', slash + 1))
        folders.insert(job.name.substr(0, slash));
    for (Batch_job& job : m_jobs)
      if (number[job.name] > 1 || folders.count(job.name) > 0) job.name += '~' + studio::digest(job.file);
  }

  fs::path m_results;
  std::set<std::string> m_taken; ///< files
  std::vector<Batch_job> m_jobs;
};

/// The file that the name tells, if it tells one.
std::optional<std::string> file_of(const std::vector<std::string>& inputs, const std::string& name) {
  const fs::path wanted = exact(name);
  const bool is_plain = !wanted.empty() && wanted.is_relative() && wanted.lexically_normal() == wanted &&
                        *wanted.begin() != ".." && shortened(one_line(wanted.string())) == name;
  if (!is_plain) return std::nullopt;
  std::optional<std::string> found;
  std::set<std::string> seen;
  for (const std::string& input : inputs) {
    const fs::path path = absolute_path(input);
    std::error_code failed;
    const fs::path file = path.parent_path() / wanted;
    if (*wanted.begin() != path.filename() || !fs::is_regular_file(file, failed)) continue;
    if (!seen.insert(file.string()).second) continue;
    if (found) return std::nullopt;
    found = file.string();
  }
  return found;
}

} // namespace

std::string one_line(std::string_view text) {
  const char* const digits = "0123456789abcdef";
  std::string line;
  while (!text.empty()) {
    const std::size_t size = printable_size(text);
    const unsigned char c = static_cast<unsigned char>(text[0]);
    line +=
        size > 0 ? std::string(text.substr(0, size)) : std::string("\\x") + digits[c >> 4] + digits[c & 15];
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return line;
}

std::vector<Batch_job> find_jobs(const std::vector<std::string>& inputs, const std::string& results) {
  Finder finder(results);
  for (const std::string& input : inputs) finder.add(input);
  return std::move(finder).jobs();
}

std::vector<Batch_job> find_named_jobs(const std::vector<std::string>& inputs, const std::string& results,
                                       const std::vector<std::string>& names) {
  std::vector<Batch_job> jobs, all;
  for (const std::string& name : names) {
    if (const std::optional<std::string> file = file_of(inputs, name)) {
      jobs.push_back({name, *file});
      continue;
    }
    if (all.empty()) all = find_jobs(inputs, results);
    const auto job = std::find_if(all.begin(), all.end(), [&](const Batch_job& j) { return j.name == name; });
    if (job == all.end()) throw Usage_error("--one: the inputs have no mesh '" + one_line(name) + "'");
    jobs.push_back(*job);
  }
  return jobs;
}

bool is_in_share(const Batch_job& job, int share, int shares) {
  return std::stoull(studio::digest(job.name), nullptr, 16) % std::uint64_t(shares) + 1 ==
         std::uint64_t(share);
}

} // namespace reebquad
