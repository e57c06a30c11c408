// SPDX-License-Identifier: GPL-3.0-or-later
import type { Store } from "../store";
import { h } from "./dom";

const afterMilliseconds = 1500;

/** Says over the view that the program is gone, and what to do: nothing that is clicked then has an effect. */
export function lostBanner(store: Store): HTMLElement {
  const banner = h(
    "div", { className: "lost", role: "alert", hidden: true }, h("strong", {}, "The program does not answer."),
    " If it has ended, start it again in the same folder and open the address that it prints. Your work is kept up to the last edit.",
  );
  let timer = 0, wasConnected = false;
  store.watch(["connected"], () => {
    clearTimeout(timer);
    const connected = store.get("connected");
    wasConnected ||= connected;
    banner.hidden = true;
    if (!connected && wasConnected) timer = window.setTimeout(() => (banner.hidden = false), afterMilliseconds);
  });
  return banner;
}
