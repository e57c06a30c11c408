// SPDX-License-Identifier: GPL-3.0-or-later
// The page reads binary messages as the test vectors say; the program's side reads the same file.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { pageModules } from "./harness.mjs";

const here = (name) => new URL(name, import.meta.url);
const vectors = JSON.parse(readFileSync(here("vectors.json"), "utf8"));
const source = readFileSync(here("../../src/studio/web/source/net/frame.ts"), "utf8");
const { code } = pageModules("vite").transformWithEsbuild ? await pageModules("vite").transformWithEsbuild(source, "frame.ts") : {};
const { decodeFrame, protocolVersion } = await import(`data:text/javascript;base64,${Buffer.from(code).toString("base64")}`);

const bufferOf = (hex) => Uint8Array.from(hex.match(/../g), (digits) => parseInt(digits, 16)).buffer;

test("both sides speak the same version", () => assert.equal(protocolVersion, vectors.version));

for (const vector of vectors.frames)
  test(`a frame ${vector.layer} is read`, () => {
    const frame = decodeFrame(bufferOf(vector.bytes));
    assert.equal(frame.layer, vector.layer);
    assert.deepEqual(frame.data, vector.data);
    assert.equal(frame.arrays.size, vector.arrays.length);
    for (const array of vector.arrays) assert.deepEqual([...frame.arrays.get(array.name)], array.values);
  });

test("what is no frame is refused", () => {
  const good = vectors.frames[0].bytes;
  for (const bad of ["", "5251", "58515301", "52515302" + good.slice(8), good.slice(0, 40), good.slice(0, 8) + "ffffff7f" + good.slice(16)])
    assert.throws(() => decodeFrame(bufferOf(bad || "00")));
});
