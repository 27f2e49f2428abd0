// SPDX-License-Identifier: GPL-3.0-or-later
// What one part of the page has to say at the head of the next.
import { el } from "./dom.js";

let waiting = null;

export function leaveNotice(title, texts) {
  waiting = { title, texts };
}

export function takeNotice() {
  if (!waiting) return null;
  const { title, texts } = waiting;
  waiting = null;
  return el("div", { class: "notice", role: "status" }, el("strong", {}, title), texts.length ? el("ul", {}, texts.map((text) => el("li", {}, text))) : null);
}

export const failed = (failure) => el("div", { class: "notice bad", role: "alert" }, el("strong", {}, "This did not work. "), failure.message);
