# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves are open where a sensor is dead and dotted where the specimen ran away between two readings, stored and compared."""
from browser import Browser, check, same, verdict
from laboratory import Laboratory

# Of one line of each chart: title, readings with a value, and pairs of places that are dotted.
LINES = """return [...document.querySelectorAll('.chart')].map((node) => {
  const line = node.chart.layers.filter((layer) => layer.kind === 'line').at(arguments[0]);
  return { title: node.getAttribute('aria-label'), known: line.y.filter((v) => v !== null).length, all: line.y.length, last: line.y.at(-1),
    dotted: [...(line.dotted ?? [])].map((i) => [line.x[i - 1], line.y[i - 1], line.x[i], line.y[i]]) };
})"""


def lines(browser, which=0):
    browser.settled()
    return {line["title"].split(",")[0] if which else line["title"].split(" over ")[0]: line for line in browser.script(LINES, which)}


with Laboratory("faults/stuck_pore_pressure", "csu_26") as laboratory, Browser(laboratory, width=1440, height=1000) as browser:
    dead, fallen = laboratory.report(1), laboratory.report(2)
    fault = next(e for e in dead["events"] if e["kind"] == "sensor_fault")
    browser.go("#/test/1")
    browser.until(lambda: len(browser.all(".chart")) == 5, "the charts of the test with a dead sensor")
    browser.button("whole test").click()
    drawn = lines(browser)
    u = drawn["pore pressure u"]
    check("the pore pressure is not drawn from where its transducer is stuck", u["last"] is None and 0 < u["known"] < u["all"], (fault, u))
    check("nor is p′, which follows from it", drawn["deviator stress q"]["known"] > 0, drawn)
    window = browser.script("""return fetch('/api/tests/1/window?columns=pore_pressure_kPa,p_eff_kPa,q_kPa').then((r) => r.json())""")
    for name, known in (("pore_pressure_kPa", False), ("p_eff_kPa", False), ("q_kPa", True)):
        same(f"{name} at the last reading is known", window["columns"][name][-1] is not None, known)
    same("the fault is listed", [(f["channel"], f["from"], f["to"]) for f in window["faults"]], [("pore_pressure_kPa", fault["reading"], None)])

    browser.go("#/test/2")
    browser.until(lambda: browser.heading() == fallen["test"]["name"], "the test that ran away")
    for title, line in lines(browser).items():
        check(f"{title}: the runaway between two readings is dotted", len(line["dotted"]) >= 1, line)
    check("the legend says what dots are", any("nothing was read between" in text for text in browser.texts(".legend li")), browser.texts(".legend li"))
    browser.go("#/compare/1,2")
    browser.until(lambda: len(browser.all(".chart")) == 4, "two tests over each other")
    for title, line in lines(browser, -1).items():
        check(f"{title}: the runaway is dotted where tests are compared", len(line["dotted"]) >= 1, line)
verdict()
