# SPDX-License-Identifier: GPL-3.0-or-later
"""load.py PART TRIAX FOLDER [NUMBER...]: one figure of load of `triax open`, see run.sh."""
import hashlib
import os
import random
import sqlite3
import statistics
import struct
import sys
import threading
import time

from clients import Page, Stream, held, share

PART, TRIAX, FOLDER = sys.argv[1:4]
NUMBERS = [float(number) for number in sys.argv[4:]]


def number(place, usual):
    return NUMBERS[place] if len(NUMBERS) > place else usual


def start():
    times, memory = [], []
    for _ in range(int(number(0, 10))):
        with Page(TRIAX, os.path.join(FOLDER, "none.db")) as page:
            times.append(page.started_s)
            memory.append(page.kB / 1024)
    print(f"start, {len(times)} times: address after {statistics.median(times):.3f} s (at most {max(times):.3f}), memory {max(memory):.1f} MB")
    held({"address after less than 0.2 s": statistics.median(times) < 0.2, "less than 40 MB": max(memory) < 40})


def million():
    opened, zooms, resident = [], [], 0
    for _ in range(int(number(0, 5))):
        with Page(TRIAX, os.path.join(FOLDER, "million.db")) as page:
            begun = time.monotonic()
            page.get("/api/tests/1")
            page.get("/api/tests/1/window?pixels=1000&work=1")
            opened.append(time.monotonic() - begun)
            rng = random.Random(1)
            for _ in range(40):
                span = int(10 ** rng.uniform(3, 6))
                first = rng.randrange(0, 1_000_001 - span)
                begun = time.monotonic()
                page.get(f"/api/tests/1/window?pixels=1000&work=1&from={first}&to={first + span}")
                zooms.append(time.monotonic() - begun)
            resident = max(resident, page.memory("VmHWM") / 1024)
    print(f"10^6 readings: opened in {statistics.median(opened):.2f} s (from {min(opened):.2f} to {max(opened):.2f}); "
          f"{len(zooms)} zooms: median {1e3 * statistics.median(zooms):.0f} ms, 99 % {1e3 * share(zooms, 0.99):.0f} ms, at most {1e3 * max(zooms):.0f} ms; memory {resident:.0f} MB")
    held({"opened in less than 1 s": statistics.median(opened) < 1, "99 % of zooms in less than 100 ms": share(zooms, 0.99) < 0.1})


def latency():
    """From the session's telling of a reading to its event in a client."""
    seconds, clients = number(0, 60), int(number(1, 10))
    late = []
    with Page(TRIAX, os.path.join(FOLDER, "live.db")) as page:
        test = page.run(10)

        def listen():
            stream = Stream(page, test)
            begun = time.monotonic()
            for _, kind, data in stream.events():
                if kind == "reading" and time.monotonic() - begun > 1:
                    late.append(1e3 * time.time() - data["told_ms"])
                if time.monotonic() - begun > seconds:
                    break
            stream.close()

        threads = [threading.Thread(target=listen) for _ in range(clients)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        page.post(f"/api/runs/{test}/stop", {"who": "bench"})
    print(f"10 readings/s, {clients} clients, {seconds:.0f} s: reading to client median {statistics.median(late):.2f} ms, "
          f"99 % {share(late, 0.99):.2f} ms, at most {max(late):.1f} ms ({len(late)} readings)")


def memory():
    """Of the server, at 100 readings/s with ten clients, of which two read nothing after the first second."""
    minutes, warm_up_s = number(0, 5), number(1, 90)  # the ring is full after 82 s
    with Page(TRIAX, os.path.join(FOLDER, "memory.db")) as page:
        test = page.run(100)
        go = True
        counts = [0] * 10

        def listen(client):
            stream = Stream(page, test)
            begun = time.monotonic()
            for _, kind, _ in stream.events():
                counts[client] += kind == "reading"
                while go and client < 2 and time.monotonic() - begun > 1:
                    time.sleep(1)
                if not go:
                    break
            stream.close()

        threads = [threading.Thread(target=listen, args=[client]) for client in range(10)]
        for thread in threads:
            thread.start()
        time.sleep(warm_up_s)
        resident = []
        until = time.monotonic() + 60 * minutes
        while time.monotonic() < until:
            resident.append(page.memory() / 1024)
            time.sleep(2)
        go = False
        for thread in threads:
            thread.join()
        page.post(f"/api/runs/{test}/stop", {"who": "bench"})
        quarter = max(len(resident) // 4, 1)
        first, last = statistics.median(resident[:quarter]), statistics.median(resident[-quarter:])
        print(f"100 readings/s, 10 clients of which 2 stand still, {minutes:.0f} min after the ring is full: memory {first:.1f} MB in the first quarter, "
              f"{last:.1f} MB in the last ({100 * (last / first - 1):+.1f} %), {counts[9]} readings each")
        held({"memory of the server flat within 5 %": last < 1.05 * first})


def digest(rows):
    sums = hashlib.sha256()
    for row in rows:
        sums.update(struct.pack("<q" + "d" * (len(row) - 1), row[0], *[float("nan") if value is None else value for value in row[1:]]))
    return sums.hexdigest()


def disconnects():
    """A client that is cut off again and again goes on with Last-Event-ID; what it holds against the database."""
    breaks = int(number(0, 100))
    rng = random.Random(3)
    rows, doubles, missed = {}, 0, 0
    columns = ["time_s", "axial_strain", "volumetric_strain", "q_kPa", "p_eff_kPa", "pore_pressure_kPa", "axial_force_kN"]
    database = os.path.join(FOLDER, "breaks.db")
    with Page(TRIAX, database) as page:
        test = page.run(100)
        last, ended = None, False
        for break_ in range(breaks + 1):
            stream = Stream(page, test, last)
            if break_ == breaks:
                page.post(f"/api/runs/{test}/stop", {"who": "bench"})
            stay = rng.uniform(0.02, 0.6)
            begun = time.monotonic()
            for place, kind, data in stream.events():
                if kind == "reading":
                    doubles += data["reading"] in rows
                    rows[data["reading"]] = (data["reading"], *[data[name] for name in columns])
                missed += kind == "window"
                ended = ended or kind == "end"
                last = place or last
                if ended or (break_ < breaks and time.monotonic() - begun > stay):
                    break
            stream.close()
            if rng.random() < 0.3:
                time.sleep(rng.uniform(0, 0.5))
        time.sleep(0.5)
    stored = list(sqlite3.connect(database).execute(
        "SELECT id & 4294967295, time_s, axial_strain, volumetric_strain, q_Pa / 1000.0, p_eff_Pa / 1000.0, pore_pressure_kPa, axial_force_kN "
        "FROM scans WHERE id >> 32 = ? ORDER BY id", [test]))
    same = digest(rows[key] for key in sorted(rows)) == digest(stored)
    print(f"{breaks} disconnects: {len(rows)} readings held, {len(stored)} in the database, {doubles} came twice, {missed} windows missed; checksums {'equal' if same else 'DIFFER'}")
    held({"a client that is cut off holds what the database holds": same and not doubles and ended})


{"start": start, "million": million, "latency": latency, "memory": memory, "disconnects": disconnects}[PART]()
