// SPDX-License-Identifier: GPL-3.0-or-later
// The text messages, as src/studio/protocol.md describes them.

export type Vector = [number, number, number];

export interface Edit {
  edit: string;
  [member: string]: unknown;
}

export interface Failure {
  code: string;
  cancelled: boolean;
  message: string;
  element: string;
  index: number;
}

/** A connected component of the file. */
export interface PartFacts {
  points: number;
  triangles: number;
  euler_characteristic: number;
  genus: number;
  boundary_loops: number;
  quads: number;
  edits: number;
}

/** The file, and the part of it that is worked on. */
export interface FileFacts extends PartFacts {
  /** Names the bytes of the file. */
  digest: string;
  name: string;
  /** The number of the part that is worked on, from 1. */
  component: number;
  components: PartFacts[];
  mends: string[];
  refused: string[];
  origin: Vector;
  diagonal: number;
  defects: { kind: string; text: string; where: Vector }[];
}

export interface HistoryStep {
  text: string;
  edit: Edit;
  milliseconds: number;
}

export interface ChartFacts {
  id: number;
  kind: "annulus" | "disc";
  columns: number;
  /** At the upper side of an annulus: others where columns end or begin inside. */
  columns_high: number;
  rows: number;
  height: number;
  /** What the user asked for; 0 is free. */
  set_columns: number;
  set_rows: number;
  shift: number;
  grading: number;
  locked: boolean;
}

export interface Check {
  name: string;
  status: "passed" | "failed" | "not_checked";
  measured?: number | null;
  expected?: number | null;
  message: string;
}

export interface ShapeKept {
  summary: string;
  from_quads: { mean: number };
  from_input: { mean: number };
  bound: number;
}

export interface ShapeWarning {
  name: string;
  text: string;
}

/** What can be brought back. */
export interface SavedSession {
  name: string;
  edits: number;
  digest: string;
  /** Seconds since 1970. */
  saved: number;
  /** A `data:` address, or nothing. */
  picture?: string;
}

export interface State {
  event: "state";
  revision: number;
  file: FileFacts | null;
  last: { ok: boolean; text: string; milliseconds?: number; warning?: string } | null;
  last_session?: { name: string; edits: number };
  /** All that are kept, the newest first, and the files of those that cannot be read. */
  sessions?: SavedSession[];
  unreadable_sessions?: string[];
  history?: HistoryStep[];
  applied?: number;
  facts?: { charts: ChartFacts[]; target_quads: number; edge_length: number; fans: string };
  /** Whether the quads are relaxed already. */
  finished?: boolean;
  budget?: { needed: number; interior: Record<string, number>; boundary: Record<string, number> };
  /** `shape` once it was measured: how much of the surface's shape the quads keep; `warnings` where that is too little. */
  certificate?: {
    passed: boolean; strictly_valid: boolean; checks: Check[]; quads: number; vertices: number; shape: ShapeKept | null; warnings: ShapeWarning[];
  };
  statistics?: {
    quads: number;
    vertices: number;
    inverted_quads: number;
    scaled_jacobian: { minimum: number; mean: number; maximum: number };
    scaled_jacobian_histogram: number[];
  };
}

/** How far surface and quads are from each other, in units of the file; places are relative to its `origin`. */
export interface Deviation {
  diagonal: number;
  of_surface: number;
  of_quads: number;
  worst: { place: Vector; distance: number; of: "surface" | "quads" }[];
  corners: number;
  lost_corners: Vector[];
  sharp_length: number;
  lost_sharp_length: number;
}

/** What works in place of an edit that was refused. */
export interface Offer {
  edit: Edit;
  words: string;
  place: Vector;
}

/** An edit that is worth while, and why. */
export interface Hint {
  kind: string;
  reason: string;
  place: Vector;
  edit: Edit;
  /** The edit in words. */
  text: string;
}

export type ServerMessage =
  | State
  | { event: "hello"; version: number; preferences: Record<string, unknown> }
  | { event: "progress"; stage: string; fraction: number }
  | { event: "trouble"; message: string }
  | { event: "no_layer"; layer: string }
  | { reply: number; ok: true; result: unknown }
  | { reply: number; ok: false; error: Failure };
