# SPDX-License-Identifier: GPL-3.0-or-later
"""By keyboard alone; 390 px wide; dark; without motion; contrast, names and order of the focus in every part."""
from accessibility import contrast, finger_sized, fits, focus_order, names
from browser import Browser, Keys, check, same, verdict
from laboratory import ROOT, Laboratory

PARTS = [("#/tests", "Tests"), ("#/test/1", "ICU 6"), ("#/compare/1,2", "2 tests over each other"), ("#/try", "Try a test before you run it"), ("#/stability", "Stability of a material"),
         ("#/running", "Running tests")]


def through(browser, does):
    for part, title in PARTS:
        browser.go(part)
        browser.until(lambda: browser.heading() == title, part)
        browser.settled()
        if part == "#/stability":
            browser.until(lambda: browser.all(".circular"), "the cone at the cursor", 60)
        does(part)


with Laboratory("icu_6", "icu_dense") as laboratory:
    with Browser(laboratory) as browser:
        browser.press(Keys.TAB)
        same("the first Tab offers to skip what is at the head", browser.focused(), "Skip to the content")
        browser.tab_to(".tests tbody a")
        browser.press(Keys.ENTER)
        browser.until(lambda: browser.heading() == "ICU 6", "a test is opened by key")
        browser.settled()
        same("the focus goes to the new heading", browser.focused(), "ICU 6")
        browser.tab_to(".chart")
        browser.press(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT, ".")
        browser.until(lambda: "kPa" in browser.texts(".readout")[0], "the cursor moves by key")
        readings = browser.script("return document.querySelector('.chart').dataset.draws")
        browser.press("+")
        browser.until(lambda: browser.script("return document.querySelector('.chart').dataset.draws") != readings, "zoomed by key")
        browser.go("#/tests")
        browser.until(lambda: browser.heading() == "Tests", "the tests")
        browser.one("#record-file").send_keys(str(ROOT / "samples/records/csd_58.csv"))
        browser.until(lambda: browser.heading() == "CSD 58", "a record that is chosen in the file dialogue is replayed too", 60)
        browser.go("#/try")
        browser.until(lambda: browser.heading() == PARTS[3][1], "the form")
        browser.tab_to("button[type=submit]")
        browser.press(Keys.ENTER)
        browser.until(lambda: browser.all("section[data-checksum]"), "a test is run by key")
        browser.tab_to("[data-order=stop]")
        browser.press(Keys.ENTER)
        browser.until(lambda: browser.all("dialog input"), "who asks")
        browser.press("Ada", Keys.ENTER)
        browser.until(lambda: "Really" in browser.texts("dialog h2")[0], "asked again")
        browser.tab_to("dialog button.danger")
        browser.press(Keys.ENTER)
        browser.until(lambda: browser.all(".assessment"), "stopped by key", 60)

    def all_of(browser, name):
        through(browser, lambda part: (contrast(browser, f"{name} {part}"), names(browser, f"{name} {part}")))

    with Browser(laboratory.again(), width=1280) as browser:
        all_of(browser, "light")
        through(browser, lambda part: focus_order(browser, part, Keys))
    with Browser(laboratory.again(), width=1280, dark=True, still=True) as browser:
        same("dark as the system has it", browser.script("return document.documentElement.dataset.theme"), "dark")
        check("the ground is dark", max(map(int, browser.script("return getComputedStyle(document.body).backgroundColor").strip("rgb()").split(","))) < 60)
        all_of(browser, "dark")
        through(browser, lambda part: same(f"nothing moves by itself at {part}", browser.script(
            "return [...document.querySelectorAll('*')].filter((n) => { const s = getComputedStyle(n); return parseFloat(s.transitionDuration) > 0 || s.animationName !== 'none'; }).length"), 0))
    with Browser(laboratory.again(), width=390, height=844, phone=True) as browser:
        through(browser, lambda part: (fits(browser, part, 390), finger_sized(browser, part), contrast(browser, f"narrow {part}")))
verdict()
