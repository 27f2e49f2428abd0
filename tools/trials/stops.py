# SPDX-License-Identifier: GPL-3.0-or-later
"""Stops a program of a rig (SIGSTOP) at random instants for 0.1 to 60 s and lets it go on (SIGCONT), as Ctrl-Z and fg, a paused virtual
machine or swapping do: `triax run`, `triax open`, `triax record` or the `triax serve` that they ask. A trial has several rigs at a time. What must hold:
no program crashes; every reading that was committed stays; nothing is invented; each gap of readings and each missing cell is reported; a
test ends as its programme says where no stop was long, and in the safe state (status 3) where one was above the limit; its drives stand."""
import http.client
import itertools
import json
import math
import pathlib
import random
import re
import signal
import socket
import sqlite3
import threading
import time
import urllib.parse

from .contents import check_whole
from .trial import Broken, Running, Trial, name_of

PARTS = ("run", "open", "record", "serve under run", "serve under record")
RIGS = 6
INTERVAL_S = 0.25
DEADLINE_S = 2.0  # the longest of the instruments
SHORTEST_S, LONGEST_S = 0.1, 60.0
# The limit is 3 s, to be reached within a deadline and a tick; between these two a test may end either way.
SURELY_SHORT_S, SURELY_LONG_S = 2.0, 4.5
CELL_KPA = 400.0
WATCHDOG_S = 5.0

PROGRAMME = """[test]
name = "stopped"
type = "ICD"
seed = 3
scan_interval_s = 0.25
[specimen]
material = "sanisand/S28-general"
height_mm = 140.0
diameter_mm = 70.0
void_ratio = 1.086
initial_effective_stress_kPa = 100.0
[rig]
back_pressure_kPa = 300.0
[[stages]]
name = "drained shear"
role = "shear"
drainage = "open"
axial = "displacement"
axial_rate_mm_per_min = 0.2
end = [{{quantity = "time_min", above = {minutes:.4f}}}]
"""


def rig_text(ports: list[int]) -> str:
    def channels(*rows) -> str:
        return "".join(f'[[instruments.channels]]\nquantity = "{quantity}"\nat = {json.dumps(at)}\nunit = "{unit}"\n'
                       f'calibration = {{gain = {gain}, date = "2026-03-17"}}\n' for quantity, at, unit, gain in rows)

    def instrument(name: str, port: int, personality: str, more: str = "") -> str:
        return f'[[instruments]]\nname = "{name}"\nlink = "tcp://127.0.0.1:{port}"\npersonality = "{personality}"\n{more}'

    return (f'[rig]\nname = "stopped"\n[plant]\nprogramme = "p.toml"\nwatchdog_s = {WATCHDOG_S}\ncontrol = "tcp://127.0.0.1:{ports[4]}"\n'
            + instrument("scanner", ports[0], "34970A")
            + channels(("axial_displacement", 101, "mm", 5.0), ("axial_force", 102, "N", 1000.0), ("cell_pressure", 103, "kPa", 200.0),
                       ("pore_pressure", 105, "kPa", 100.0))
            + instrument("frame", ports[1], "triax-frame", 'role = "frame"\n')
            + instrument("cell", ports[2], "triax-controller", 'role = "cell"\n') + channels(("cell_volume", "volume_mm3", "mm3", 1.0))
            + instrument("back", ports[3], "triax-controller", 'role = "back"\n')
            + channels(("back_pressure", "pressure_kPa", "kPa", 1.0), ("back_volume", "volume_mm3", "mm3", 1.0)))


def free_ports(count: int) -> list[int]:
    probes = [socket.socket() for _ in range(count)]
    for probe in probes:
        probe.bind(("127.0.0.1", 0))
    ports = [probe.getsockname()[1] for probe in probes]
    for probe in probes:
        probe.close()
    return ports


def ask(port: int, question: str) -> str:
    with socket.create_connection(("127.0.0.1", port), timeout=10) as line:
        line.sendall((question + "\n").encode())
        return line.makefile().readline().strip()


