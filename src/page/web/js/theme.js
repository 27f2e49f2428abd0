// SPDX-License-Identifier: GPL-3.0-or-later
// Light or dark: as the system has it, until the button says otherwise. Charts ask here for their colours.

const dark = matchMedia("(prefers-color-scheme: dark)");
const ORDER = ["auto", "light", "dark"];
const TITLES = { auto: "Colours: as the system has them", light: "Colours: light", dark: "Colours: dark" };
const SIGNS = { auto: "◐", light: "○", dark: "●" };
let chosen = "auto";
let colours = new Map();
const listeners = new Set();

function apply() {
  document.documentElement.dataset.theme = chosen === "auto" ? (dark.matches ? "dark" : "light") : chosen;
  colours = new Map();
  for (const listener of listeners) listener();
}

/** The colour of a custom property, e.g. colour("blue"). */
export function colour(name) {
  if (!colours.has(name)) colours.set(name, getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim());
  return colours.get(name);
}

/** Returns what ends it. */
export function onTheme(listener) {
  listeners.add(listener);
  return () => listeners.delete(listener);
}

export function start(button) {
  const kept = localStorage.getItem("triax-colours");
  if (ORDER.includes(kept)) chosen = kept;
  const show = () => {
    button.textContent = SIGNS[chosen];
    button.title = TITLES[chosen];
    button.setAttribute("aria-label", TITLES[chosen]);
    apply();
  };
  button.addEventListener("click", () => {
    chosen = ORDER[(ORDER.indexOf(chosen) + 1) % ORDER.length];
    localStorage.setItem("triax-colours", chosen);
    show();
  });
  dark.addEventListener("change", apply);
  show();
}
