// SPDX-License-Identifier: GPL-3.0-or-later
// What a verdict is called and how it is shown: a word and a shape beside the colour.
import { words } from "./format.js";

const KINDS = {
  flow: ["flow collapse", "alarm", "strength is lost and not recovered"],
  partial: ["partial collapse", "alarm", "part of the strength is lost permanently"],
  limited: ["limited collapse", "care", "strength is lost and recovered"],
  cyclic_mobility: ["cyclic mobility", "care", "strength is lost and recovered in each cycle"],
  none: ["no collapse", "good", "second-order work stayed positive"],
};

export function verdict(collapse) {
  if (!collapse || collapse.detected === null || collapse.detected === undefined)
    return { word: "not assessed", tone: "off", why: collapse?.judged?.reason ?? "there is no assessment" };
  const [word, tone, why] = KINDS[collapse.kind] ?? [words(collapse.kind), collapse.detected ? "alarm" : "good", ""];
  return { word, tone, why };
}

export const SHAPES = { alarm: "▲", care: "◆", good: "●", off: "○", info: "■" };

export const judgement = (value, yes = "yes", no = "no") => (value === null || value === undefined ? "not assessed" : value ? yes : no);
