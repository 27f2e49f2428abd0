// SPDX-License-Identifier: GPL-3.0-or-later
// Which tests run now.
import { get } from "./api.js";
import { el, fill } from "./dom.js";

export async function show(main) {
  const { tests, running } = await get("/api/tests");
  if (running.length === 1) {
    location.replace(`#/run/${running[0]}`);
    return { title: "Running" };
  }
  const name = (id) => tests.find((t) => t.test.id === id)?.test.name ?? `test ${id}`;
  fill(main, el("div", { class: "stack" }, el("h1", { tabindex: -1 }, "Running tests"),
    running.length ? el("ul", { class: "panel" }, running.map((id) => el("li", {}, el("a", { href: `#/run/${id}` }, name(id)))))
      : el("p", { class: "panel empty" }, "No test is running. ", el("a", { href: "#/try" }, "Try one"), " on the virtual apparatus, or start triax open with a rig.")));
  return { title: "Running" };
}
