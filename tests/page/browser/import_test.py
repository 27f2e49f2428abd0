# SPDX-License-Identifier: GPL-3.0-or-later
"""A table with open questions gets a dialog: the answers give a stress path at once, then the test. A remembered choice reads the next file."""
from accessibility import contrast, finger_sized, fits, names
from browser import Browser, Select, check, same, verdict
from laboratory import Laboratory

HEAD = "Zeit;Dehnung;q;Druck\n;%;kPa;kPa\n"
ROWS = "".join(f"{10 * i};{0.1 * i:.1f};{2 * i};{200 + i}\n" for i in range(60)).replace(".", ",")
EVIL = "<img src=x onerror=window.was=1>"


def status(browser):
    return " ".join(browser.texts(".import-status"))


def path(browser):
    return browser.script("return document.querySelector('dialog .chart').chart.layers[0]")


with Laboratory() as laboratory, Browser(laboratory) as browser:
    one = laboratory.folder / "one.csv"
    one.write_text(HEAD + ROWS, encoding="utf-8")
    browser.drop(one)
    browser.until(lambda: browser.all("dialog.import"), "a file with questions opens the dialog")
    same("ten rows are shown as the file has them", len(browser.all("dialog .rows tbody tr")), 10)
    same("cells keep their decimal mark", browser.texts("dialog .rows tbody tr")[3].split(), ["30", "0,3", "6", "203"])
    check("the questions are those of the terminal", any("unit of column 1 'Zeit', time" in text for text in browser.texts(".questions li")), browser.texts(".questions li"))
    browser.until(lambda: "no unit" in status(browser), "the preview says what is missing")
    Select(browser.one("select[aria-label^='unit of column 1']")).select_by_visible_text("s")
    Select(browser.one("select[aria-label^='quantity of column 4']")).select_by_visible_text("pore pressure u")
    Select(browser.one("select[aria-label^='unit of column 4']")).select_by_visible_text("kPa")
    browser.one("input[name='test.cell_pressure_kPa']").send_keys("500")
    browser.until(lambda: "60 readings" in status(browser), "the stress path follows the choices")
    same("p′ of the first reading", round(path(browser)["x"][0], 6), 300)
    same("q of the last reading", round(path(browser)["y"][-1], 6), 118)
    Select(browser.one("select[aria-label^='sign of column 3']")).select_by_visible_text("−")
    browser.until(lambda: path(browser)["y"][-1] < 0, "another sign turns the path")
    Select(browser.one("select[aria-label^='sign of column 3']")).select_by_visible_text("+")
    browser.until(lambda: path(browser)["y"][-1] > 0 and "60 readings" in status(browser), "and turns it back")
    browser.button("Remember for files like this").click()
    browser.until(lambda: "Remembered in triax.db.dialects" in status(browser), "the choice is remembered")
    browser.button("Read").click()
    browser.until(lambda: "/test/" in browser.driver.current_url, "the file becomes a test", 60)
    browser.settled()
    same("its readings", laboratory.report(1)["test"]["readings"], 60)

    # Several files: the remembered choice reads one of them, each has its state.
    second, words = laboratory.folder / "second.csv", laboratory.folder / "words.txt"
    second.write_text(HEAD + ROWS, encoding="utf-8")
    words.write_text("no table at all\n", encoding="utf-8")
    browser.go("#/tests")
    browser.until(lambda: browser.heading() == "Tests", "back at the tests")
    browser.drop(second, words)
    browser.until(lambda: "not read" in " ".join(browser.texts(".import-list > li")), "the last of two files has its state", 60)
    found = browser.texts(".import-list > li")
    same("a line for each file", [text.split("\n")[0] for text in found], ["second.csv", "words.txt"])
    browser.button("Answer…").click()
    browser.until(lambda: browser.all("dialog.import"), "the dialog of the first file")
    same("the columns are those that were remembered", Select(browser.one("select[aria-label^='quantity of column 4']")).first_selected_option.text, "pore pressure u")
    browser.one("input[name='test.cell_pressure_kPa']").send_keys("500")
    browser.until(lambda: "60 readings" in status(browser), "the missing value is enough")
    browser.button("Read").click()
    browser.until(lambda: "test 2" in " ".join(browser.texts(".import-list > li")), "the list has the test", 60)
    browser.until(lambda: "2 tests" in browser.texts("p[role=status]"), "the table of tests has it")

with Laboratory() as laboratory, Browser(laboratory) as browser:
    drained = laboratory.folder / "drained.csv"
    drained.write_text("strain (%),q (kPa)\n" + "".join(f"{0.1 * i:.1f},{2 * i}\n" for i in range(60)), encoding="utf-8")
    browser.one("#columns-first").click()
    browser.drop(drained)
    browser.until(lambda: browser.all("dialog.import"), "the dialog")
    browser.one("input[name='test.cell_pressure_kPa']").send_keys("500")
    browser.one("input[name='back_pressure']").send_keys("200")
    browser.until(lambda: "60 readings" in status(browser), "two pressures give effective stresses")
    same("p′ from both pressures", round(path(browser)["x"][0], 6), 300)

