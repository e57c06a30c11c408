// SPDX-License-Identifier: GPL-3.0-or-later
import type { Connection } from "../net/connection";
import { h, readable, replace } from "./dom";

interface Listing {
  folder: string;
  files: { name: string; bytes: number }[];
}

/** The dialog that opens a mesh: from the folder of the program, or from anywhere by upload. */
export function openDialog(connection: Connection, upload: (file: File) => void, openFile: (name: string) => void): () => void {
  const input = h("input", { type: "file", accept: ".obj,.off,.ply,.stl", hidden: true, id: "file-input" });
  const files = h("div", { className: "file-list" });
  const filter = h("input", { type: "search", placeholder: "Filter", "aria-label": "Filter the files" });
  const dialog = h(
    "dialog", { className: "dialog open-dialog" },
    h("header", {}, h("h2", {}, "Open a mesh"), h("button", { className: "ghost", onclick: () => dialog.close() }, "Close")),
    h("p", { className: "note" }, "OBJ, OFF, PLY or STL. Nothing leaves this machine."),
    h("div", { className: "row" }, h("button", { className: "primary", onclick: () => input.click() }, "Choose a file …"), filter),
    files,
  );
  document.body.append(dialog, input);
  input.onchange = () => {
    const file = input.files?.[0];
    input.value = "";
    if (!file) return;
    dialog.close();
    upload(file);
  };
  let listing: Listing = { folder: "", files: [] };
  const draw = (): void => {
    const word = filter.value.toLowerCase();
    const matching = listing.files.filter((f) => f.name.toLowerCase().includes(word));
    replace(
      files,
      h("h3", {}, `In the folder ${listing.folder}`),
      ...matching.slice(0, 200).map((f) =>
        h(
          "button", { className: "ghost file", onclick: () => (dialog.close(), openFile(f.name)) },
          h("span", { className: "name" }, f.name), h("span", { className: "time" }, size(f.bytes)),
        ),
      ),
      matching.length === 0 && h("p", { className: "empty" }, "No meshes here."),
    );
  };
  filter.oninput = draw;
  return () => {
    filter.value = "";
    void connection.request("list_files").then((answer) => {
      listing = answer as Listing;
      draw();
    });
    if (!dialog.open) dialog.showModal();
  };
}

function size(bytes: number): string {
  return bytes > 1e6 ? `${(bytes / 1e6).toFixed(1)} MB` : `${readable(Math.ceil(bytes / 1e3))} kB`;
}
