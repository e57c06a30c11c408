// SPDX-License-Identifier: GPL-3.0-or-later
// Edits that follow the pointer: while the program does one, the next is on its way; all of one drag become one step of the history.
import type { Connection } from "../net/connection";
import type { Edit } from "../net/messages";

const mostOnWay = 2;

export class DragEdits {
  private drag = 0;
  private open = false;
  private onWay = 0;
  private next: { edit: Edit; live: boolean } | null = null;
  private last: Edit | null = null;

  constructor(private readonly connection: Connection, private readonly tell: (error: unknown) => void) {}

  /** The last edit of a drag is not `live`. */
  send(edit: Edit, live: boolean): void {
    if (!this.open) {
      this.open = true;
      ++this.drag;
    }
    this.last = edit;
    this.next = { edit, live };
    if (!live) this.open = false;
    this.flush();
  }

  /** Ends a drag where there is no new place: the last one stays. */
  end(): void {
    if (this.open && this.last) this.send(this.last, false);
  }

  private flush(): void {
    if (!this.next || (this.next.live && this.onWay >= mostOnWay)) return;
    const { edit, live } = this.next;
    this.next = null;
    ++this.onWay;
    this.connection
      .request("edit", { edit, live, drag: this.drag })
      .catch((error: unknown) => {
        if (!live) this.tell(error);
      })
      .finally(() => {
        --this.onWay;
        this.flush();
      });
  }
}
