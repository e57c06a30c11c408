// SPDX-License-Identifier: GPL-3.0-or-later
#include "Batch_tables.h"

#include <CGAL/Reeb_quadrangulation/IO/read_file.h>

#include "view/Html_report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <map>

namespace reebquad {

namespace {

constexpr std::uint64_t largest_thumbnail = std::uint64_t(1) << 18;

std::string number(double value, int digits = 6) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return text.data();
}

/// A field of CSV. Programs of tables take what begins so for a formula: a path is the same with "./" in
/// front.
std::string field(std::string text, const char* guard) {
  if (!text.empty() && std::string("=+-@").find(text[0]) != std::string::npos) text.insert(0, guard);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += (text.empty() ? "" : "; ") + sentence;
  return text;
}

std::string outcome(const Batch_row& row) {
  return row.record ? row.record->outcome : "pending";
}

/// What needs a person first comes first.
int urgency(const Batch_row& row) {
  if (!row.record) return 1;
  if (row.record->is_failed()) return 0;
  return !row.record->is_good() ? 2 : !row.record->warnings.empty() ? 3 : 4;
}

std::string escaped(const std::string& text) {
  static const std::map<char, std::string> entities{
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}};
  std::string result;
  for (const char c : text) {
    const auto entity = entities.find(c);
    result += entity == entities.end() ? std::string(1, c) : entity->second;
  }
  return result;
}

/// A path as a link: what is no letter, digit or one of ./_- as %NN.
std::string link(const std::string& path) {
  const char* const digits = "0123456789ABCDEF";
  std::string result;
  for (const char c : path) {
    const unsigned char byte = static_cast<unsigned char>(c);
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string("./_-~").find(c) != std::string::npos;
    result += plain ? std::string(1, c) : std::string("%") + digits[byte >> 4] + digits[byte & 15];
  }
  return result;
}

constexpr const char* page_head = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy"
  content="default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:">
