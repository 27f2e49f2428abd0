# SPDX-License-Identifier: GPL-3.0-or-later
"""A programme on the instruments of a rig, from the page: channels with their state, hold, safe stop, each in the record."""
import re
import socket
import subprocess

from browser import Browser, check, order, same, verdict
from laboratory import PROGRAM, ROOT, Laboratory


def rig_on_free_ports(folder):
    """The sample's rig, with other ports so that other tests may run beside this one."""
    text = (ROOT / "samples/rigs/icu_6.toml").read_text(encoding="utf-8").replace("../programmes", str(ROOT / "samples/programmes"))
    probes = {port: socket.create_server(("127.0.0.1", 0)) for port in set(re.findall(r"127\.0\.0\.1:(\d+)", text))}
    for port, probe in probes.items():
        text = text.replace(f"127.0.0.1:{port}", f"127.0.0.1:{probe.getsockname()[1]}")
        probe.close()
    file = folder / "rig.toml"
    file.write_text(text, encoding="utf-8")
    return file


with Laboratory() as laboratory:
    rig = rig_on_free_ports(laboratory.folder)
    served = subprocess.Popen([PROGRAM, "serve", str(rig), "--speed", "60"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        laboratory.more = (str(rig),)
        with Browser(laboratory.again(), width=1440, height=1000) as browser:
            browser.go("#/try")
            browser.until(lambda: browser.button("Run the test"), "the form")
            browser.choose("Programme", "ICU 6")
            browser.one("input[type=checkbox]").click()
            browser.button("Run the test").click()
            live = browser.until(lambda: browser.one("section[data-checksum]"), "the running test is shown")
            browser.until(lambda: int(live.get_attribute("data-drawn") or 0) > 20, "readings of the instruments are drawn", 60)
            names = browser.until(lambda: browser.texts(".live-grid tbody th"), "channels are told")
            check("the channels of the rig", {"axial force", "cell pressure", "pore pressure", "axial displacement"} <= set(names), names)
            check("with their state", all("good" in text for text in browser.texts(".health")), browser.texts(".health"))
            order(browser, "Hold", "Ada")
            browser.until(lambda: browser.one("[data-order=resume]").is_enabled(), "the drives are held", 60)
            order(browser, "Safe stop", "Grace")
            browser.until(lambda: browser.all(".assessment"), "the test ends in its safe state", 120)
        events = laboratory.report(1)["events"]
        for who in ("Ada", "Grace"):
            check(f"{who} is in the record", any(who in event["detail"] for event in events), events[-4:])
        same("instruments that say so make a simulated test", laboratory.report(1)["test"]["origin"], "simulated")
    finally:
        served.terminate()
        served.wait()
verdict()
