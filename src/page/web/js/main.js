// SPDX-License-Identifier: GPL-3.0-or-later
// Which part of the page is shown: the part of the address after #. Each part is a module with show(main, arguments), which
// gives its title and what ends it.
import { post } from "./api.js";
import { el, fill } from "./dom.js";
import { failed } from "./notice.js";
import * as theme from "./theme.js";
import * as compare from "./page_compare.js";
import * as run from "./page_run.js";
import * as running from "./page_running.js";
import * as stability from "./page_stability.js";
import * as test from "./page_test.js";
import * as tests from "./page_tests.js";
import * as tryIt from "./page_try.js";

const PARTS = { tests: [tests, "tests"], test: [test, "tests"], compare: [compare, "tests"], running: [running, "running"], run: [run, "running"],
  try: [tryIt, "try"], stability: [stability, "stability"] };

const main = document.getElementById("main");
let shown = null;
let turn = 0;

async function route() {
  const mine = ++turn;
  const [name = "tests", ...rest] = location.hash.replace(/^#\//, "").split("/").map(decodeURIComponent);
  const [part, tab] = PARTS[name] ?? PARTS.tests;
  shown?.end?.();
  shown = null;
  for (const link of document.querySelectorAll(".top nav a")) {
    if (link.dataset.part === tab) link.setAttribute("aria-current", "page");
    else link.removeAttribute("aria-current");
  }
  main.setAttribute("aria-busy", "true");
  const room = el("div");
  try {
    fill(main, room);
    const now = await part.show(room, rest);
    if (mine !== turn) return now?.end?.();
    shown = now;
    document.title = `${now.title} · triax`;
  } catch (failure) {
    if (mine === turn) fill(room, failed(failure));
  } finally {
    if (mine === turn) main.removeAttribute("aria-busy");
  }
  if (mine === turn && turn > 1) {
    (room.querySelector("h1") ?? main).focus({ preventScroll: true });
    scrollTo(0, 0);
  }
}

/** An address lets one browser in: another one needs another. */
async function anotherBrowser(told) {
  try {
    const { address } = await post("/api/browsers", {});
    fill(told, "Open there within an hour, once: ", el("code", {}, address));
  } catch (failure) {
    fill(told, failure.message);
  }
}

function foot() {
  const told = el("span", { role: "status" });
  fill(document.getElementById("foot"), el("button", { type: "button", class: "plain", on: { click: () => anotherBrowser(told) } }, "Address for another browser"), " ", told,
    el("p", {}, "Access of this browser ends after 12 hours without use, and 7 days after its entry. A new address renews it: from here, or by Enter in the terminal of triax open."));
}

theme.start(document.getElementById("theme"));
document.getElementById("skip").addEventListener("click", (event) => {
  event.preventDefault();
  main.focus();
});
addEventListener("hashchange", route);
foot();
route();
