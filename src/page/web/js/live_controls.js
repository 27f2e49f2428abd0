// SPDX-License-Identifier: GPL-3.0-or-later
// Hold, go on, safe stop. Each is asked twice, says who, and becomes an event of the record.
import { post } from "./api.js";
import { el, field, fill } from "./dom.js";

const ORDERS = {
  hold: { text: "‖ Hold", title: "Hold the test?", says: "The drives stop at their positions. Readings continue.", sure: "Really hold it now?", yes: "Hold now" },
  resume: { text: "▶ Go on", title: "Go on with the test?", says: "The stage continues from where it was held.", sure: "Really go on now?", yes: "Go on now" },
  stop: { text: "■ Safe stop", title: "Stop the test?", says: "The rig goes to its safe state and the test ends. It cannot be continued.", sure: "Really end this test?", yes: "Stop now", danger: true },
};

let who = "";

function ask(order, name) {
  const { title, says, sure, yes, danger } = ORDERS[order];
  return new Promise((resolve) => {
    const person = el("input", { value: who, required: true, maxlength: 80, autocomplete: "name" });
    const dialog = el("dialog", { "aria-labelledby": "ask-title", on: { close: () => {
      dialog.remove();
      resolve(dialog.returnValue === "yes" ? who : null);
    } } });
    const no = () => el("button", { type: "button", on: { click: () => dialog.close("no") } }, "Cancel");
    const second = () => {
      const go = el("button", { type: "button", class: danger ? "danger" : "main", on: { click: () => dialog.close("yes") } }, yes);
      fill(dialog, el("h2", { id: "ask-title" }, sure), el("p", {}, `${name}, by ${who}.`), el("div", { class: "row" }, no(), go));
      dialog.querySelector("button").focus();
    };
    fill(dialog, el("form", { on: { submit: (event) => {
      event.preventDefault();
      who = person.value.trim();
      if (who) second();
    } } }, el("h2", { id: "ask-title" }, title), el("p", {}, says), field("Your name, for the record", person),
    el("div", { class: "row" }, no(), el("button", { class: "main", type: "submit" }, "Yes"))));
    document.body.append(dialog);
    dialog.showModal();
  });
}

/** The buttons for a test; told(text) says what came of an order. show(state) enables what can be done. */
export function controls(id, name, told) {
  const buttons = Object.fromEntries(Object.entries(ORDERS).map(([order, { text, danger }]) => [order, el("button", { type: "button", class: danger ? "danger" : null, data: { order }, on: { click: async () => {
    const by = await ask(order, name);
    if (!by) return;
    try {
      await post(`/api/runs/${id}/${order}`, { who: by });
      told(null);
    } catch (failure) {
      told(failure.message);
    }
  } } }, text)]));
  return { node: el("div", { class: "row controls", role: "group", "aria-label": "Commands" }, Object.values(buttons)), show: (state) => {
    buttons.hold.disabled = state !== "running";
    buttons.resume.disabled = state !== "held";
    buttons.stop.disabled = state !== "running" && state !== "held";
  } };
}