def planned_stops(chance: random.Random, hold_s: float) -> list[tuple[float, float]]:
    """(seconds until it, its length): `hold_s`, or as likely from 0.1 to 1 s as from 1 to 10 s; the first long one is the last."""
    stops = []
    for _ in range(chance.randint(1, 5)):
        length_s = hold_s or SHORTEST_S * (LONGEST_S / SHORTEST_S)**chance.random()
        stops.append((chance.uniform(0.6, 1.6), length_s))
        if length_s > SURELY_SHORT_S:
            break
    return stops


class Rig:
    """A served rig and one program that asks it, in a folder of their own; one of the two is stopped."""

    def __init__(self, trial: Trial, number: int, stops: list[tuple[float, float]]):
        self.trial, self.stops = trial, stops
        self.folder = trial.folder / f"rig-{number}"
        self.folder.mkdir()
        self.longest_s = max(length_s for _, length_s in stops)
        self.ports = free_ports(5)
        self.broken = ""
        lasts_s = sum(before_s + length_s for before_s, length_s in stops) + 4
        (self.folder / "p.toml").write_text(PROGRAMME.format(minutes=lasts_s / 60), encoding="utf-8")
        (self.folder / "rig.toml").write_text(rig_text(self.ports), encoding="utf-8")
        self.number = itertools.count()

    def start(self, *words: str) -> Running:
        return Running([self.trial.program, *words], self.folder, next(self.number))

    def must(self, holds, otherwise: str):
        self.trial.must(holds, f"{self.folder.name} ({', '.join(f'{length_s:.2f}' for _, length_s in self.stops)} s): {otherwise}")

    def wait_until(self, reached, seconds: float, what: str):
        end = time.monotonic() + seconds
        while not reached():
            self.must(time.monotonic() < end, f"{what}: not within {seconds:g} s")
            time.sleep(0.02)

    def listens(self) -> bool:
        try:
            return ask(self.ports[4], "CLOCk:MODE?").startswith("REAL")
        except OSError:
            return False

    def try_it(self):
        served = asking = None
        try:
            served = self.start("serve", "rig.toml")
            self.wait_until(self.listens, 30, "the rig is served")
            asking = self.ask_rig()
            self.stop(served if self.trial.part.startswith("serve") else asking, asking)
            self.finish(asking)
            self.check_drives()
            served.send(signal.SIGINT)
            self.must((done := served.wait()).status == 0, f"triax serve ended by {name_of(done.status)}: {done.err[-300:]}")
        except Broken as error:
            self.broken = str(error)
        except Exception as error:  # noqa: BLE001 of the trial itself: as much a reason to look
            self.broken = f"{self.folder.name}: {error!r}"
        finally:
            for one in (asking, served):
                if one and one.poll() is None:
                    one.send(signal.SIGCONT)
                    one.send(signal.SIGKILL)
                    one.wait()

    def stop(self, stopped: Running, asking: Running):
        for before_s, length_s in self.stops:
            time.sleep(before_s)
            ended = asking.poll()
            self.must(not ended, ended and f"triax {asking.command[1]} ended early by {name_of(ended.status)}: {ended.err[-400:]}")
            stopped.send(signal.SIGSTOP)
            time.sleep(length_s)
            stopped.send(signal.SIGCONT)
            self.trial.count(f"stops of {'up to 1' if length_s <= 1 else 'up to 3' if length_s <= 3 else 'more than 3'} s")

    def check_drives(self):
        """They stand and hold once their controller is gone, by their watchdogs at the latest."""
        def told() -> list[str]:
            return [ask(port, question) for port, question in
                    zip(self.ports[1:4], (":MEAS:DISP?;:STAT:FRAM?", ":SOUR:PRES:NOW?", ":SOUR:PRES:NOW?"))]

        def stand() -> bool:
            before = told()
            time.sleep(0.3)
            return told() == before
        self.wait_until(stand, WATCHDOG_S + 3, "the drives stand")

    def check_gaps(self, times: list[float], sentences: list[str]):
        """Where two readings are further apart than the interval, a sentence has the instants between."""
        missed = []
        for text in sentences:
            if found := re.search(r"readings are missed from (\S+) s to (\S+) s:", text):
                missed.append([float(found[1]), float(found[2])])
            elif found := re.search(r"readings are missed repeatedly from (\S+) s on", text):
                missed.append([float(found[1]), math.inf])
            elif (found := re.search(r"readings are on time again from (\S+) s on", text)) and missed:
                missed[-1][1] = float(found[1])
        for before, after in itertools.pairwise(times):
            self.must(after > before, f"time runs back: {before} s, {after} s")
            # Instants that pass while answers are awaited are skipped, the next one counts as missed.
            told = any(begin <= before + 1.5 * INTERVAL_S + DEADLINE_S and end >= after - 1.5 * INTERVAL_S for begin, end in missed)
            self.must(after - before < 2.2 * INTERVAL_S or told, f"no reading from {before} s to {after} s, and no word of it: {missed}")

    def check_values(self, cells: list[list], cell_pressures: list, sentences: list[str]):
        """The cell pressure is constant, and a missing cell has a cause."""
        for value in cell_pressures:
            self.must(value is None or abs(value - CELL_KPA) < 1, f"the cell pressure was never {value} kPa")
        missing = sum(value is None for row in cells for value in row)
        self.must(not missing or any("gives no readings" in text for text in sentences), f"{missing} cells are missing without a word")
        if self.longest_s >= 1:
            self.must(any("readings are missed" in t or "gives no readings" in t for t in sentences),
                      f"a stop of {self.longest_s:.2f} s left no word")


