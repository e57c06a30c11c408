// SPDX-License-Identifier: GPL-3.0-or-later
import { RequestError } from "../net/connection";
import type { Edit } from "../net/messages";
import { Lines, polylinePairs } from "../scene/lines";
import { plain } from "../ui/words";
import type { Workbench } from "../workbench";

const pause = 60, again = 300; // milliseconds without another wish before the program is asked; before it is asked once more

/** Shows what an edit would make before it is made: its new contours, or why it would be refused. One question is on its way at a time. */
export class Preview {
  readonly curve = new Lines(3.5, 0x43c59e, { hidden: true });
  /** Why the edit would be refused, or nothing. */
  refusal = "";
  private wanted: Edit | null = null;
  private name = "";
  private asks = false;
  private timer = 0;

  /** `told` is called when the refusal is another one. */
  constructor(private readonly app: Workbench, private readonly told: () => void) {
    this.curve.object.renderOrder = 8;
    app.viewport.scene.add(this.curve.object);
  }

  /** Asks what this edit would make; null: nothing is asked or shown. */
  show(edit: Edit | null): void {
    const name = edit ? JSON.stringify(edit) : "";
    if (name === this.name) return;
    [this.wanted, this.name] = [edit, name];
    clearTimeout(this.timer);
    if (!edit) this.put([], "");
    else this.timer = window.setTimeout(() => void this.ask(), pause);
  }

  private async ask(): Promise<void> {
    const { wanted, name } = this;
    if (!wanted || this.asks) return;
    this.asks = true;
    try {
      const { contours } = (await this.app.connection.request("preview", { edit: wanted })) as { contours: number[][] };
      if (name === this.name) this.put(contours, "");
    } catch (error) {
      const isStopped = error instanceof RequestError && error.failure.cancelled;
      if (name === this.name && isStopped) this.timer = window.setTimeout(() => void this.ask(), again);
      else if (name === this.name) this.put([], error instanceof Error ? plain(error.message) : String(error));
    }
    this.asks = false;
    if (name !== this.name) void this.ask();
  }

  /** Contours that would be new, each x, y, z of its points. */
  private put(contours: number[][], refusal: string): void {
    const begin = [0];
    for (const points of contours) begin.push(begin.at(-1)! + points.length / 3);
    this.curve.set(polylinePairs(new Float32Array(contours.flat()), new Uint32Array(begin)));
    this.curve.show(contours.length > 0);
    this.app.viewport.invalidate();
    if (refusal === this.refusal) return;
    this.refusal = refusal;
    this.told();
  }
}
