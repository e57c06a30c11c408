// SPDX-License-Identifier: GPL-3.0-or-later
// Edits that follow the pointer: at most one is on its way, and all of one drag become one step of the history.
import type { Connection } from "../net/connection";
import type { Edit } from "../net/messages";

export class DragEdits {
  private drag = 0;
  private open = false;
  private onWay = false;
  private next: { edit: Edit; live: boolean } | null = null;

  constructor(private readonly connection: Connection, private readonly tell: (error: unknown) => void) {}

  /** The last edit of a drag is not `live`. */
  send(edit: Edit, live: boolean): void {
    if (!this.open) {
      this.open = true;
      ++this.drag;
    }
    this.next = { edit, live };
    if (!live) this.open = false;
    if (!this.onWay) void this.flush();
  }

  private async flush(): Promise<void> {
    this.onWay = true;
    while (this.next) {
      const { edit, live } = this.next;
      this.next = null;
      try {
        await this.connection.request("edit", { edit, live, drag: this.drag });
      } catch (error) {
        if (!live) this.tell(error);
      }
    }
    this.onWay = false;
  }
}
