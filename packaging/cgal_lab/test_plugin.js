// SPDX-License-Identifier: GPL-3.0-or-later
// For a demo that has opened one triangle mesh: Polyhedron_3 --no-debug-scripts MESH test_plugin.js
// 'qtscript:quit()'. An exception ends it with a failure.
function expect(holds, sentence) {
  if (!holds) throw sentence
}

function quads(count, effort, mirror) {
  return reeb_quadrangulation_plugin.quadrangulate(count, effort, 45, mirror, false)
}

expect(scene.numberOfEntries == 1, "one mesh is open")
expect(!quads(400, "hasty", "none"), "an effort that there is not is refused")
expect(!quads(400, "fast", "w"), "a mirror that there is not is refused")
expect(!quads(-5, "fast", "none"), "a count that there cannot be is refused")
expect(scene.numberOfEntries == 1, "what is refused makes no item")
expect(quads(400, "fast", "none"), "quads are made")
expect(scene.numberOfEntries == 2, "they are an item")
expect(!quads(400, "fast", "none"), "the item that is selected now has no triangles")
scene.setSelectedItem(0)
expect(quads(400, "fast", "auto"), "quads are made with a mirror")
expect(scene.numberOfEntries == 3, "they are another item")
print("the plugin does what it should")
