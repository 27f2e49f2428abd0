# SPDX-License-Identifier: GPL-3.0-or-later
"""`triax run` on `triax serve`, one of them killed by SIGKILL at instants by strides. The run killed: the frame stops and the pressures
hold by their watchdogs, asked by a second client; what the database held stays. The server killed: the run ends, with its test stored
and status 3. The run interrupted (Ctrl-C): status 4.
A number behind the name: so many trials instead of 6; docs/explanation/reliability.md has 20."""
import os
import pathlib
import signal
import socket
import sqlite3
import subprocess
import sys
import tempfile
import threading
import time

from judging import PROGRAMS, check, verdict, wait_until

TRIAX = pathlib.Path(os.environ.get("TRIAX", PROGRAMS.parent.parent / "triax")).resolve()
WATCHDOG_S = 2.0
PROGRAMME = """[test]
name = "killed"
type = "ICU"
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
axial_rate_mm_per_min = 1.0
cell_rate_kPa_per_min = 60.0
back_rate_kPa_per_min = 20.0
time_limit_min = 60.0
end = [{quantity = "q_kPa", above = 5000.0}]
"""


def rig(ports: list[int]) -> str:
    def channel(quantity: str, at, unit: str, gain: float) -> str:
        at = f'"{at}"' if isinstance(at, str) else at
        return (f'[[instruments.channels]]\nquantity = "{quantity}"\nat = {at}\nunit = "{unit}"\n'
                f'calibration = {{gain = {gain}, date = "2026-03-17"}}\n')

    def instrument(name: str, port: int, personality: str, role: str = "") -> str:
        role = f'role = "{role}"\n' if role else ""
        return f'[[instruments]]\nname = "{name}"\nlink = "tcp://127.0.0.1:{port}"\npersonality = "{personality}"\n{role}'

    return (f'[rig]\nname = "killed"\n[plant]\nprogramme = "p.toml"\nwatchdog_s = {WATCHDOG_S}\ncontrol = "tcp://127.0.0.1:{ports[4]}"\n'
            + instrument("scanner", ports[0], "34970A") + channel("axial_displacement", 101, "mm", 5.0)
            + channel("axial_force", 102, "N", 1000.0) + channel("cell_pressure", 103, "kPa", 200.0)
            + channel("pore_pressure", 105, "kPa", 100.0) + instrument("frame", ports[1], "triax-frame", "frame")
            + instrument("cell", ports[2], "triax-controller", "cell") + channel("cell_volume", "volume_mm3", "mm3", 1.0)
            + instrument("back", ports[3], "triax-controller", "back") + channel("back_pressure", "pressure_kPa", "kPa", 1.0)
            + channel("back_volume", "volume_mm3", "mm3", 1.0))


def ask(port: int, question: str) -> list[float]:
    with socket.create_connection(("127.0.0.1", port), timeout=5) as line:
        line.sendall((question + "\n").encode())
        return [float(word) for word in line.makefile().readline().split(";")]


def rows(database: pathlib.Path, query: str) -> list[tuple]:
    try:
        with sqlite3.connect(f"file:{database}?mode=ro", uri=True, timeout=5) as reader:
            return reader.execute(query).fetchall()
    except sqlite3.Error:
        return []


SCANS = "SELECT * FROM scans ORDER BY 1, 2"


