// SPDX-License-Identifier: GPL-3.0-or-later
// The facts of a report, as the page reads them; doc/Reeb_quadrangulation/run_report.md describes them all.
import type { Check, FileFacts, State, Vector } from "../net/messages";

export interface StageTime {
  name: string;
  seconds: number;
  peak_megabytes: number;
}

export interface Range {
  minimum: number;
  mean: number;
  maximum: number;
}

export interface Facts {
  version: string;
  input: { file: string; points: number; faces: number };
  axis: Vector;
  mends: { text: string }[];
  components: {
    vertices: number;
    triangles: number;
    genus: number;
    quads: number;
    extrema?: unknown[];
    layout?: { minima: number; maxima: number; saddles: number; charts: unknown[]; reeb_loops: number };
    stages?: StageTime[];
  }[];
  certificate: NonNullable<State["certificate"]> & { interior_valences: Record<string, number>; boundary_valences: Record<string, number>; checks: Check[] };
  statistics: NonNullable<State["statistics"]> & { extraordinary_vertices: number; angle: Range; edge_length: Range; quad_area_ratio: number | null };
  stages?: StageTime[];
  edits?: { text: string; milliseconds: number }[];
}

/** What the parts that the report shares with the studio's page read. */
export function stateOf(facts: Facts): State {
  const { certificate, statistics, components } = facts;
  const sum = (f: (c: Facts["components"][number]) => number): number => components.reduce((total, c) => total + f(c), 0);
  const valenceSum = certificate.checks.find((c) => c.name === "valence_sum")?.expected ?? 0;
  const file: FileFacts = {
    name: facts.input.file.replace(/^.*\//, ""), points: facts.input.points, triangles: sum((c) => c.triangles), euler_characteristic: valenceSum / 4,
    genus: sum((c) => c.genus), boundary_loops: 0, quads: statistics.quads, edits: 0, digest: "", component: 1, components: [], mends: facts.mends.map((m) => m.text), refused: [], origin: [0, 0, 0], diagonal: 1, defects: [],
  };
  return {
    event: "state", revision: 1, file, last: null, finished: true, statistics, certificate,
    budget: { needed: valenceSum, interior: certificate.interior_valences, boundary: certificate.boundary_valences },
  };
}
