// SPDX-License-Identifier: GPL-3.0-or-later
// Records that are dropped on the page, or chosen, are replayed.
import { el } from "./dom.js";
import { Imports } from "./imports.js";

const imports = new Imports();

/** `main` takes the drop, wherever on the page it falls. `most` is the size in bytes that the server accepts of one file; `changed()`
 *  is called when several files were read. The list of files stays while other parts of the page are shown. */
export function dropZone(main, most, changed) {
  const first = el("input", { type: "checkbox", id: "columns-first" });
  Object.assign(imports, { most, changed, columnsFirst: () => first.checked });
  const input = el("input", { type: "file", hidden: true, multiple: true, "aria-label": "Record files", tabindex: -1, id: "record-file" });
  const choose = el("button", { type: "button", on: { click: () => input.click() } }, "Open records…");
  const zone = el("div", { class: "drop" }, el("span", {}, "Drop records of a logger here"), choose,
    el("span", { class: "tick" }, first, el("label", { for: "columns-first" }, "Show the columns first")), input);

  const over = (event, is) => {
    event.preventDefault();
    zone.classList.toggle("over", is);
  };
  main.addEventListener("dragover", (event) => over(event, true));
  main.addEventListener("dragleave", (event) => over(event, false));
  main.addEventListener("drop", (event) => {
    over(event, false);
    imports.add([...(event.dataTransfer?.files ?? [])]);
  });
  input.addEventListener("change", () => {
    imports.add([...input.files]);
    input.value = "";
  });
  return el("div", { class: "stack" }, zone, imports.node);
}
