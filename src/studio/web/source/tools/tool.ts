// SPDX-License-Identifier: GPL-3.0-or-later

import type { KeyNotes } from "../ui/keyboard";

/** A tool takes the pointer on the surface. The camera stays usable: what a tool does not claim, turns the view. */
export interface Tool {
  readonly id: string;
  readonly name: string;
  readonly key: string;
  readonly icon: string;
  /** Its own keys. */
  readonly keys?: KeyNotes;
  /** What to do now, in one line. */
  hint(): string;
  begin?(): void;
  end?(): void;
  /** The pointer moves with no button down. */
  hover?(event: PointerEvent): void;
  /** The pointer is over the surface no more. */
  leave?(): void;
  /** A click that was no drag. */
  click?(event: PointerEvent): void;
  /** A button goes down; true claims the drag that follows. */
  press?(event: PointerEvent): boolean;
  drag?(event: PointerEvent): void;
  release?(event: PointerEvent): void;
  /** The drag was taken back: nothing is held any more. */
  abandon?(): void;
  /** A key while the tool is active; true if it was meant for the tool. */
  key_?(event: KeyboardEvent): boolean;
  /** The shown data changed. */
  refresh?(): void;
}

/** What one tool sees of them all: the line where the active one speaks, and the place of its controls. */
export interface Tools {
  choose(id: string): void;
  /** The tool's own controls, at the top of the panels. */
  setBox(box: HTMLElement | null): void;
  /** Says the active tool's hint anew. */
  tellHint(bad?: boolean): void;
  /** While dragging: why the place under the pointer is refused, or null where it is not. */
  tellRefusal(reason: string | null): void;
}
