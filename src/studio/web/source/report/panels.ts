// SPDX-License-Identifier: GPL-3.0-or-later
// The words and numbers of a report.
import type { Check } from "../net/messages";
import { h, readable } from "../ui/dom";
import { time } from "../ui/history_panel";
import type { Facts, Range, StageTime } from "./facts";

const marks: Record<Check["status"], string> = { passed: "✓", failed: "✗", not_checked: "·" };

/** What each check says where it passed. */
const meanings: Record<string, string> = {
  all_quads: "Every face has four different corners.",
  finite_points: "Every coordinate is a number.",
  no_unreferenced_vertices: "Every vertex belongs to a quad.",
  manifold_edges: "At most two quads meet at an edge.",
  manifold_vertices: "The quads around each vertex form one fan.",
  oriented: "Neighbours have the same front side.",
  watertight: "There are holes only where the surface has them.",
  components: "There are as many parts as the surface has.",
  euler_characteristic: "The mesh has the handles of the surface, no more and no fewer.",
  valences: "The extraordinary vertices are those that the design predicts.",
  valence_sum: "The valences add up to what the surface prescribes.",
  outward: "The quads face the way the surface does.",
  no_inverted_quads: "No quad is folded.",
  no_self_intersections: "No two quads pass through each other.",
  distance: "The quads lie on the surface.",
};

export function certificatePanel(facts: Facts): HTMLElement {
  const { certificate } = facts;
  const row = (check: Check): HTMLElement =>
    h(
      "li", { className: `check ${check.status}`, "data-check": check.name }, h("span", { className: "mark" }, marks[check.status]),
      h("div", {}, h("strong", {}, check.name.replaceAll("_", " ")), h("p", {}, check.message || meanings[check.name] || "")),
    );
  const verdict = certificate.strictly_valid ? "Valid, also in the strict sense." : certificate.passed ? "Valid, with the remarks below." : "Not valid.";
  const warnings = certificate.warnings.map((w) =>
    h(
      "li", { className: "check failed", "data-warning": w.name }, h("span", { className: "mark" }, "!"),
      h("div", {}, h("strong", {}, w.name.replaceAll("_", " ")), h("p", {}, w.text)),
    ),
  );
  const kept = certificate.shape && h("p", { className: "kept" }, `Kept of the shape: ${certificate.shape.summary}.`);
  return h("div", {}, h("p", {}, verdict), kept, h("ul", { className: "checks" }, ...warnings, ...certificate.checks.map(row)));
}

export function statisticsPanel(facts: Facts): HTMLElement {
  const s = facts.statistics, shape = facts.certificate.shape;
  const range = (r: Range): string => `${readable(r.minimum)} … ${readable(r.mean)} … ${readable(r.maximum)}`;
  const rows: [string, string][] = [
    ["quads", readable(s.quads)], ["vertices", readable(s.vertices)], ["extraordinary vertices", readable(s.extraordinary_vertices)],
    ["angles", range(s.angle) + "°"], ["edge lengths", range(s.edge_length)], ["scaled Jacobian", range(s.scaled_jacobian)],
    ["folded quads", readable(s.inverted_quads)],
  ];
  if (s.quad_area_ratio !== null) rows.push(["largest quad / smallest", readable(s.quad_area_ratio)]);
  if (shape) {
    const percent = (part: number): string => `${(100 * part).toPrecision(2)} % of the diagonal`;
    rows.push(["distance, mean", percent(Math.max(shape.from_quads.mean, shape.from_input.mean))], ["distance, most", percent(shape.bound)]);
  }
  return h("div", {}, table(rows), h("p", { className: "note" }, "Three numbers are the least, the mean and the greatest."));
}

export function valencesPanel(facts: Facts): HTMLElement {
  const rows: [string, string][] = [];
  const add = (valences: Record<string, number>, where: string): void => {
    for (const [valence, number] of Object.entries(valences)) rows.push([`${valence} edges${where}`, readable(number)]);
  };
  add(facts.certificate.interior_valences, "");
  add(facts.certificate.boundary_valences, ", on the boundary");
  return h("div", {}, table(rows));
}

export function designPanel(facts: Facts): HTMLElement {
  const parts = facts.components.map((c, i) => {
    const rows: [string, string][] = [["triangles", readable(c.triangles)], ["handles", readable(c.genus)], ["quads", readable(c.quads)]];
    if (c.layout)
      rows.push(["minima, saddles, maxima", `${c.layout.minima}, ${c.layout.saddles}, ${c.layout.maxima}`], ["charts", readable(c.layout.charts.length)]);
    return h("section", {}, facts.components.length > 1 && h("h3", {}, `Part ${i + 1}`), table(rows));
  });
  return h("div", {}, ...parts, ...facts.mends.map((m) => h("p", { className: "note" }, `Mended: ${m.text}`)));
}

/** The time of each stage as a bar; stages of the same name in several parts are added up. */
export function stagesPanel(facts: Facts): HTMLElement | null {
  const all: StageTime[] = [...(facts.stages?.slice(0, 2) ?? []), ...facts.components.flatMap((c) => c.stages ?? []), ...(facts.stages?.slice(2) ?? [])];
  if (all.length === 0) return null;
  const sums = new Map<string, number>();
  for (const stage of all) sums.set(stage.name, (sums.get(stage.name) ?? 0) + stage.seconds);
  const most = Math.max(...sums.values(), 1e-9), total = [...sums.values()].reduce((a, b) => a + b, 0);
  const bar = ([name, seconds]: [string, number]): HTMLElement => {
    const fill = h("span", { className: "stage-fill" });
    fill.style.width = `${(100 * seconds) / most}%`;
    return h("div", { className: "stage" }, h("span", { className: "name" }, name), h("span", { className: "stage-track" }, fill), h("span", { className: "time" }, time(1000 * seconds)));
  };
  return h("div", {}, ...[...sums].map(bar), h("p", { className: "note" }, `${time(1000 * total)} in all, at most ${readable(Math.round(Math.max(...all.map((s) => s.peak_megabytes))))} MB.`));
}

export function editsPanel(facts: Facts): HTMLElement | null {
  if (!facts.edits?.length) return null;
  return h("ol", { className: "edits" }, ...facts.edits.map((e) => h("li", {}, e.text, " ", h("span", { className: "time" }, time(e.milliseconds)))));
}

function table(rows: [string, string][]): HTMLElement {
  return h("table", { className: "numbers" }, h("tbody", {}, ...rows.map(([name, value]) => h("tr", {}, h("th", { scope: "row" }, name), h("td", {}, value)))));
}
