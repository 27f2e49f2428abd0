#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""bench/wire/scans.py [MINUTES [SCANS]]: seven meters that answer after 3 to 25 ms. First SCANS scans of all seven at once beside those of
each alone; then `triax record` ten times a second for MINUTES (10 unless told) on two such rigs side by side, one with 1,000 clients at
its meters that say nothing: how late each reading was asked for, and what the logger's memory did. Status 1 where the bounds do not hold:
a scan of seven 1.2 times the slowest alone, 99 % of readings within 2 ms of their instant, memory within 2 %."""
import os
import pathlib
import socket
import subprocess
import sys
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
TRIAX = os.environ.get("TRIAX", str(ROOT / "build/release/triax"))
METERS = str(ROOT / "build/release/bench/bench_seven_meters")
INTERVAL_S = 0.1


class Rig:
    """Seven served meters and the file that names them."""

    def __init__(self, folder: pathlib.Path, name: str, idle: int):
        self.name = name
        self.server = subprocess.Popen([METERS], stdout=subprocess.PIPE, text=True)
        meters = [self.server.stdout.readline().split() for _ in range(7)]
        self.file = folder / f"{name}.toml"
        self.record = folder / f"{name}.csv"
        self.file.write_text(f'[rig]\nname = "{name}"\n' + "".join(
            f'[[instruments]]\nname = "meter of {delay} ms"\nlink = "tcp://127.0.0.1:{port}"\npersonality = "34401A"\n'
            f'[[instruments.channels]]\nquantity = "v{i}"\nunit = "V"\n'
            f'calibration = {{gain = 1.0, date = "2026-01-01", certificate = "bench"}}\n' for i, (port, delay) in enumerate(meters)))
        self.idle = [socket.create_connection(("127.0.0.1", int(meters[i % 7][0]))) for i in range(idle)]
        self.memory_kb: list = []

    def log(self, minutes: float) -> None:
        with subprocess.Popen([TRIAX, "record", str(self.file), "--record", str(self.record), "--interval", str(INTERVAL_S), "--for",
                               str(minutes)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as logger:
            while logger.poll() is None:
                time.sleep(1)
                try:
                    status = pathlib.Path(f"/proc/{logger.pid}/status").read_text()
                    self.memory_kb.append(int(status.split("VmRSS:")[1].split()[0]))
                except (FileNotFoundError, IndexError):
                    break
            if logger.wait():
                raise SystemExit(f"{self.name}: triax record ended with {logger.returncode}")

    def told(self, minutes: float) -> bool:
        rows = [line for line in self.record.read_text().splitlines() if line[0].isdigit()]
        late_ms = sorted((t - round(t / INTERVAL_S) * INTERVAL_S) * 1e3 for t in (float(row.split(",")[0]) for row in rows))
        missing = sum(cell == "" for row in rows for cell in row.split(","))
        due = round(minutes * 60 / INTERVAL_S) + 1
        within = sum(abs(t) <= 2 for t in late_ms) / due
        grown = max(self.memory_kb[-len(self.memory_kb) // 4:]) / max(self.memory_kb[2:len(self.memory_kb) // 4 + 3])
        print(f"{self.name:<20} {len(rows):>6} of {due}   {missing:>7} {late_ms[len(rows) // 2]:>8.2f} {late_ms[int(0.99 * len(rows))]:>8.2f} "
              f"{late_ms[-1]:>8.2f}   {100 * within:>6.2f} %   {max(self.memory_kb) / 1024:>6.1f} {100 * (grown - 1):>+7.1f} %")
        return within >= 0.99 and grown <= 1.02

    def close(self) -> None:
        self.server.terminate()
        self.server.wait()


def scans(rig: Rig, count: int) -> bool:
    said = subprocess.run([METERS, "--time", str(rig.file), str(count)], capture_output=True, text=True, check=True).stdout
    taken = {line.rsplit(" ", 1)[0]: float(line.rsplit(" ", 1)[1]) for line in said.splitlines()}
    together = taken.pop("all")
    slowest = max(taken, key=taken.get)
    print(f"a scan of all seven {together:.2f} ms, of the {slowest} alone {taken[slowest]:.2f} ms: {together / taken[slowest]:.2f}; one after "
          f"another {sum(taken.values()):.2f} ms   (medians of {count}; with {len(rig.idle)} idle clients)")
    return together <= 1.2 * taken[slowest]


minutes = float(sys.argv[1]) if len(sys.argv) > 1 else 10
count = int(sys.argv[2]) if len(sys.argv) > 2 else 400
with tempfile.TemporaryDirectory() as made:
    rigs = [Rig(pathlib.Path(made), "alone", 0), Rig(pathlib.Path(made), "1,000 idle clients", 1000)]
    try:
        held = all([scans(rig, count) for rig in rigs])
        threads = [threading.Thread(target=rig.log, args=(minutes,)) for rig in rigs]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        print(f"{'ten a second':<20} {'readings':>14}   missing   late by, ms: median     99 %      most   within 2 ms   MB    grown")
        held = all([rig.told(minutes) for rig in rigs]) and held
    finally:
        for rig in rigs:
            rig.close()
sys.exit(0 if held else 1)
