# SPDX-License-Identifier: GPL-3.0-or-later
"""The samples as a user runs them: `triax serve` and `triax run` in two processes, in lock step, against `triax simulate` with the same
seed. Every reading is the same to the printed digits (far below half a step of any converter), and so are verdict and onset reading.
ICU 6 by Modbus, CSU 26 by SCPI, ICU 6 by a serial pad over a pair of pseudo-terminals, whose counts are its converter's steps."""
import contextlib
import csv
import json
import os
import pathlib
import shutil
import subprocess
import tempfile

from judging import PROGRAMS, check, same, verdict, wait_until

TRIAX = str(pathlib.Path(os.environ.get("TRIAX", PROGRAMS.parent.parent / "triax")).resolve())
SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"
# Half of the last digit that is printed, in the unit of the column; of a pad half a count.
DIGITS = {"axial_displacement_mm": 1e-7, "axial_force_kN": 1e-8, "cell_pressure_kPa": 2e-6, "pore_pressure_kPa": 2e-6}
COUNTS = {"axial_displacement_mm": 3.6e-6, "axial_force_kN": 3.1e-7, "cell_pressure_kPa": 1.6e-4, "pore_pressure_kPa": 1.6e-4}


def told(*arguments: str) -> dict:
    done = subprocess.run([TRIAX, *arguments, "--json"], capture_output=True, text=True, timeout=110)
    check(f"{arguments[0]} ends well", done.returncode == 0, done.stderr)
    document = json.loads(done.stdout)
    return document[0] if isinstance(document, list) else document.get("tests", [document])[0]


def rows_of(path: pathlib.Path) -> list[dict]:
    with open(path) as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


@contextlib.contextmanager
def served(rig: pathlib.Path):
    with subprocess.Popen([TRIAX, "serve", str(rig), "--lock-step"], stdout=subprocess.PIPE, text=True) as server:
        try:
            wait_until(lambda: "control" in server.stdout.readline(), 10)
            yield
        finally:
            server.terminate()


def compare(programme: str, rig: str, folder: pathlib.Path, allowed: dict) -> None:
    file = str(SAMPLES / "programmes" / f"{programme}.toml")
    with served(SAMPLES / "rigs" / f"{rig}.toml"):
        wired = told("run", file, "--rig", str(SAMPLES / "rigs" / f"{rig}.toml"), "--db", str(folder / "w.db"),
                     "--record", str(folder / "wired.csv"))
    direct = told("simulate", file, "--db", str(folder / "s.db"), "--record", str(folder / "direct.csv"))
    same(f"{rig}: what is simulated says so", wired["test"]["origin"], "simulated")
    for key in ("detected", "kind", "reading"):
        same(f"{rig}: {key}", wired["collapse"][key], direct["collapse"][key])
    check(f"{rig}: there is an onset", wired["collapse"]["reading"] is not None)
    ours, theirs = rows_of(folder / "wired.csv"), rows_of(folder / "direct.csv")
    same(f"{rig}: readings", len(ours), len(theirs))
    for column in theirs[0]:
        worst = max(abs(float(a[column]) - float(b[column])) for a, b in zip(ours, theirs))
        check(f"{rig}: {column}", worst <= allowed.get(column, 1e-9), f"differs by up to {worst}")


with tempfile.TemporaryDirectory() as made:
    work = pathlib.Path(made)
    compare("icu_6", "icu_6", work, DIGITS)
    compare("csu_26", "csu_26", work, DIGITS)
    ends = [pathlib.Path("/tmp/triax-pad"), pathlib.Path("/tmp/triax-pad-instrument")]
    if shutil.which("socat"):
        with subprocess.Popen(["socat", *(f"PTY,link={end},rawer" for end in reversed(ends))]) as line:
            try:
                wait_until(lambda: all(end.exists() for end in ends), 5)
                compare("icu_6", "serial_pad", work, COUNTS)
            finally:
                line.terminate()
    else:
        print("not tried: socat is not installed (tools/packages-test.txt)")
verdict()
