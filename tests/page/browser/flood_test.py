# SPDX-License-Identifier: GPL-3.0-or-later
"""More readings than a page can draw, as fast as they are computed: none is lost, none is doubled, and what the page holds does not grow."""
from browser import Browser, check, checksum_of, same, verdict
from laboratory import Laboratory

RUN = """
const done = arguments[0];
fetch("/api/runs", {method: "POST", headers: {"X-Triax": "1", "Content-Type": "application/json"},
  body: JSON.stringify({programme: "icu_6", set: {"test.scan_interval_s": 0.1}, speed: 400})}).then((answer) => answer.json()).then((told) => done(told.test));
"""


def held(browser):
    """Bytes of the page's heap after what is not used was thrown away, and its nodes."""
    browser.cdp("HeapProfiler.collectGarbage")
    nodes = {metric["name"]: metric["value"] for metric in browser.cdp("Performance.getMetrics")["metrics"]}["Nodes"]
    return browser.cdp("Runtime.getHeapUsage")["usedSize"], nodes


with Laboratory() as laboratory, Browser(laboratory) as browser:
    browser.cdp("Performance.enable")
    test = browser.driver.execute_async_script(RUN)
    browser.go(f"#/run/{test}")
    live = browser.until(lambda: browser.one("section[data-checksum]"), "the running test is shown")
    browser.until(lambda: int(live.get_attribute("data-received") or 0) > 15000, "readings come", 60)
    heap, nodes = held(browser)
    browser.until(lambda: browser.all(".assessment"), "it ends", 240)
    received = int(live.get_attribute("data-received"))
    more_heap, more_nodes = held(browser)
    print(f"{received} readings; heap {heap / 1e6:.2f} MB after 15,000, {more_heap / 1e6:.2f} MB at the end; nodes {nodes:.0f} and {more_nodes:.0f}")
    check("the heap has not grown with the readings", more_heap < heap * 1.25, (heap, more_heap))
    check("nor have the elements", more_nodes < nodes + 400, (nodes, more_nodes))
    rows = laboratory.query(f"SELECT s.reading, s.time_s, c.q_Pa / 1000.0 AS q FROM states s JOIN scans c ON c.id = (s.test_id << 32) + s.reading WHERE s.test_id = {test} ORDER BY s.reading")
    same("every reading came, once", (received, live.get_attribute("data-gaps"), live.get_attribute("data-first")), (len(rows), "0", "0"))
    same("to the bit as the database has them", live.get_attribute("data-checksum"), checksum_of((row["reading"], row["time_s"], row["q"]) for row in rows))
verdict()
