// SPDX-License-Identifier: GPL-3.0-or-later
// Edits that follow the pointer: while the program does one, the next is on its way; all of one drag become one step of the history. A place
// that is refused is told while the button is down; let go there, or with Escape, everything is as it was before the drag.
import { RequestError, type Connection } from "../net/connection";
import type { Edit } from "../net/messages";

const mostOnWay = 2;

export class DragEdits {
  private drag = 0;
  private open = false;
  private onWay = 0;
  private next: { edit: Edit; live: boolean } | null = null;
  private last: Edit | null = null;

  /** `refused` is called while dragging: with the reason where the place is refused, with null where it is not. */
  constructor(
    private readonly connection: Connection, private readonly tell: (error: unknown, edit?: Edit) => void, private readonly refused: (reason: string | null) => void,
  ) {}

  /** The last edit of a drag is not `live`. */
  send(edit: Edit, live: boolean): void {
    if (!this.open) {
      this.open = true;
      ++this.drag;
    }
    this.last = edit;
    this.next = { edit, live };
    if (!live) this.close();
    this.flush();
  }

  /** Ends a drag where there is no new place: the last one stays. */
  end(): void {
    if (this.open && this.last) this.send(this.last, false);
  }

  /** Takes back all that the drag did. */
  cancel(): void {
    if (!this.open) return;
    this.close();
    this.next = null;
    this.connection.request("cancel_drag", { drag: this.drag }).catch((error: unknown) => this.tell(error));
  }

  private close(): void {
    this.open = false;
    this.refused(null);
  }

  private flush(): void {
    if (!this.next || (this.next.live && this.onWay >= mostOnWay)) return;
    const { edit, live } = this.next, { drag } = this;
    this.next = null;
    ++this.onWay;
    const tellRefusal = (reason: string | null): void => {
      if (live && this.open && drag === this.drag) this.refused(reason);
    };
    this.connection
      .request("edit", { edit, live, drag })
      .then(() => tellRefusal(null))
      .catch((error: unknown) => {
        if (!live) this.tell(error, edit);
        else if (error instanceof RequestError && !error.failure.cancelled) tellRefusal(error.message);
      })
      .finally(() => {
        --this.onWay;
        this.flush();
      });
  }
}
