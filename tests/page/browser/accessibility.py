# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of our own, like Lighthouse's: contrast, names of controls, headings, order and sight of the focus, width."""
from browser import check, same

CONTRAST = """
const rgba = (text) => { const m = text.match(/[\\d.]+/g).map(Number); return [m[0], m[1], m[2], m[3] ?? 1]; };
const over = (top, under) => [0, 1, 2].map((i) => top[i] * top[3] + under[i] * (1 - top[3])).concat(1);
const ground = (node) => { const stack = []; for (let n = node; n; n = n.parentElement) stack.unshift(rgba(getComputedStyle(n).backgroundColor));
  return stack.reduce((under, top) => over(top, under), [255, 255, 255, 1]); };
const light = (c) => { const f = c.slice(0, 3).map((v) => { v /= 255; return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4; });
  return 0.2126 * f[0] + 0.7152 * f[1] + 0.0722 * f[2]; };
const poor = []; let seen = 0;
const walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
while (walk.nextNode()) {
  const node = walk.currentNode.parentElement;
  if (!walk.currentNode.data.trim() || !node.checkVisibility() || node.closest(":disabled, option, noscript")) continue;
  const style = getComputedStyle(node);
  const under = ground(node);
  const text = over(rgba(node.namespaceURI.endsWith("svg") ? style.fill : style.color), under);
  const [a, b] = [light(text), light(under)].sort((x, y) => y - x);
  const ratio = (a + 0.05) / (b + 0.05);
  const size = parseFloat(style.fontSize);
  const wanted = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700) ? 3 : 4.5;
  seen += 1;
  if (ratio < wanted) poor.push(`${walk.currentNode.data.trim().slice(0, 40)}: ${ratio.toFixed(2)}`);
}
return [seen, poor];
"""
CONTROLS = {"button", "link", "textbox", "searchbox", "combobox", "checkbox", "slider", "spinbutton", "image", "dialog", "navigation", "group", "progressbar", "meter"}
SIGHT = """
const n = document.activeElement;
if (n === document.body) return null;
const s = getComputedStyle(n);
const r = n.getBoundingClientRect();
return {seen: s.outlineStyle !== "none" && parseFloat(s.outlineWidth) >= 2, inside: r.bottom > 0 && r.top < innerHeight, what: (n.getAttribute("aria-label") || n.innerText || n.id || n.tagName).slice(0, 40),
  place: [...document.querySelectorAll("*")].indexOf(n)};
"""


def contrast(browser, where):
    seen, poor = browser.script(CONTRAST)
    check(f"{where}: texts were looked at", seen > 5, seen)
    same(f"{where}: contrast of 4.5 to 1, of large letters 3 to 1", poor, [])


def names(browser, where):
    """By the browser's own tree of accessibility."""
    tree = browser.cdp("Accessibility.getFullAXTree")["nodes"]
    nameless = [node["role"]["value"] for node in tree if not node.get("ignored") and node.get("role", {}).get("value") in CONTROLS - {"group", "navigation", "dialog"}
                and not node.get("name", {}).get("value", "").strip()]
    same(f"{where}: every control and picture has a name", nameless, [])
    levels = browser.script("return [...document.querySelectorAll('h1, h2, h3, h4')].filter((h) => h.checkVisibility()).map((h) => Number(h.tagName[1]))")
    same(f"{where}: one heading of the first level", levels.count(1), 1)
    same(f"{where}: no level of headings is left out", [b for a, b in zip(levels, levels[1:]) if b > a + 1], [])
    same(f"{where}: the language is said", browser.script("return document.documentElement.lang"), "en")
    same(f"{where}: ids are there once", browser.script("const ids = [...document.querySelectorAll('[id]')].map((n) => n.id); return ids.filter((id, i) => ids.indexOf(id) !== i)"), [])


def focus_order(browser, where, keys):
    """Tab goes through the page in the order of the text, and what has the focus is seen."""
    browser.script("document.getElementById('skip').focus()")  # the first of all, as the test of the keyboard shows
    places, unseen = [], []
    for _ in range(400):
        if places:
            browser.press(keys.TAB)
        now = browser.script(SIGHT)
        if now is None or (places and now["place"] <= places[-1]):
            break
        places.append(now["place"])
        if not now["seen"] or not now["inside"]:
            unseen.append(now["what"])
    wanted = browser.script("return [...document.querySelectorAll('a[href], button, input, select, summary, [tabindex]')].filter((n) => n.checkVisibility() && !n.disabled && n.tabIndex >= 0).length")
    check(f"{where}: Tab reaches every control in the order of the text", len(places) >= wanted, f"{len(places)} of {wanted}")
    same(f"{where}: what has the focus is seen", unseen, [])


def fits(browser, where, width):
    same(f"{where}: nothing is wider than {width} px", browser.script("return Math.max(document.documentElement.scrollWidth, document.body.scrollWidth)"), width)


def finger_sized(browser, where):
    small = browser.script("return [...document.querySelectorAll('button, select, input:not([type=range]):not([hidden]), nav a')].filter((n) => n.checkVisibility()).filter((n) => { const r = n.closest('td')?.getBoundingClientRect() ?? n.getBoundingClientRect();"
                           " return r.width < 24 || r.height < 24; }).map((n) => n.innerText || n.getAttribute('aria-label') || n.type)")
    same(f"{where}: nothing to be touched is smaller than 24 px", small, [])
