// SPDX-License-Identifier: GPL-3.0-or-later
// Elements from names, attributes and children. Texts become text nodes only: no name of a test or file can become markup.

const SVG = "http://www.w3.org/2000/svg";

function filled(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (name === "on") for (const [event, does] of Object.entries(value)) node.addEventListener(event, does);
    else if (name === "data") Object.assign(node.dataset, value);
    else if (value === true) node.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) node.setAttribute(name, String(value));
  }
  append(node, children);
  return node;
}

export function append(node, children) {
  for (const child of [children].flat(Infinity))
    if (child !== null && child !== undefined && child !== false)
      node.append(child instanceof Node ? child : String(child));
}

export const el = (tag, attributes = {}, ...children) => filled(document.createElement(tag), attributes, children);
export const svg = (tag, attributes = {}, ...children) => filled(document.createElementNS(SVG, tag), attributes, children);

export function fill(node, ...children) {
  node.replaceChildren();
  append(node, children);
  return node;
}

let last = 0;
/** An id that no other element has. */
export const fresh = (stem) => `${stem}-${++last}`;

/** A label above a control; the control gets an id. */
export function field(text, control, ...more) {
  control.id ||= fresh("field");
  return el("div", { class: "field" }, el("label", { for: control.id }, text), control, more);
}

export function select(choices, value, changed) {
  const list = el("select", { on: { change: () => changed?.(list.value) } },
    choices.map(([key, text]) => el("option", { value: key, selected: key === value }, text)));
  return list;
}

/** Buttons of which one is pressed: [[key, text], ...]. */
export function segments(title, choices, value, changed) {
  const buttons = choices.map(([key, text]) => el("button", { type: "button", "aria-pressed": key === value,
    on: { click: () => {
      buttons.forEach((b, i) => b.setAttribute("aria-pressed", choices[i][0] === key));
      changed(key);
    } } }, text));
  buttons.forEach((b, i) => b.setAttribute("aria-pressed", choices[i][0] === value));
  return el("div", { class: "segments", role: "group", "aria-label": title }, buttons);
}
