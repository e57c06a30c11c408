// SPDX-License-Identifier: GPL-3.0-or-later
import type { Connection } from "../net/connection";
import type { State } from "../net/messages";

const afterMilliseconds = 1200;

/** Gives the program a small picture of what was worked on, once nothing has changed for a moment. */
export class Thumbnails {
  private timer = 0;
  private kept = "";

  constructor(private readonly connection: Connection, private readonly picture: () => string) {}

  follow(state: State): void {
    clearTimeout(this.timer);
    const { file, applied, finished } = state, now = `${file?.digest} ${file?.component} ${applied}`;
    if (!file || !finished || now === this.kept) return;
    this.timer = window.setTimeout(() => {
      this.kept = now;
      // Without a picture the card still has its name.
      void this.connection.request("keep_picture", { picture: this.picture() }).catch(() => undefined);
    }, afterMilliseconds);
  }
}