class RunRig(Rig):
    COLUMNS = ("time_s, axial_displacement_mm, axial_force_kN, cell_pressure_kPa, back_pressure_kPa, pore_pressure_kPa, back_volume_mm3, "
               "cell_volume_mm3")

    def rows(self, query: str) -> list[tuple]:
        try:
            reader = sqlite3.connect(f"file:{self.folder / 't.db'}?mode=ro", uri=True, isolation_level=None, timeout=5)
        except sqlite3.Error:
            return []
        try:
            return reader.execute(query).fetchall()
        except sqlite3.Error:
            return []
        finally:
            reader.close()

    def scans(self) -> list[tuple]:
        return self.rows(f"SELECT {self.COLUMNS} FROM scans ORDER BY id")

    def ask_rig(self) -> Running:
        running = self.start("run", "p.toml", "--rig", "rig.toml", "--db", "t.db")
        self.wait_until(lambda: self.scans() or running.poll(), 40, "readings come")
        return running

    def stop(self, stopped: Running, asking: Running):
        super().stop(stopped, asking)
        self.seen = self.scans()

    def finish(self, asking: Running):
        done = asking.wait(120)
        self.must(done.status in (0, 3), f"triax run ended by {name_of(done.status)}: {done.err[-400:]}")
        self.must((done.status == 3) == ("safe state" in done.err), f"status {done.status}: {done.err[-400:]}")
        self.check_test(done.status == 3)

    def check_test(self, is_safe: bool):
        self.must(is_safe or self.longest_s < SURELY_LONG_S, "the test went on after a long stop")
        self.must(not is_safe or self.longest_s > SURELY_SHORT_S, "the test ended in the safe state")
        self.trial.count("tests in the safe state" if is_safe else "tests complete")
        check_whole(self.folder / "t.db")
        scans = self.scans()
        self.must(scans[:len(self.seen)] == self.seen, f"{len(self.seen)} readings were committed, now they differ")
        self.must(self.rows("SELECT status FROM tests") == [("complete",)], f"the test is {self.rows('SELECT status FROM tests')}")
        events = [row[0] or "" for row in self.rows("SELECT detail FROM events ORDER BY id")]
        self.check_gaps([row[0] for row in scans], events)
        self.check_values([list(row[1:]) for row in scans], [row[3] for row in scans], events)


