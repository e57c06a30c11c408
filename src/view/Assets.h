// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_VIEW_ASSETS_H
#define REEBQUAD_VIEW_ASSETS_H

#include <string_view>
#include <vector>

namespace reebquad {
namespace studio {

/// A file of the page, compiled into the program.
struct Asset {
  std::string_view path; ///< "/index.html"
  std::string_view type; ///< "text/html; charset=utf-8"
  std::string_view bytes;
};

/// The files of the page; none if the program was built without it.
const std::vector<Asset>& assets();

/// Why the program has no page, as the end of a sentence ("npm was not installed"); empty if it has one.
const char* missing_page_reason();

/// The file that a request's path names ("/" is the page itself), or null. Only whole names are compared: a
/// path that is none of ours leads nowhere, whatever it contains.
const Asset* find_asset(std::string_view path);

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_VIEW_ASSETS_H
