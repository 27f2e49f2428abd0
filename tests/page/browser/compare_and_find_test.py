# SPDX-License-Identifier: GPL-3.0-or-later
"""The table sorts and filters, small stress paths, three tests over each other, the domain of a material with a cursor."""
from browser import ActionChains, Browser, Keys, Select, check, same, verdict
from laboratory import Laboratory


def names(browser):
    return browser.texts(".tests td.name")


with Laboratory("icu_6", "csd_58", "icu_dense") as laboratory, Browser(laboratory, width=1440, height=1000) as browser:
    same("all tests", names(browser), ["ICU 6", "CSD 58", "ICU dense"])
    browser.button("η at onset").click()
    same("sorted by η at onset, unknown last", names(browser), ["CSD 58", "ICU 6", "ICU dense"])
    browser.button("η at onset").click()
    same("and the other way, unknown last", names(browser), ["ICU 6", "CSD 58", "ICU dense"])
    same("how it is sorted is said", [th.get_attribute("aria-sort") for th in browser.all("th[aria-sort]")], ["descending"])
    same("the focus stays at the heading", browser.focused(), "η at onset (–)")
    browser.choose("Collapse", "none")
    same("filtered by kind of collapse", names(browser), ["ICU dense"])
    browser.choose("Collapse", "all")
    browser.one("input[type=search]").send_keys("csd")
    same("filtered by name", names(browser), ["CSD 58"])
    same("how many are left is said", browser.texts("[role=status]")[0], "1 of 3 tests")
    browser.one("input[type=search]").send_keys(Keys.BACKSPACE * 3)

    browser.button("stress paths").click()
    browser.until(lambda: len(browser.all(".card svg[role=img]")) == 3, "three small stress paths")
    check("their axes have units", all("kPa" in text for text in browser.script("return [...document.querySelectorAll('.card svg')].map((s) => s.textContent)")))
    browser.button("table").click()

    for box in browser.all(".tests input[type=checkbox]"):
        box.click()
    browser.button("Compare 3 tests").click()
    browser.until(lambda: browser.heading() == "3 tests over each other", "three tests are compared")
    browser.settled()
    same("each is told by name", [text for text in browser.texts(".legend li")], ["ICU 6", "CSD 58", "ICU dense"])
    dashes = browser.script("return [...document.querySelectorAll('.legend line')].map((l) => l.getAttribute('stroke-dasharray'))")
    same("and by a dash of its own beside the colour", len(set(dashes)), 3)
    same("their onsets beside each other", len(browser.all("tbody tr")), 3)

    browser.go("#/stability")
    browser.until(lambda: browser.heading() == "Stability of a material", "stability")
    browser.until(lambda: browser.all(".circular"), "the cone at the cursor", 60)
    browser.settled()
    Select(browser.all("select")[1]).select_by_visible_text("ICU 6")
    browser.until(lambda: "Cones along the test" in browser.texts("h2"), "cones along the stress path", 60)
    rows = browser.texts("tbody tr")
    check("stable at first, then cones open", "none" in rows[0] and any("to" in row for row in rows), rows)
    chart = browser.one(".chart")
    before = browser.texts(".figures")
    chart.send_keys(Keys.ARROW_UP, Keys.ARROW_UP)
    browser.until(lambda: browser.texts(".figures") != before, "arrow keys move the cursor")
    ActionChains(browser.driver).move_to_element_with_offset(chart.find_element("css selector", ".u-over"), 100, 150).perform()
    browser.until(lambda: "Stable in every direction." in browser.texts("p"), "below the domain every direction is stable")
verdict()
