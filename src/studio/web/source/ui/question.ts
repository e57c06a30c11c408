// SPDX-License-Identifier: GPL-3.0-or-later
// Asks before something is lost, and for names.
import { h } from "./dom";

export interface Choice {
  id: string;
  name: string;
  primary?: boolean;
}

/** The id of what was chosen; null if the question was closed. The first choice has the focus. */
export function question(title: string, text: string, choices: readonly Choice[]): Promise<string | null> {
  return ask(title, [h("p", {}, text)], choices);
}

/** Asks for a name: the choice and the name, or null. */
export async function askName(title: string, text: string, name: string, choices: readonly Choice[]): Promise<{ choice: string; name: string } | null> {
  const input = h("input", { type: "text", value: name, id: "save-name", "aria-label": "Name", spellcheck: false });
  const opened = ask(title, [h("div", { className: "row" }, input), h("p", { className: "note" }, text)], choices);
  input.focus();
  input.setSelectionRange(0, name.indexOf(".") < 0 ? name.length : name.indexOf("."));
  const choice = await opened;
  return choice === null || input.value.trim() === "" ? null : { choice, name: input.value.trim() };
}

function ask(title: string, content: HTMLElement[], choices: readonly Choice[]): Promise<string | null> {
  return new Promise((resolve) => {
    const choose = (id: string | null): void => {
      dialog.close();
      dialog.remove();
      resolve(id);
    };
    const heading = h("h2", { id: "question-title" }, title);
    const dialog = h(
      "dialog", { className: "dialog question", "aria-labelledby": "question-title" }, h("header", {}, heading),
      h(
        "form", { onsubmit: (event: Event) => (event.preventDefault(), choose(choices[0]!.id)) }, ...content,
        h(
          "div", { className: "row choices" },
          ...choices.map(({ id, name, primary }, i) => h("button", { type: i === 0 ? "submit" : "button", className: primary ? "primary" : "", "data-answer": id, onclick: i === 0 ? null : () => choose(id) }, name)),
          h("button", { type: "button", "data-answer": "cancel", onclick: () => choose(null) }, "Cancel"),
        ),
      ),
    );
    dialog.oncancel = (event) => (event.preventDefault(), choose(null));
    document.body.append(dialog);
    dialog.showModal();
    dialog.querySelector<HTMLElement>("[data-answer]")?.focus();
  });
}