<title>reebquad batch</title>
<style>
body { font: 14px/1.45 system-ui, sans-serif; margin: 1.5em; color: #222; background: #fff; }
table { border-collapse: collapse; width: 100%; }
th { position: sticky; top: 0; background: #f1efea; text-align: left; cursor: pointer; white-space: nowrap; }
th[data-down]::after { content: " \25be"; } th[data-up]::after { content: " \25b4"; }
th, td { padding: .3em .6em; border-bottom: 1px solid #ddd; vertical-align: middle; }
td.n { text-align: right; font-variant-numeric: tabular-nums; }
td.t { max-width: 34em; overflow-wrap: anywhere; }
img { display: block; width: 120px; height: 96px; }
.failed { background: #fbe6e2; } .part, .pending { background: #fdf4dc; }
</style>
</head>
<body>
)";

constexpr const char* page_end = R"(</tbody>
</table>
<script>
const head = document.querySelectorAll("th"), body = document.querySelector("tbody");
head.forEach((cell, column) => cell.addEventListener("click", () => {
  const down = !("down" in cell.dataset);
  head.forEach(other => { delete other.dataset.down; delete other.dataset.up; });
  cell.dataset[down ? "down" : "up"] = "";
  const key = row => row.cells[column].dataset.key ?? row.cells[column].textContent;
  const compare = (a, b) => isNaN(a) || isNaN(b) || a === "" || b === "" ? (a < b ? -1 : a > b) : a - b;
  [...body.rows].sort((a, b) => (down ? 1 : -1) * compare(key(a), key(b))).forEach(row => body.append(row));
}));
</script>
</body>
</html>
)";

std::string thumbnail(const Batch_row& row) {
  const auto png = CGAL::Reeb_quadrangulation::read_file(row.folder + "/thumbnail.png", largest_thumbnail);
  if (!png) return {};
  return "<img alt=\"\" src=\"data:image/png;base64," + studio::base64(*png) + "\">";
}

std::string html_row(const Batch_row& row, const std::string& results) {
  static const Batch_record none;
  const Batch_record& r = row.record ? *row.record : none;
  const int order = urgency(row);
  const std::string kind = order == 0 ? "failed" : order == 1 ? "pending" : order == 2 ? "part" : "good";
  const std::string folder = std::filesystem::path(row.folder).lexically_relative(results).generic_string();
  const auto cell = [](const std::string& text) { return "<td class=\"n\">" + text + "</td>"; };
  // The text of a failure, or else of the warnings.
  const std::string said =
      r.sentence + (r.sentence.empty() || r.warnings.empty() ? "" : "; ") + joined(r.warnings);
  std::string html = "<tr class=\"" + kind + "\"><td data-key=\"\">" + thumbnail(row) +
                     "</td><td class=\"t\"><a href=\"./" + link(folder) + "\">" + escaped(row.job.name) +
                     "</a></td><td data-key=\"" + std::to_string(order) + "\">" + escaped(outcome(row)) +
                     "</td>";
  const bool has_quads = r.quads > 0;
  html += cell(r.faces > 0 ? std::to_string(r.faces) : "") + cell(has_quads ? std::to_string(r.quads) : "") +
          cell(has_quads ? std::to_string(r.extraordinary) : "") +
          cell(has_quads ? number(r.worst_jacobian, 3) : "") +
          cell(has_quads ? number(100 * r.distance, 3) : "") + cell(row.record ? number(r.seconds, 3) : "") +
          cell(row.record ? number(r.peak_megabytes, 3) : "");
  return html + "<td class=\"t\">" + escaped(said) + "</td></tr>\n";
}

} // namespace

std::string csv_table(const std::vector<Batch_row>& rows) {
  std::string csv =
      "name,outcome,exit_code,points,faces,components,quads,extraordinary_vertices,worst_scaled_jacobian,"
      "mean_scaled_jacobian,distance,seconds,cpu_seconds,peak_megabytes,sentence,warnings\r\n";
  for (const Batch_row& row : rows) {
    const Batch_record r = row.record.value_or(Batch_record());
    csv += field(row.job.name, "./") + ',' + outcome(row);
    for (const int value : {r.exit_code, r.points, r.faces, r.components, r.quads, r.extraordinary})
      csv += ',' + (row.record ? std::to_string(value) : "");
    for (const double value :
         {r.worst_jacobian, r.mean_jacobian, r.distance, r.seconds, r.cpu_seconds, r.peak_megabytes})
      csv += ',' + (row.record ? number(value) : "");
    csv += ',' + field(r.sentence, " ") + ',' + field(joined(r.warnings), " ") + "\r\n";
  }
  return csv;
}

std::string json_lines(const std::vector<Batch_row>& rows) {
  std::string text;
  for (const Batch_row& row : rows)
    text += row.record ? to_json_line(*row.record)
                       : nlohmann::ordered_json{{"name", row.job.name}, {"outcome", "pending"}}.dump() + '\n';
  return text;
}

std::string html_overview(std::vector<Batch_row> rows, const std::string& results, std::size_t limit) {
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Batch_row& a, const Batch_row& b) { return urgency(a) < urgency(b); });
  std::map<std::string, std::size_t> number_of;
  for (const Batch_row& row : rows) ++number_of[outcome(row)];
  std::string html = page_head + std::string("<h1>") + std::to_string(rows.size()) + " meshes</h1>\n<p>";
  for (const auto& [what, n] : number_of) html += std::to_string(n) + ' ' + escaped(what) + ". ";
  if (rows.size() > limit)
    html += "The first " + std::to_string(limit) + " are shown, failures first; batch.csv has all. ";
  html +=
      "A click on the head of a column sorts by it.</p>\n<table>\n<thead><tr><th>picture<th>mesh<th>outcome"
      "<th>faces<th>quads<th>extraordinary<th>worst scaled Jacobian<th>distance, % of the diagonal"
      "<th>seconds<th>MB<th>what was said</tr></thead>\n<tbody>\n";
  for (std::size_t i = 0; i < std::min(limit, rows.size()); ++i) html += html_row(rows[i], results);
  return html + page_end;
}

} // namespace reebquad
