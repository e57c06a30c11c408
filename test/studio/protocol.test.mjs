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
const { decodeFrame, patched, protocolVersion } = await import(`data:text/javascript;base64,${Buffer.from(code).toString("base64")}`);

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

/** The same for frames whose numbers have the same bits. */
const bitsOf = (frame) => [...frame.arrays].map(([name, array]) => [name, array.constructor.name, Buffer.from(array.buffer, array.byteOffset, array.byteLength).toString("hex")]);

for (const { about, before, patch, after } of vectors.patches)
  test(`what changed of a layer is put in: ${about}`, () => {
    const made = patched(decodeFrame(bufferOf(before)), decodeFrame(bufferOf(patch))), wanted = decodeFrame(bufferOf(after));
    assert.deepEqual(bitsOf(made), bitsOf(wanted));
    assert.deepEqual([made.layer, made.data, made.patch], [wanted.layer, wanted.data, undefined]);
  });

test("what changed of another layer is refused", () => {
  const [, { before, patch }] = vectors.patches;
  assert.throws(() => patched(undefined, decodeFrame(bufferOf(patch))));
  const shorter = decodeFrame(bufferOf(before));
  shorter.arrays.set("chart", shorter.arrays.get("chart").subarray(0, 50));
  assert.throws(() => patched(shorter, decodeFrame(bufferOf(patch))));
});

test("what is no frame is refused", () => {
  const good = vectors.frames[0].bytes;
  for (const bad of ["", "5251", "58515301", "52515301" + good.slice(8), good.slice(0, 40), good.slice(0, 8) + "ffffff7f" + good.slice(16)])
    assert.throws(() => decodeFrame(bufferOf(bad || "00")));
});
