// SPDX-License-Identifier: GPL-3.0-or-later
// What the parts of the page share, and how they learn that it changed.
import type { Deviation, State } from "./net/messages";
import type { LayerId, ViewId } from "./scene/layers";

export type TabId = "design" | "layers" | "check" | "history";

export interface Shared {
  state: State | null;
  layers: ReadonlySet<LayerId>;
  connected: boolean;
  busy: { stage: string; fraction: number } | null;
  /** How far quads and surface are from each other, where that was measured. */
  deviation: Deviation | null;
  /** The chart that is looked at, or -1. */
  chart: number;
  tool: string;
  /** Where the user is on the way from a mesh to quads, by the view of that step. */
  step: ViewId;
  /** The panels that are seen. */
  tab: TabId;
  /** How many edits are known to be worth while. */
  hints: number;
  /** The axis that points up. */
  up: readonly [number, number, number];
}

export type Key = keyof Shared;

export class Store {
  private readonly values: Shared = {
    state: null, layers: new Set<LayerId>(["surface"]), connected: false, busy: null, deviation: null, chart: -1, tool: "select", step: "surface", tab: "design", hints: 0, up: [0, 1, 0],
  };
  private readonly listeners = new Map<Key, ((...unused: never[]) => void)[]>();

  get<K extends Key>(key: K): Shared[K] {
    return this.values[key];
  }

  set<K extends Key>(key: K, value: Shared[K]): void {
    if (this.values[key] === value) return;
    this.values[key] = value;
    for (const listener of this.listeners.get(key) ?? []) listener();
  }

  /** Calls the listener now and whenever one of the values changes. */
  watch(keys: Key[], listener: () => void): void {
    for (const key of keys) this.listeners.set(key, [...(this.listeners.get(key) ?? []), listener]);
    listener();
  }
}
