# SPDX-License-Identifier: GPL-3.0-or-later
"""pixels.py PART TRIAX FOLDER [NUMBER...]. pixels [SECONDS [BROWSERS]]: from a reading to the curve of real browsers at 10 readings/s.
heap [MINUTES [WARM_UP_S]]: the heap of one page at 100 readings/s."""
import os
import pathlib
import statistics
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests/page/browser"))
from browser import Browser  # noqa: E402: says what is missing, and ends with 77
from clients import Page, Stream, held, share  # noqa: E402

PART, TRIAX, FOLDER = sys.argv[1:4]

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


def to_pixels(seconds=30, count=10):
    with Page(TRIAX, os.path.join(FOLDER, "pixels.db")) as page:
        test = page.run(10)
        told = {}
        stream = Stream(page, test)

        def listen():
            for _, kind, data in stream.events():
                if kind == "reading":
                    told[data["reading"]] = data["told_ms"]

        threading.Thread(target=listen, daemon=True).start()
        browsers = [shown(page, test) for _ in range(int(count))]
        time.sleep(5)
        for browser in browsers:
            browser.script(NOTE_DRAWN)
        time.sleep(seconds)
        late = []
        for browser in browsers:
            drawn = browser.script("return window.drawn")
            for (before, _), (reading, at) in zip(drawn, drawn[1:]):
                late += [at - told[one] for one in range(before + 1, reading + 1) if one in told]
        for browser in browsers:
            browser.driver.quit()
        page.post(f"/api/runs/{test}/stop", {"who": "bench"})
    print(f"10 readings/s, {count:.0f} browsers: reading to pixel median {statistics.median(late):.0f} ms, 99 % {share(late, 0.99):.0f} ms, at most {max(late):.0f} ms ({len(late)} readings)")
    held({"99 % in less than 100 ms": share(late, 0.99) < 100})


def heap(minutes=60, warm_up_s=90):  # then what the page keeps is full
    with Page(TRIAX, os.path.join(FOLDER, "heap.db")) as page:
        test = page.run(100)
        browser = shown(page, test)
        time.sleep(warm_up_s)
        used = []
        until = time.monotonic() + 60 * minutes
        while time.monotonic() < until:
            browser.cdp("HeapProfiler.collectGarbage")
            used.append(browser.cdp("Runtime.getHeapUsage")["usedSize"] / 1e6)
            time.sleep(5)
        quarter = max(len(used) // 4, 1)
        first, last = statistics.median(used[:quarter]), statistics.median(used[-quarter:])
        section = browser.one("section[data-checksum]")
        print(f"100 readings/s, {minutes:.0f} min: heap of the page {first:.2f} MB in the first quarter, {last:.2f} MB in the last ({100 * (last / first - 1):+.1f} %), "
              f"{section.get_attribute('data-received')} readings, {section.get_attribute('data-gaps')} gaps")
        browser.driver.quit()
        page.post(f"/api/runs/{test}/stop", {"who": "bench"})
        held({"heap of the page flat within 5 %": last < 1.05 * first})


{"pixels": to_pixels, "heap": heap}[PART](*map(float, sys.argv[4:]))