class PageRig(RunRig):
    def request(self, method: str, path: str, body: str | None = None) -> http.client.HTTPResponse:
        connection = http.client.HTTPConnection(self.address.netloc, timeout=60)
        connection.request(method, path, body, {"Origin": f"http://{self.address.netloc}", "X-Triax": "1", "Content-Type": "application/json",
                                                "Cookie": self.cookie})
        return connection.getresponse()

    def ask_rig(self) -> Running:
        running, self.cookie = self.start("open", "rig.toml", "--db", "t.db"), ""
        self.wait_until(lambda: running.out.read_text().endswith("\n") or running.poll(), 30, "the page is there")
        self.address = urllib.parse.urlsplit(running.out.read_text().strip())
        self.cookie = self.request("GET", f"/?{self.address.query}").headers["Set-Cookie"].split(";")[0]
        wanted = json.dumps({"programme": (self.folder / "p.toml").read_text(encoding="utf-8"), "rig": True})
        answer = self.request("POST", "/api/runs", wanted)
        self.must(answer.status == 200, f"the page runs no test: {answer.read().decode()}")
        self.wait_until(lambda: self.scans() or running.poll(), 40, "readings come")
        return running

    def finish(self, asking: Running):
        self.wait_until(lambda: self.rows("SELECT status FROM tests") == [("complete",)] or asking.poll(), 120, "the test is complete")
        asking.send(signal.SIGINT)
        done = asking.wait()
        self.must(done.status == 0, f"triax open ended by {name_of(done.status)}: {done.err[-400:]}")
        self.check_test(bool(self.rows("SELECT 1 FROM events WHERE kind = 'safe_state'")))


class RecordRig(Rig):
    RECORD = "r.csv"

    def lines(self) -> list[list[str]]:
        text = (self.folder / self.RECORD).read_text(encoding="utf-8") if (self.folder / self.RECORD).exists() else ""
        return [line.split(",") for line in text.splitlines() if not line.startswith("#")]

    def ask_rig(self) -> Running:
        running = self.start("record", "rig.toml", "--record", self.RECORD, "--interval", str(INTERVAL_S))
        self.wait_until(lambda: len(self.lines()) > 3 or running.poll(), 40, "rows come")
        return running

    def stop(self, stopped: Running, asking: Running):
        super().stop(stopped, asking)
        self.seen = self.lines()
        # A lost link is taken up again within 8 s.
        rows = len(self.seen) + 2
        self.wait_until(lambda: len(lines := self.lines()) > rows and all(lines[-1]), 30, "all instruments answer again")

    def finish(self, asking: Running):
        asking.send(signal.SIGINT)
        done = asking.wait()
        self.must(done.status == 0, f"triax record ended by {name_of(done.status)}: {done.err[-400:]}")
        self.trial.count("records complete")
        head, *rows = self.lines()
        self.must([head, *rows][:len(self.seen)] == self.seen, "rows that were in the file have changed")
        self.must(all(len(row) == len(head) for row in rows), "a row lacks columns")
        sentences = done.err.splitlines()
        self.check_gaps([float(row[0]) for row in rows], sentences)
        at = head.index("cell_pressure_kPa")
        self.check_values([[cell or None for cell in row] for row in rows], [float(row[at]) if row[at] else None for row in rows], sentences)


def trial(t: Trial):
    t.choose(PARTS)
    kind = {"run": RunRig, "open": PageRig, "record": RecordRig}[t.part.split()[-1]]
    rigs = [kind(t, number, planned_stops(t.chance, t.hold_s)) for number in range(RIGS)]
    t.told.append(f"{t.part}, {RIGS} rigs")
    threads = [threading.Thread(target=rig.try_it) for rig in rigs]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    broken = [rig.broken for rig in rigs if rig.broken]
    t.must(not broken, "\n  ".join(broken))
