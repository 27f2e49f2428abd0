# SPDX-License-Identifier: GPL-3.0-or-later
"""A virtual test is made in the form, run, watched to its collapse, held and gone on with; the page has what the database has."""
import time

from browser import Browser, check, checksum_of, order, same, verdict
from laboratory import Laboratory

with Laboratory() as laboratory, Browser(laboratory, width=1440, height=1000) as browser:
    browser.go("#/try")
    browser.until(lambda: browser.heading() == "Try a test before you run it", "the form")
    browser.choose("Programme", "ICU 6")
    browser.choose("Speed", "60 times real time")
    ratio = browser.one("[data-key='specimen.void_ratio'] input[type=number]")
    ratio.clear()
    ratio.send_keys("1.112")
    same("the slider goes with the number", browser.one("[data-key='specimen.void_ratio'] input[type=range]").get_attribute("value")[:5], "1.112")
    browser.button("Run the test").click()
    live = browser.until(lambda: browser.one("section[data-checksum]"), "the running test is shown")
    browser.until(lambda: int(live.get_attribute("data-drawn") or 0) > 50, "readings are drawn")

    order(browser, "Hold", "Ada")
    browser.until(lambda: browser.one("[data-order=resume]").is_enabled(), "it is held")
    browser.until(lambda: browser.texts(".signal .word")[0].endswith("held"), "that is said largest")
    time.sleep(1.5)
    check("who held it is told", any("Ada" in text for text in browser.texts(".event-list li")), browser.texts(".event-list li")[:2])
    browser.button("Go on").click()
    browser.button("Cancel").click()
    time.sleep(0.3)
    check("what was cancelled is not done", browser.one("[data-order=resume]").is_enabled())
    order(browser, "Go on", "Grace")
    browser.until(lambda: browser.one("[data-order=hold]").is_enabled(), "it goes on")

    words = set()
    browser.until(lambda: words.add(browser.one(".signal").get_attribute("data-word")) or "unstable" in words, "its collapse is seen live", 200)
    check("the alarm came before", "imminent" in words or "approaching" in words, words)
    check("the distance to the instability line is said", "instability line" in browser.script("return document.querySelector('.gauge').textContent"))
    check("channels are told with their state", len(browser.all(".health")) >= 4, browser.texts(".health"))
    browser.until(lambda: browser.all(".assessment"), "the verdict at its end", 250)
    same("flow collapse", browser.one(".assessment").get_attribute("data-verdict"), "flow")

    rows = laboratory.query("SELECT s.reading, s.time_s, c.q_Pa / 1000.0 AS q FROM states s JOIN scans c ON c.id = (s.test_id << 32) + s.reading WHERE s.test_id = 1 ORDER BY s.reading")
    same("every reading came, once", (live.get_attribute("data-received"), live.get_attribute("data-gaps")), (str(len(rows)), "0"))
    same("what came is what the database has, to the bit", live.get_attribute("data-checksum"), checksum_of((row["reading"], row["time_s"], row["q"]) for row in rows))
    events = laboratory.report(1)["events"]
    for kind, who in (("held", "Ada"), ("resumed", "Grace")):
        check(f"{kind} is an event of the record, with who", any(e["kind"] == kind and who in e["detail"] for e in events), [e for e in events if e["kind"] == kind])
    held, resumed = (next(e["reading"] for e in events if e["kind"] == kind) for kind in ("held", "resumed"))
    cell = [row["cell_pressure_kPa"] for row in laboratory.query(f"SELECT cell_pressure_kPa FROM scans WHERE id BETWEEN (1 << 32) + {held + 3} AND (1 << 32) + {resumed}")]
    check("while it was held readings came and the cell pressure stood still", len(cell) > 50 and max(cell) - min(cell) < 2, (len(cell), cell[:1], cell[-1:]))
    same("the change is in the record's name or programme", "1.112" in laboratory.report(1)["test"]["name"], True)

    # A second one is stopped.
    browser.go("#/try")
    browser.until(lambda: browser.button("Run the test"), "the form again")
    browser.choose("Speed", "10 times real time")
    browser.button("Run the test").click()
    live = browser.until(lambda: browser.one("section[data-checksum]"), "the second test")
    browser.until(lambda: int(live.get_attribute("data-drawn") or 0) > 20, "readings are drawn")
    order(browser, "Safe stop", "Ada")
    browser.until(lambda: browser.all(".assessment"), "the stopped test ends", 60)
    check("who stopped it is in the record", any("Ada" in e["detail"] for e in laboratory.report(2)["events"]), laboratory.report(2)["events"][-2:])
verdict()