class Trial:
    """One served rig and one run on it, in a folder of their own."""

    def __init__(self, number: int, folder: str):
        self.name = f"trial {number}"
        self.kill_after_s = 1.5 + number * 0.37 % 3
        self.folder = pathlib.Path(folder)
        self.database = self.folder / "t.db"
        self.ports = [6000 + os.getpid() % 50 * 200 + number * 5 + i for i in range(5)]
        (self.folder / "p.toml").write_text(PROGRAMME)
        (self.folder / "rig.toml").write_text(rig(self.ports))
        self.log = open(self.folder / "log", "w+")

    def start(self, *words: str) -> subprocess.Popen:
        return subprocess.Popen([TRIAX, *words], cwd=self.folder, stdout=self.log, stderr=self.log, stdin=subprocess.DEVNULL)

    def right(self, what: str, good: bool, found="") -> None:
        check(f"{self.name}: {what}", good, found)

    def begin(self) -> None:
        self.served = self.start("serve", "rig.toml")
        self.run = None
        try:
            wait_until(lambda: self.listens(), 20)
            self.run = self.start("run", "p.toml", "--rig", "rig.toml", "--db", "t.db")
            self.right("readings come", wait_until(lambda: len(rows(self.database, SCANS)) > 2, 30), (self.folder / "log").read_text()[-600:])
            time.sleep(self.kill_after_s)
            self.kill()
        finally:
            for one in (self.run, self.served):
                if one and one.poll() is None:
                    one.kill()
                if one:
                    one.wait()

    def drives(self, after_s=0.0) -> list[list[float]]:
        """What frame, cell and back say of themselves."""
        time.sleep(after_s)
        questions = (":STAT:FRAM?;:MEAS:DISP?", ":SOUR:PRES:NOW?", ":SOUR:PRES:NOW?")
        return [ask(port, question) for port, question in zip(self.ports[1:], questions)]

    def listens(self) -> bool:
        try:
            socket.create_connection(("127.0.0.1", self.ports[4]), timeout=1).close()
            return True
        except OSError:
            return False


class RunKilled(Trial):
    def kill(self) -> None:
        before = rows(self.database, SCANS)
        self.run.send_signal(signal.SIGKILL)
        self.run.wait()
        time.sleep(WATCHDOG_S + 1)
        frame, cell, back = zip(self.drives(), self.drives(after_s=0.5))
        self.right("the frame stopped by its watchdog", frame[0][0] == 4 and frame[0] == frame[1], frame)
        self.right("the cell pressure holds", cell[0] == cell[1], cell)
        self.right("the back pressure holds", back[0] == back[1], back)
        self.right("every reading is kept", before and rows(self.database, SCANS)[:len(before)] == before, len(before))


class ServerKilled(Trial):
    def kill(self) -> None:
        before = rows(self.database, SCANS)
        self.served.send_signal(signal.SIGKILL)
        killed = time.monotonic()
        self.right("the run ends", wait_until(lambda: self.run.poll() is not None, 60), "")
        said = (self.folder / "log").read_text()
        self.right("by its safe state", "safe state" in said, said[-600:])
        self.right("its status says so", self.run.poll() == 3, self.run.poll())
        self.right("every reading is kept", before and rows(self.database, SCANS)[:len(before)] == before, len(before))
        done = rows(self.database, "SELECT * FROM tests")
        self.right("the test is stored", len(done) == 1, done)
        self.right("soon", time.monotonic() - killed < 30, time.monotonic() - killed)


class RunInterrupted(Trial):
    def kill(self) -> None:
        before = rows(self.database, SCANS)
        self.run.send_signal(signal.SIGINT)
        self.right("the run ends", wait_until(lambda: self.run.poll() is not None, 60), "")
        self.right("its status says that the operator ended it", self.run.poll() == 4, self.run.poll())
        self.right("every reading is kept", before and rows(self.database, SCANS)[:len(before)] == before, len(before))


def one_trial(number: int) -> None:
    with tempfile.TemporaryDirectory() as folder:
        try:
            (RunKilled, ServerKilled, RunInterrupted)[number % 3](number, folder).begin()
        except Exception as error:  # what breaks is a failure of its trial, the others go on
            check(f"trial {number}", False, repr(error))


trials = int(sys.argv[1]) if len(sys.argv) > 1 else 6
threads = [threading.Thread(target=one_trial, args=(number,)) for number in range(trials)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
print(f"{trials} trials")
verdict()
