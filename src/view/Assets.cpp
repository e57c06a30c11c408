// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/Assets.h"

namespace reebquad {
namespace studio {

const Asset* find_asset(std::string_view path) {
  if (path == "/") path = "/index.html";
  for (const Asset& asset : assets())
    if (asset.path == path) return &asset;
  return nullptr;
}

} // namespace studio
} // namespace reebquad
