# SPDX-License-Identifier: GPL-3.0-or-later
"""A real browser at the page, with its log of requests and its console, which are judged at the end of every test."""
import json
import os
import pathlib
import shutil
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests/wire"))
from judging import check, needs, same, verdict  # noqa: E402, F401: for the tests

needs("chromium", "chromedriver", modules=("selenium",))
from selenium import webdriver  # noqa: E402
from selenium.webdriver.chrome.service import Service  # noqa: E402
from selenium.webdriver.common.action_chains import ActionChains  # noqa: E402
from selenium.webdriver.common.by import By  # noqa: E402
from selenium.webdriver.common.keys import Keys  # noqa: E402, F401: for the tests
from selenium.webdriver.support.ui import Select  # noqa: E402


class Browser:
    """At the address of a laboratory. `quiet=False` where the test provokes errors that a console shows."""

    def __init__(self, laboratory, width=1280, height=900, dark=False, still=False, phone=False, quiet=True):
        self.laboratory, self.quiet = laboratory, quiet
        self.room = tempfile.TemporaryDirectory(prefix="triax-browser-")
        self.folder = pathlib.Path(self.room.name)
        options = webdriver.ChromeOptions()
        for argument in ("--headless=new", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run", "--disable-background-networking",
                         "--disable-component-update", "--disable-features=AutofillServerCommunication", "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1", "--disable-sync", "--disable-default-apps", "--hide-scrollbars", f"--window-size={width},{height}",
                         f"--log-net-log={self.folder}/net.json", "--net-log-capture-mode=Default", f"--user-data-dir={self.folder}/profile"):
            options.add_argument(argument)
        if os.geteuid() == 0:
            options.add_argument("--no-sandbox")
        options.add_experimental_option("prefs", {
            "download.default_directory": str(self.folder / "downloads"), "download.prompt_for_download": False,
            # Not the page for new tabs, which has requests and a console of its own.
            "session.restore_on_startup": 4, "session.startup_urls": ["about:blank"]})
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        # Named, since newer versions of selenium look for them with a program that Debian does not have.
        options.binary_location = shutil.which("chromium")
        self.driver = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
        self.cdp("Emulation.setFocusEmulationEnabled", enabled=True)  # Tab behind the last control gives the window away
        self.size(width, height, phone)
        features = [("prefers-color-scheme", "dark" if dark else "light"), ("prefers-reduced-motion", "reduce" if still else "no-preference")]
        self.cdp("Emulation.setEmulatedMedia", features=[{"name": name, "value": value} for name, value in features])
        self.console = []
        self.driver.get(laboratory.address)
        self.until(lambda: self.heading(), "the page has a heading")

    def cdp(self, command, **arguments):
        return self.driver.execute_cdp_cmd(command, arguments)

    def size(self, width, height, phone=False):
        self.cdp("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=phone)

    def script(self, text, *arguments):
        return self.driver.execute_script(text, *arguments)

    def all(self, css):
        return self.driver.find_elements(By.CSS_SELECTOR, css)

    def one(self, css):
        return self.driver.find_element(By.CSS_SELECTOR, css)

    def texts(self, css):
        return self.script("return [...document.querySelectorAll(arguments[0])].map((node) => node.innerText.trim())", css)

    def heading(self):
        found = self.texts("h1")
        return found[0] if found else None

    def button(self, text):
        """The button or link that is called so."""
        for node in self.all("button, a, summary"):
            if node.is_displayed() and text.lower() in (node.text or node.get_attribute("aria-label") or "").lower():
                self.script("arguments[0].scrollIntoView({block: 'center'})", node)
                return node
        raise AssertionError(f"no button or link {text}: {self.texts('button, a')}")

    def choose(self, label, text):
        """Chooses in the list below this label."""
        node = self.script("return [...document.querySelectorAll('label')].find((l) => l.innerText === arguments[0])?.control", label)
        Select(node).select_by_visible_text(text)

    def go(self, part):
        self.script("location.hash = arguments[0]", part)

    def until(self, reached, what, seconds=20):
        end = time.monotonic() + seconds
        while True:
            try:
                found = reached()
            except Exception as wrong:  # noqa: BLE001: the page is being changed
                found, last = None, wrong
            else:
                last = found
            if found:
                return found
            if time.monotonic() > end:
                self.driver.save_screenshot("/tmp/triax-page-failed.png")
                self.read_console()
                raise SystemExit(f"FAILED: {what}: not within {seconds} s: {last!r}; heading {self.heading()!r}; console {self.console}")
            time.sleep(0.02)

    def settled(self):
        """Everything was asked for and drawn: charts that are there have drawn, and two frames have passed."""
        self.until(lambda: self.script("return document.getElementById('main').getAttribute('aria-busy') === null && [...document.querySelectorAll('.chart')].every((c) => Number(c.dataset.draws) > 0)"),
                   "the charts have drawn")
        self.driver.execute_async_script("const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(done))")

    def press(self, *keys):
        chain = ActionChains(self.driver)
        for key in keys:
            chain.send_keys(key)
        chain.perform()

    def focused(self):
        return self.script("const n = document.activeElement; return (n.getAttribute('aria-label') || n.innerText || n.name || n.tagName).trim()")

    def tab_to(self, css, most=150):
        """Presses Tab until the focus is on this: what is reached so can be used without a mouse."""
        for _ in range(most):
            if self.script("return document.activeElement.matches(arguments[0])", css):
                return self.driver.switch_to.active_element
            self.press(Keys.TAB)
        raise SystemExit(f"FAILED: Tab does not reach {css}; it is at {self.focused()!r}")

    def drop(self, *files):
        """Files fall on the main part of the page, as from a file manager."""
        room = self.script("const r = document.getElementById('main').getBoundingClientRect(); return [r.left + r.width / 2, Math.min(r.top + 160, innerHeight - 20)]")
        data = {"items": [], "files": [str(file) for file in files], "dragOperationsMask": 1}
        for kind in ("dragEnter", "dragOver", "drop"):
            self.cdp("Input.dispatchDragEvent", type=kind, x=room[0], y=room[1], data=data)

    def read_console(self):
        self.console += [f"{line['level']}: {line['message']}" for line in self.driver.get_log("browser")]
        return self.console

    def downloads(self):
        return sorted((self.folder / "downloads").glob("*")) if (self.folder / "downloads").exists() else []

    def requests(self):
        """Addresses that were requested, with their initiators, by the browser's own log; after its end."""
        text = (self.folder / "net.json").read_text(encoding="utf-8", errors="replace")
        try:
            events = json.loads(text)["events"]
        except json.JSONDecodeError:  # the last lines are missing where it was ended early
            events = json.loads(text[:text.rindex("},\n") + 1] + "]}")["events"]
        told = [event["params"] for event in events if isinstance(event.get("params"), dict)]
        return {(params["url"], params["initiator"]) for params in told if "url" in params and "initiator" in params}

    def __enter__(self):
        return self

    def __exit__(self, kind, *_):
        if kind is None:
            self.read_console()
        self.driver.quit()
        if kind is None:
            if self.quiet:
                same("nothing in the browser's console", self.console, [])
            origin = self.laboratory.origin
            asked = self.requests()
            # The browser requests things for itself (updates, pages for new tabs), each version others. The initiator of what the page
            # requests is the page's origin, or an opaque origin that names it as its source (a frame without an origin of its own).
            outside = [url for url, initiator in asked if origin in initiator and not url.startswith((origin + "/", f"blob:{origin}/"))]
            same("the page asked for nothing outside of this machine", outside, [])
            check("the browser's log has what the page asked for", (origin + "/api/tests", origin) in asked, sorted(asked)[:5])
        self.room.cleanup()


def checksum_of(rows) -> str:
    """What the page computes of the readings that it was given: FNV-1a over reading, time and q as float64."""
    import struct
    value = 0x811c9dc5
    for row in rows:
        for byte in struct.pack("<3d", *(float("nan") if v is None else v for v in row)):
            value = ((value ^ byte) * 0x01000193) & 0xffffffff
    return f"{value:08x}"


def order(browser, name, who):
    """An order is asked twice, and not given before."""
    browser.button(name).click()
    field = browser.until(lambda: browser.one("dialog input"), "who asks is asked")
    field.send_keys(Keys.CONTROL, "a")
    field.send_keys(who)
    browser.button("Yes").click()
    browser.until(lambda: "Really" in browser.texts("dialog h2")[0], "it is asked a second time")
    browser.one("dialog button:last-child").click()
