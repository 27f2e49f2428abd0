# SPDX-License-Identifier: GPL-3.0-or-later
"""A record is dropped: its verdict is seen. What a record does not say is asked for, exactly that, and then it is right. Names are text."""
from browser import Browser, check, same, verdict
from laboratory import ROOT, Laboratory

RECORD = ROOT / "samples/records/icu_6.csv"

with Laboratory() as laboratory, Browser(laboratory) as browser:
    same("an empty database says what to do", browser.texts(".empty"), ['No test is stored yet. Drop a record above, or run one under "Try it".'])
    browser.drop(RECORD)
    browser.until(lambda: browser.heading() == "ICU 6", "the dropped record is shown as a test", 60)
    browser.settled()
    known = laboratory.report(1)
    same("its verdict is that of the report", browser.one(".assessment").get_attribute("data-verdict"), known["collapse"]["kind"])
    check("the word of the verdict", "flow collapse" in browser.texts(".assessment .word")[0], browser.texts(".assessment .word"))
    check("the stress ratio of the onset", f"{known['collapse']['eta']:.2f}" in browser.texts(".assessment")[0], browser.texts(".assessment"))
    check("it says what was recognised", "was replayed" in browser.texts(".notice")[0], browser.texts(".notice"))

    # The same record without the height and diameter of its specimen.
    lacking = laboratory.folder / "lacking.csv"
    lines = RECORD.read_text(encoding="utf-8").splitlines(keepends=True)
    keys = ("specimen.height_mm", "specimen.diameter_mm")
    left_out = tuple(f"# {key.split('.')[1]} =" for key in keys)
    lacking.write_text("".join(line for line in lines if not line.startswith(left_out)), encoding="utf-8")
    browser.go("#/tests")
    browser.until(lambda: browser.heading() == "Tests", "back at the tests")
    browser.drop(lacking)
    browser.until(lambda: browser.all("form input[name]"), "the form of what is missing")
    same("exactly the missing keys are asked for", sorted(node.get_attribute("name") for node in browser.all("form input[name]")), sorted(keys))
    for key, value in zip(keys, ("140", "70")):
        browser.one(f"form input[name='{key}']").send_keys(value)
    browser.button("Replay with these").click()
    browser.until(lambda: "/test/" in browser.driver.current_url, "the record is replayed with the answers", 60)
    browser.settled()
    again = laboratory.report(browser.driver.current_url.rsplit("/", 1)[1])
    for key in ("kind", "reading", "eta"):
        same(f"with the answers {key} is that of the whole record", again["collapse"][key], known["collapse"][key])

with Laboratory() as laboratory, Browser(laboratory, quiet=False) as browser:
    hostile = laboratory.folder / "<img src=x onerror=window.was=1>.csv"
    hostile.write_text("<script>window.was=1</script>;;\n<b>1</b>;2\n", encoding="utf-8")
    browser.drop(hostile)
    said = browser.until(lambda: browser.texts(".notice.bad"), "a file that is no record is refused in words")
    check("the refusal is one line that says why", "did not work" in said[0], said)
    named = laboratory.folder / "named.csv"
    evil = "<img src=x onerror=window.was=1><script>window.was=1</script>"
    named.write_text(RECORD.read_text(encoding="utf-8").replace("ICU 6", evil), encoding="utf-8")
    browser.drop(named)
    browser.until(lambda: browser.heading() == evil, "a name with HTML is shown as text", 60)
    for part in ("#/tests", "#/compare/1,1", "#/stability"):
        browser.go(part)
        browser.settled()
        browser.until(lambda: evil in browser.script("return document.body.textContent"), f"the name is text at {part}")
        same(f"no element came of it at {part}", len(browser.all("main img, main script, main b")), 0)
    same("no script of a name has run", browser.script("return window.was"), None)
verdict()
