# SPDX-License-Identifier: GPL-3.0-or-later
"""One test: five charts with one cursor, zoom, pan, other axes; criteria and checks with evidence; report sheet and downloads."""
import json

from browser import ActionChains, Browser, Keys, check, same, verdict
from laboratory import Laboratory


def shown_range(browser):
    words = browser.texts(".readout")[0].split()
    return int(words[1]), int(words[3].rstrip(";"))


def dots(browser):
    return browser.script("return [...document.querySelectorAll('.dot')].filter((d) => getComputedStyle(d).display === 'block').length")


with Laboratory("icu_6") as laboratory, Browser(laboratory, width=1440, height=1000) as browser:
    known = laboratory.report(1)
    browser.button("ICU 6").click()
    browser.until(lambda: browser.heading() == "ICU 6", "the test is opened from the table")
    browser.settled()
    charts = browser.all(".chart")
    same("q-p', q-strain, u, volume and second-order work", [chart.get_attribute("aria-label") for chart in charts],
         ["deviator stress q over mean effective stress p′", "deviator stress q over axial strain ε₁", "pore pressure u over time", "volumetric strain εᵥ over time",
          "normalised second-order work W₂ over time"])
    whole = browser.until(lambda: shown_range(browser), "the readings that are shown are said")
    same("shear is shown first", whole, (known["collapse"]["judged"]["from_reading"], known["test"]["readings"] - 1))

    over = charts[2].find_element("css selector", ".u-over")
    ActionChains(browser.driver).move_to_element(over).perform()
    browser.until(lambda: "reading" in browser.texts(".readout")[0] and "kPa" in browser.texts(".readout")[0], "the readings below the cursor are said")
    same("one cursor stands in every chart", dots(browser), 5)
    ActionChains(browser.driver).move_to_element_with_offset(over, -60, 0).click_and_hold().move_by_offset(90, 0).release().perform()
    browser.until(lambda: browser.script("return document.querySelector('.chart').dataset.draws") != "1", "the zoom is drawn")
    browser.press(Keys.ESCAPE)
    charts[0].send_keys(Keys.ESCAPE)
    zoomed = browser.until(lambda: shown_range(browser), "the zoomed readings are said")
    check("a span that is drawn in one chart is shown in all", whole[0] < zoomed[0] < zoomed[1] < whole[1], zoomed)
    charts[0].send_keys(Keys.SHIFT + Keys.ARROW_RIGHT)
    browser.until(lambda: shown_range(browser)[0] > zoomed[0], "panned by key")
    same("panning keeps the width", shown_range(browser)[1] - shown_range(browser)[0], zoomed[1] - zoomed[0])
    charts[0].send_keys("0")
    browser.until(lambda: shown_range(browser) == whole, "0 shows all again")

    for button, title in (("total", "mean total stress p (kPa)"), ("s′, t", None), ("log", None), ("strain", None), ("whole test", None)):
        browser.button(button).click()
        browser.settled()
        if title:
            check(f"{button}: the charts are those of total stress", "mean total stress" in browser.all(".chart")[0].get_attribute("aria-label"))
    same("the whole test is shown", shown_range(browser), (0, known["test"]["readings"] - 1))
    same("s, t, total, over strain", browser.all(".chart")[0].get_attribute("aria-label"), "t = (σ₁ − σ₃)/2 over s = (σ₁ + σ₃)/2")

    text = browser.script("return document.querySelector('main').innerText")
    for criterion in known["collapse"]["criteria"]:
        check(f"evidence of {criterion['name']}", criterion["evidence"] in text)
    for item in known["checks"]:
        check(f"note of {item['name']}", item["note"] in text)
    browser.one("[aria-label='Cursor to reading 1258']").click()
    browser.until(lambda: "reading 1258" in browser.texts(".readout")[0].replace("\n", " "), "an event puts the cursor at its reading")

    for kind in ("JSON", "CSV", "PDF", "HTML"):
        browser.button(f"↓ {kind}").click()
        ending = f".{kind.lower()}"
        file = browser.until(lambda: [f for f in browser.downloads() if f.suffix == ending and f.stat().st_size > 0], f"{kind} is downloaded", 60)[0]
        content = file.read_bytes()
        if kind == "JSON":
            same("the JSON is the report's", json.loads(content)["collapse"]["eta"], known["collapse"]["eta"])
        if kind == "PDF":
            check("the PDF is one", content.startswith(b"%PDF"))
        if kind == "CSV":
            again = laboratory.folder / "again.csv"
            again.write_bytes(content)
            laboratory.triax("replay", str(again), "--db", str(laboratory.folder / "again.db"))
    browser.button("Test report").click()
    browser.until(lambda: len(browser.driver.window_handles) == 2, "the report sheet opens")
    browser.driver.switch_to.window(browser.driver.window_handles[1])
    browser.until(lambda: "flow" in browser.script("return document.body.innerText"), "the report sheet has the verdict", 60)
    check("the report sheet has its figures", len(browser.all("svg, img")) >= 2, len(browser.all("svg, img")))
verdict()
