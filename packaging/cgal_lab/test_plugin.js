// SPDX-License-Identifier: GPL-3.0-or-later
// For a demo that has opened one small triangle mesh that is its own mirror image, README.md tells how.
// An exception ends the demo with a failure.
function expect(holds, sentence) {
  if (!holds) throw sentence
}

function console_text() {
  return main_window.consoleDockWidget.dockWidgetContents.consoleTextEdit.plainText
}

// Runs the plugin; what it returns, and what it says in the demo's console.
function quadrangulate(count, effort, mirror, item_features) {
  var before = console_text().length
  var made = reeb_quadrangulation_plugin.quadrangulate(count, effort, 45, mirror, item_features === true)
  return { made: made, said: console_text().substr(before) }
}

function expect_refusal(run, sentence) {
  expect(!run.made, "refused: " + sentence)
  expect(run.said.indexOf("ERROR: Quadrangulate (Reeb atlas): " + sentence) >= 0,
         "the console says '" + sentence + "', not: " + run.said)
}

// The certificate passes only where all faces are quads, and of a mesh with other faces there is none.
function expect_quads(run, items) {
  var passed = /INFO: (Certificate passed: (\d+) quads.*)/.exec(run.said)
  expect(run.made && passed && run.said.indexOf("ERROR") < 0, "quads are certified, not: " + run.said)
  expect(passed[2] > 200 && passed[2] < 800, "about 400 quads are made: " + passed[2])
  expect(scene.numberOfEntries == items, "they are an item of their own")
  print(passed[1])
  return passed[2]
}

expect(scene.numberOfEntries == 1, "one mesh is open")
expect_refusal(quadrangulate(400, "hasty", "none"), "there is no effort 'hasty'")
expect_refusal(quadrangulate(400, "fast", "w"), "there is no mirror 'w'")
expect_refusal(quadrangulate(-5, "fast", "none"), "")
expect_refusal(quadrangulate(400, "fast", "none", true), "no edge of the item is marked as a feature")
expect_refusal(quadrangulate(400, "fast", "x", true), "features of the item cannot be kept together")
expect(scene.numberOfEntries == 1, "what is refused makes no item")

expect_quads(quadrangulate(400, "fast", "none"), 2)
expect_refusal(quadrangulate(400, "fast", "none"), "no triangle mesh is selected") // but the new item
scene.setSelectedItem(0)
expect(expect_quads(quadrangulate(400, "fast", "auto"), 3) % 2 == 0, "a mirrored mesh has two halves")
print("the plugin does what it should")