GAUGES = "Time (s),Dial gauge (mm),Proving ring (div),Cell pressure (kPa),Pore pressure (kPa)\n" + "".join(f"{10 * i},{0.1 * i:.1f},{4 * i},400,{200 + i}\n" for i in range(40))
with Laboratory() as laboratory, Browser(laboratory) as browser:
    ring = laboratory.folder / "ring.csv"
    ring.write_text("Ring factor (N/div),2.5\nHeight (mm),100\nDiameter (mm),50\n\n" + GAUGES)
    browser.one("#columns-first").click()
    browser.drop(ring)
    browser.until(lambda: "40 readings" in status(browser), "the factor above the table is used")
    last = path(browser)["y"][-1]
    factor = browser.one("input[aria-label^='factor of column 3']")
    same("the factor of the file", factor.get_attribute("value"), "2.5")
    factor.clear()
    factor.send_keys("5")
    browser.until(lambda: abs(path(browser)["y"][-1] - 2 * last) < 1e-6 * last, "another factor changes q")
    Select(browser.one("select[aria-label^='quantity of column 3']")).select_by_visible_text("time of day")
    same("another quantity has no factor", browser.all("input[aria-label^='factor of column 3']"), [])

with Laboratory() as laboratory, Browser(laboratory) as browser:
    several = laboratory.folder / "several.csv"
    several.write_text(HEAD + ROWS + ROWS, encoding="utf-8")
    browser.drop(several)
    browser.until(lambda: browser.all("dialog.import"), "the dialog of a file with two tests")
    check("a column can name the tests", "test" in browser.texts("select[aria-label^='quantity of column 1']")[0].split("\n"), browser.texts("select[aria-label^='quantity of column 1']"))
    Select(browser.one("select[aria-label^='unit of column 1']")).select_by_visible_text("s")
    Select(browser.one("select[aria-label^='quantity of column 4']")).select_by_visible_text("pore pressure u")
    Select(browser.one("select[aria-label^='unit of column 4']")).select_by_visible_text("kPa")
    browser.one("input[name='test.cell_pressure_kPa']").send_keys("500")
    browser.until(lambda: "2 tests, all are read. Test 1: 60 readings" in status(browser), "the preview shows the first test")
    browser.button("Read").click()
    browser.until(lambda: "test 2" in " ".join(browser.texts(".import-list > li")), "both tests are listed", 60)
    same("a link for each test", [link.text for link in browser.all(".import-list a")], ["test 1", "test 2"])
    same("its readings", laboratory.report(2)["test"]["readings"], 60)
    browser.until(lambda: "2 tests" in browser.texts("p[role=status]"), "the table of tests has both")

with Laboratory() as laboratory, Browser(laboratory) as browser:
    total = laboratory.folder / "total.csv"
    total.write_text("Time (s),Axial strain (%),Deviator stress (kPa)\n" + "".join(f"{10 * i},{0.1 * i:.1f},{2 * i}\n" for i in range(60)))
    browser.one("#columns-first").click()
    browser.drop(total)
    browser.until(lambda: "kind of test" in " ".join(browser.texts(".questions li")), "the kind of test is a question")
    Select(browser.one("dialog .field.asked select")).select_by_value("UU")
    browser.until(lambda: "60 readings" in status(browser), "the answer makes it readable")
    browser.button("Read").click()
    browser.until(lambda: "/test/" in browser.driver.current_url, "the file becomes a test", 60)
    same("its kind", laboratory.report(1)["test"]["programme"], "UU")

for dark, width in ((False, 1440), (True, 390)):
    with Laboratory() as laboratory, Browser(laboratory, width=width, height=844, dark=dark, phone=width < 640) as browser:
        one = laboratory.folder / "one.csv"
        one.write_text(HEAD + ROWS, encoding="utf-8")
        browser.drop(one)
        browser.until(lambda: "no unit" in status(browser), "the dialog with its preview")
        contrast(browser, f"the dialog at {width} px")
        names(browser, f"the dialog at {width} px")
        fits(browser, f"the dialog at {width} px", width)
        if width < 640:
            finger_sized(browser, "the dialog")

with Laboratory() as laboratory, Browser(laboratory, quiet=False) as browser:
    hostile = laboratory.folder / "hostile.csv"
    hostile.write_text(f"{EVIL};\"a\"\"] = 1 # [test]\";q (kPa)\n" + "".join(f"{i};{i};{i}\n" for i in range(20)), encoding="utf-8")
    browser.one("#columns-first").click()
    browser.drop(hostile)
    browser.until(lambda: browser.all("dialog.import"), "the dialog on the user's wish")
    check("a heading is text", EVIL in browser.texts("dialog .rows thead")[0], browser.texts("dialog .rows thead"))
    browser.until(lambda: status(browser), "a preview or its reason")
    same("no element came of a heading", len(browser.all("dialog img")), 0)
    same("no script of a heading has run", browser.script("return window.was"), None)
    browser.button("Cancel").click()
    browser.until(lambda: not browser.all("dialog"), "cancelled")
    same("nothing is stored", browser.texts(".empty")[0][:17], "No test is stored")
verdict()
