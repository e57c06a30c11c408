// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/Html_report.h"

#include "view/Assets.h"

#include <array>

namespace reebquad {
namespace studio {

using CGAL::Reeb_quadrangulation::Error_code;
using CGAL::Reeb_quadrangulation::make_error;
using CGAL::Reeb_quadrangulation::Result;

namespace {

constexpr std::size_t largest_surface = std::size_t(8) << 20;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

// Nothing in a script element may look like the end of it.
std::string escaped_json(const Json& json) {
  return replaced(json.dump(-1, ' ', false, Json::error_handler_t::replace), "<", "\\u003c");
}

std::string escaped_text(const std::string& text) {
  return replaced(replaced(text, "&", "&amp;"), "<", "&lt;");
}

constexpr std::array<const char*, 4> of_the_surface{"surface", "cuts", "field", "charts"};

bool is_too_large(const Layers& part) {
  std::size_t size = 0;
  for (const char* name : of_the_surface)
    if (const auto layer = part.find(name); layer != part.end()) size += layer->second->size();
  return size > largest_surface;
}

void append_layers(std::string& html, Layers part, std::size_t number) {
  if (is_too_large(part))
    for (const char* name : of_the_surface) part.erase(name);
  for (const auto& [name, bytes] : part)
    html += "<script type=\"application/octet-stream\" data-part=\"" + std::to_string(number) +
            "\" data-layer=\"" + name + "\">" + base64(*bytes) + "</script>\n";
}

} // namespace

std::string base64(const std::string& bytes) {
  const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t given = std::min<std::size_t>(3, bytes.size() - i);
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < given ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= given ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

Result<std::string> html_text(const Html_report& report) {
  const Asset* viewer = find_asset("/report.js");
  if (!viewer)
    return make_error(Error_code::impossible_request,
                      "an HTML report needs the page of the studio: install npm and build the program again");
  std::string html = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                     "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                     // The file asks for nothing outside itself, and could not.
                     "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src "
                     "'unsafe-inline'; "
                     "style-src 'unsafe-inline'; img-src data: blob:\">\n<title>";
  html += escaped_text(report.title) + " · reebquad</title>\n</head>\n<body>\n<div id=\"app\"></div>\n"
                                       "<noscript>This report needs JavaScript.</noscript>\n"
                                       "<script type=\"application/json\" id=\"facts\">";
  html += escaped_json(report.facts) + "</script>\n";
  for (std::size_t i = 0; i < report.parts.size(); ++i) append_layers(html, report.parts[i], i);
  html += "<script>" + replaced(std::string(viewer->bytes), "</script", "<\\/script") +
          "</script>\n</body>\n</html>\n";
  return html;
}

} // namespace studio
} // namespace reebquad
