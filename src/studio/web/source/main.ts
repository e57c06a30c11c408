// SPDX-License-Identifier: GPL-3.0-or-later
import { App } from "./app";
import { enter } from "./net/connection";
import "./style.css";
import { h } from "./ui/dom";

declare global {
  interface Window {
    /** For tests: what the page shows. */
    studio?: App;
  }
}

async function start(): Promise<void> {
  const root = document.getElementById("app")!;
  try {
    await enter();
    window.studio = new App(root);
  } catch (error) {
    root.append(h("div", { className: "fatal" }, h("h1", {}, "The studio cannot start"), h("p", {}, error instanceof Error ? error.message : String(error))));
  }
}

void start();
