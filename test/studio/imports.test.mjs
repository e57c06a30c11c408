// SPDX-License-Identifier: GPL-3.0-or-later
// The page's files import one another without a circle, types too, and nobody but the entry knows app.ts.
import assert from "node:assert";
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { dirname, join, relative } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const source = join(dirname(fileURLToPath(import.meta.url)), "../../src/studio/web/source");

/** For each file, the files of the page that it names. */
function readImports(folder) {
  const imports = new Map();
  for (const entry of readdirSync(folder, { recursive: true, encoding: "utf8" })) {
    if (!entry.endsWith(".ts")) continue;
    const text = readFileSync(join(folder, entry), "utf8");
    const named = [...text.matchAll(/(?:from|import|import\()\s*"(\.[^"]*)"/g)].map((match) => match[1]);
    const paths = named.map((name) => relative(folder, join(folder, dirname(entry), name)));
    imports.set(entry, paths.map((path) => `${path}.ts`).filter((path) => existsSync(join(folder, path))));
  }
  return imports;
}

/** A path from a file to itself, or null. */
function findCircle(imports) {
  const done = new Set();
  const walk = (file, path) => {
    if (path.includes(file)) return [...path.slice(path.indexOf(file)), file];
    if (done.has(file)) return null;
    for (const next of imports.get(file) ?? []) {
      const circle = walk(next, [...path, file]);
      if (circle) return circle;
    }
    done.add(file);
    return null;
  };
  for (const file of imports.keys()) {
    const circle = walk(file, []);
    if (circle) return circle;
  }
  return null;
}

test("a circle is found where there is one", () => {
  assert.deepStrictEqual(findCircle(new Map([["a", ["b"]], ["b", ["c"]], ["c", ["b"]]])), ["b", "c", "b"]);
  assert.strictEqual(findCircle(new Map([["a", ["b", "c"]], ["b", ["c"]], ["c", []]])), null);
});

test("the page's files import one another without a circle", () => {
  const imports = readImports(source);
  assert((imports.get("main.ts") ?? []).includes("app.ts"), "the imports are read");
  assert.strictEqual(findCircle(imports), null);
});

test("app.ts is imported by the entry alone", () => {
  const importers = [...readImports(source)].filter(([, named]) => named.includes("app.ts")).map(([file]) => file);
  assert.deepStrictEqual(importers, ["main.ts"]);
});
