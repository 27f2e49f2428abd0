# SPDX-License-Identifier: GPL-3.0-or-later
"""pixels.py TRIAX FOLDER [MINUTES [BROWSERS]]: from a reading to the curve of real browsers at 10 readings/s; then the heap of one page over MINUTES at 100 readings/s."""
import os
import pathlib
import statistics
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests/page/browser"))
from browser import Browser  # noqa: E402: says what is missing, and ends with 77
from clients import Page, Stream, share  # noqa: E402

TRIAX, FOLDER = sys.argv[1:3]
MINUTES = float(sys.argv[3]) if len(sys.argv) > 3 else 5
BROWSERS = int(sys.argv[4]) if len(sys.argv) > 4 else 10

NOTE_DRAWN = """
window.drawn = [];
const live = document.querySelector("section[data-checksum]");
new MutationObserver(() => window.drawn.push([Number(live.dataset.drawn), performance.timeOrigin + performance.now()]))
  .observe(live, {attributes: true, attributeFilter: ["data-drawn"]});
"""


class Place:
    def __init__(self, page):
        self.address = page.post("/api/browsers", {})["address"]


def shown(page, test):
    browser = Browser(Place(page))
    browser.go(f"#/run/{test}")
    browser.until(lambda: int(browser.one("section[data-checksum]").get_attribute("data-drawn") or 0) > 0, "readings are drawn", 60)
    return browser


def to_pixels():
    with Page(TRIAX, os.path.join(FOLDER, "pixels.db")) as page:
        test = page.run(10)
        told = {}
        stream = Stream(page, test)

        def listen():
            for _, kind, data in stream.events():
                if kind == "reading":
                    told[data["reading"]] = data["told_ms"]

        threading.Thread(target=listen, daemon=True).start()
        browsers = [shown(page, test) for _ in range(BROWSERS)]
        time.sleep(5)
        for browser in browsers:
            browser.script(NOTE_DRAWN)
        time.sleep(30)
        late = []
        for browser in browsers:
            drawn = browser.script("return window.drawn")
            for (before, _), (reading, at) in zip(drawn, drawn[1:]):
                late += [at - told[one] for one in range(before + 1, reading + 1) if one in told]
        for browser in browsers:
            browser.driver.quit()
        page.post(f"/api/runs/{test}/stop", {"who": "bench"})
    print(f"10 readings/s, {BROWSERS} browsers: reading to pixel median {statistics.median(late):.0f} ms, 99 % {share(late, 0.99):.0f} ms, at most {max(late):.0f} ms ({len(late)} readings)")


def heap():
    with Page(TRIAX, os.path.join(FOLDER, "heap.db")) as page:
        test = page.run(100)
        browser = shown(page, test)
        time.sleep(90)  # what the page keeps is full
        used = []
        until = time.monotonic() + 60 * MINUTES
        while time.monotonic() < until:
            browser.cdp("HeapProfiler.collectGarbage")
            used.append(browser.cdp("Runtime.getHeapUsage")["usedSize"] / 1e6)
            time.sleep(5)
        quarter = max(len(used) // 4, 1)
        first, last = statistics.median(used[:quarter]), statistics.median(used[-quarter:])
        section = browser.one("section[data-checksum]")
        print(f"100 readings/s, {MINUTES:.0f} min: heap of the page {first:.2f} MB in the first quarter, {last:.2f} MB in the last ({100 * (last / first - 1):+.1f} %), "
              f"{section.get_attribute('data-received')} readings, {section.get_attribute('data-gaps')} gaps")
        browser.driver.quit()
        page.post(f"/api/runs/{test}/stop", {"who": "bench"})


to_pixels()
heap()
