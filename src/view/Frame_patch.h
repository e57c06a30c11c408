// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_VIEW_FRAME_PATCH_H
#define REEBQUAD_VIEW_FRAME_PATCH_H

#include <memory>
#include <string>

namespace reebquad {
namespace studio {

/// The binary message that makes the layer `after` of the layer `before`, which the page has: only what
/// changed is in it, as src/studio/protocol.md describes it. Null if it would not be much shorter than
/// `after`. O(size of both). \pre both are messages that `Frame` encoded, of the same layer.
std::shared_ptr<const std::string> frame_patch(const std::string& before, const std::string& after);

} // namespace studio
} // namespace reebquad

#endif // REEBQUAD_VIEW_FRAME_PATCH_H
