// SPDX-License-Identifier: GPL-3.0-or-later
// node page_packages.mjs NPM: the page's packages, installed by that npm ("own", or a version that the registry has) into empty
// folders with empty caches, under configurations that users have. Ends with 77, for "skipped", where that npm cannot be had.
import assert from "node:assert";
import { spawnSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const { CMAKE, NPM, STUDIO_DIR, WORK_DIR } = process.env;
const version = process.argv[2];
const web = join(STUDIO_DIR, "web");
const lock = JSON.parse(readFileSync(join(web, "package-lock.json"), "utf8"));

// What a user's npm may have been told. The last one leaves out what the page is built with, and writes no locks.
const configurations = {
  default: "",
  without_resolved: "omit-lockfile-registry-resolved=true\n",
  production: "omit=dev\npackage-lock=false\n",
};

function skip(reason) {
  console.log(`SKIP: ${reason}`);
  process.exit(77);
}

/** The words that start the npm of `version`. */
function findNpm() {
  if (version === "own") return [NPM];
  const folder = join(WORK_DIR, "npm");
  const got = spawnSync(NPM, ["install", "--prefix", folder, "--no-save", "--no-audit", "--no-fund", `npm@${version}`], { encoding: "utf8" });
  if (got.status !== 0) skip(`npm ${version} could not be had from the registry:\n${got.stderr}`);
  const npm = [process.execPath, join(folder, "node_modules", "npm", "bin", "npm-cli.js")];
  const told = spawnSync(npm[0], [npm[1], "--version"], { encoding: "utf8" });
  if (told.status !== 0) skip(`npm ${version} does not run with node ${process.version}:\n${told.stderr}`);
  console.log(`npm ${told.stdout.trim()}, node ${process.version}`);
  return npm;
}

/** Runs a script of the studio with npm in a home, with a cache and a configuration, of its own. */
function runScript(script, npm, name, variables) {
  const home = join(WORK_DIR, name, "home");
  mkdirSync(home, { recursive: true });
  writeFileSync(join(home, "npmrc"), configurations[name] ?? "");
  const kept = Object.entries(process.env).filter(([key]) => !/^npm_config_(cache|userconfig|omit|package_lock)/i.test(key));
  const env = { ...Object.fromEntries(kept), HOME: home, npm_config_cache: join(home, "cache"), npm_config_userconfig: join(home, "npmrc") };
  const defined = Object.entries({ NPM: npm.join(";"), ...variables }).map(([key, value]) => `-D${key}=${value}`);
  const run = spawnSync(CMAKE, [...defined, "-P", join(STUDIO_DIR, script)], { encoding: "utf8", env });
  return { status: run.status, output: run.stdout + run.stderr };
}

/** Every installed package is one of the lock's: its version, and the integrity that npm found it to have. */
function checkInstalled(folder) {
  assert.deepStrictEqual(JSON.parse(readFileSync(join(folder, "package-lock.json"), "utf8")), lock, "the lock was written to");
  const installed = JSON.parse(readFileSync(join(folder, "node_modules", ".package-lock.json"), "utf8")).packages;
  for (const [place, { version: got, integrity }] of Object.entries(installed)) {
    assert.strictEqual(got, lock.packages[place]?.version, place);
    assert.strictEqual(integrity, lock.packages[place].integrity, place);
  }
  for (const name of Object.keys({ ...lock.packages[""].dependencies, ...lock.packages[""].devDependencies }))
    assert(existsSync(join(folder, "node_modules", name, "package.json")), `${name} was not installed`);
}

function testInstall(npm, name) {
  const folder = join(WORK_DIR, name, "page");
  mkdirSync(folder, { recursive: true });
  for (const file of ["package.json", "package-lock.json"]) cpSync(join(web, file), join(folder, file));
  const { status, output } = runScript("install_page_packages.cmake", npm, name, { WORK_DIR: folder });
  assert.strictEqual(status, 0, output);
  checkInstalled(folder);
  console.log(`${name}: installed`);
}

function testPage(npm) {
  const folder = join(WORK_DIR, "default", "page");
  const file = join(WORK_DIR, "page.cpp");
  const { status, output } = runScript("make_page.cmake", npm, "default",
    { WITH_PAGE: "ON", REQUIRED: "ON", SOURCE_DIR: web, WORK_DIR: folder, OUTPUT: file });
  assert.strictEqual(status, 0, output);
  checkInstalled(folder);
  const page = readFileSync(file, "utf8");
  for (const name of ["/index.html", "/report.js"]) assert(page.includes(`{"${name}", `), `${name} is not in the page`);
  console.log("the page was built");
}

/** A package whose bytes are not the ones that the lock names is refused: by ON loudly, by AUTO with the reason in the program. */
function testForeignPackage(npm) {
  const source = join(WORK_DIR, "foreign", "web");
  cpSync(web, source, { recursive: true });
  const other = structuredClone(lock);
  other.packages["node_modules/three-mesh-bvh"].integrity = lock.packages["node_modules/three"].integrity;
  writeFileSync(join(source, "package-lock.json"), JSON.stringify(other, null, 2));
  const file = join(WORK_DIR, "foreign.cpp");
  for (const required of ["ON", "AUTO"]) {
    const { status, output } = runScript("make_page.cmake", npm, "foreign",
      { WITH_PAGE: "ON", REQUIRED: required, SOURCE_DIR: source, WORK_DIR: join(WORK_DIR, "foreign", "page"), OUTPUT: file });
    assert.strictEqual(status === 0, required === "AUTO", output);
    assert(output.includes("EINTEGRITY"), output);
    assert.strictEqual(existsSync(file), required === "AUTO");
  }
  assert(readFileSync(file, "utf8").includes('return "npm could not install the packages of the page"'));
  console.log("a package with other bytes was refused");
}

/** The lock has each package that any platform needs, by its integrity and without the host that it came from. */
function testLock() {
  const manifest = JSON.parse(readFileSync(join(web, "package.json"), "utf8"));
  assert.deepStrictEqual(lock.packages[""].dependencies, manifest.dependencies);
  assert.deepStrictEqual(lock.packages[""].devDependencies, manifest.devDependencies);
  for (const [place, entry] of Object.entries(lock.packages)) {
    assert(!("resolved" in entry), `${place} names a host`);
    assert(place === "" || /^sha512-/.test(entry.integrity), `${place} has no integrity`);
    for (const name of Object.keys({ ...entry.dependencies, ...entry.optionalDependencies }))
      assert(lock.packages[`${place}/node_modules/${name}`] ?? lock.packages[`node_modules/${name}`], `${name} of ${place} is not in the lock`);
  }
}

rmSync(WORK_DIR, { recursive: true, force: true });
mkdirSync(WORK_DIR, { recursive: true });
testLock();
const npm = findNpm();
if (version === "own") {
  testForeignPackage(npm);
} else {
  for (const name of Object.keys(configurations)) testInstall(npm, name);
  // The oldest one also makes the page; the program's own page was made by the machine's.
  if (version !== "latest") testPage(npm);
}
rmSync(WORK_DIR, { recursive: true, force: true });
