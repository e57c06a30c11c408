// SPDX-License-Identifier: GPL-3.0-or-later
// What a user prefers, kept by the program: a browser would forget it, for the page's address has another port each time.
import type { Connection } from "../net/connection";
import type { Shading } from "../scene/normals";
import type { ThemeName } from "./theme";

export interface Preferred {
  theme: ThemeName | null;
  shading: Shading;
  orthographic: boolean;
  /** The part of the middle that the view of a chart has. */
  split: number;
}

const possible: { [K in keyof Preferred]: (value: unknown) => boolean } = {
  theme: (value) => value === "dark" || value === "light",
  shading: (value) => value === "smooth" || value === "crease" || value === "flat",
  orthographic: (value) => typeof value === "boolean",
  split: (value) => typeof value === "number" && value > 0 && value < 1,
};

export class Preferences {
  private values: Preferred = { theme: null, shading: "crease", orthographic: false, split: 0.45 };
  private readonly listeners: (() => void)[] = [];

  constructor(private readonly connection: Connection) {}

  get<K extends keyof Preferred>(key: K): Preferred[K] {
    return this.values[key];
  }

  /** Calls the listener now and whenever something is preferred. */
  watch(listener: () => void): void {
    this.listeners.push(listener);
    listener();
  }

  set<K extends keyof Preferred>(key: K, value: Preferred[K]): void {
    if (this.values[key] === value) return;
    this.values[key] = value;
    // What could not be kept holds until the page is closed.
    void this.connection.request("prefer", { preferences: this.values }).catch(() => undefined);
    this.tell();
  }

  /** Takes what the program has kept; what this page does not understand is left out. */
  take(kept: Record<string, unknown>): void {
    const known = Object.entries(kept).filter(([key, value]) => possible[key as keyof Preferred]?.(value));
    this.values = { ...this.values, ...(Object.fromEntries(known) as Partial<Preferred>) };
    this.tell();
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }
}
