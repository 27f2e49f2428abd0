#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""bench/wire/real_time.py [SPEED]: four tests over the wire in real time, 60 times the clock unless told: `triax serve` and `triax run` in
two processes, all four at once, against `triax simulate` with the same seed. Asked: the same kind of collapse, and eta at its onset
within 0.01. Takes as long as the longest test, 7 minutes at 60; status 1 where it does not hold. TRIAX names another program."""
import json
import os
import pathlib
import re
import socket
import subprocess
import sys
import tempfile
import threading

ROOT = pathlib.Path(__file__).resolve().parents[2]
TRIAX = os.environ.get("TRIAX", str(ROOT / "build/release/triax"))
TESTS = ("csu_26", "csd_58", "icu_6", "icu_load")


def free_port(_) -> str:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return f":{probe.getsockname()[1]}"


def told(*arguments: str) -> dict:
    done = subprocess.run([TRIAX, *arguments, "--json"], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{arguments[0]} {arguments[1]}: {done.stderr}")
    document = json.loads(done.stdout)
    return document[0] if isinstance(document, list) else document.get("tests", [document])[0]


def one(name: str, speed: str, folder: pathlib.Path, results: dict) -> None:
    programme = ROOT / f"samples/programmes/{name}.toml"
    sample = "icu_6" if name == "icu_6" else "csu_26"  # by Modbus, by SCPI
    text = (ROOT / f"samples/rigs/{sample}.toml").read_text()
    text = re.sub(r'programme = "[^"]*"', f'programme = "{programme}"', text)
    rig = folder / f"{name}.toml"
    rig.write_text(re.sub(r":5[67]\d\d", free_port, text))
    with subprocess.Popen([TRIAX, "serve", str(rig), "--speed", speed], stdout=subprocess.PIPE, text=True) as server:
        try:
            while "control" not in server.stdout.readline():
                pass
            wired = told("run", str(programme), "--rig", str(rig), "--db", str(folder / f"{name}.db"))
        finally:
            server.terminate()
    direct = told("simulate", str(programme), "--db", str(folder / f"{name}_direct.db"))
    results[name] = (wired["collapse"], direct["collapse"])


speed = sys.argv[1] if len(sys.argv) > 1 else "60"
results: dict = {}
with tempfile.TemporaryDirectory() as made:
    threads = [threading.Thread(target=one, args=(name, speed, pathlib.Path(made), results)) for name in TESTS]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
print(f"test       {speed:>4} x the clock        simulated                      eta within 0.01")
held = True
for name in TESTS:
    if name not in results:
        held = False
        print(f"{name:<10} did not end")
        continue
    wired, direct = results[name]
    same = wired["kind"] == direct["kind"] and abs(wired["eta"] - direct["eta"]) <= 0.01
    held = held and same
    cells = [f"{c['kind']} at {c['reading']}, eta {c['eta']:.4f}" for c in (wired, direct)]
    print(f"{name:<10} {cells[0]:<28} {cells[1]:<30} {'yes' if same else 'NO'}")
sys.exit(0 if held else 1)
