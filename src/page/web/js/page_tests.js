// SPDX-License-Identifier: GPL-3.0-or-later
// All tests: a table or small stress paths, filtered; and where a record is dropped.
import { get } from "./api.js";
import { el, fill, segments } from "./dom.js";
import { dropZone } from "./drop.js";
import { Filters, kept } from "./filters.js";
import { takeNotice } from "./notice.js";
import { paths } from "./small_multiples.js";
import { TestTable } from "./test_table.js";

let view = "table";

export async function show(main) {
  let { tests, running, record_bytes: most } = await get("/api/tests");
  const badge = document.getElementById("running-count");
  badge.hidden = running.length === 0;
  badge.textContent = String(running.length);

  const list = el("section", { class: "panel", "aria-label": "Tests" });
  const count = el("p", { class: "quiet", role: "status" });
  const chosen = new Set();
  const compare = el("a", { class: "button main", hidden: true });
  let small = null;
  const chosenChanged = () => {
    compare.hidden = chosen.size < 2;
    compare.href = `#/compare/${[...chosen].join(",")}`;
    compare.textContent = `Compare ${chosen.size} tests`;
  };
  const table = new TestTable(chosen, chosenChanged);
  const draw = () => {
    const some = kept(tests, filters.values);
    count.textContent = some.length === tests.length ? `${tests.length} tests` : `${some.length} of ${tests.length} tests`;
    small?.end();
    small = null;
    if (tests.length === 0) fill(list, el("p", { class: "empty" }, "No test is stored yet. Drop a record above, or run one under \"Try it\"."));
    else if (some.length === 0) fill(list, el("p", { class: "empty" }, "No test is left by these filters."));
    else if (view === "table") fill(list, table.show(some));
    else {
      small = paths(some);
      fill(list, small.node);
    }
  };
  let filters = new Filters(tests, draw);
  const filterRoom = el("div", {}, tests.length ? filters.node : null);
  const renew = async () => {
    ({ tests, running } = await get("/api/tests"));
    filters = new Filters(tests, draw);
    fill(filterRoom, tests.length ? filters.node : null);
    draw();
  };
  const switched = segments("Show as", [["table", "table"], ["paths", "stress paths"]], view, (value) => {
    view = value;
    draw();
  });
  fill(main, el("div", { class: "stack" }, takeNotice(), el("div", { class: "head" }, el("h1", { tabindex: -1 }, "Tests"), el("div", { class: "row" }, compare, switched)),
    dropZone(main, most, renew), filterRoom, count, list));
  draw();
  return { title: "Tests", end: () => small?.end() };
}
