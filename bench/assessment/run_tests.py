#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""run_tests.py FOLDER --triax PROGRAM [--seed N] [--jobs N] [--forms] [--out RESULTS.csv] [--times TIMES.csv]

Simulates each programme of FOLDER (written by make_programmes.py), replays what export_forms.py makes of it, and writes one line for each
test and form with the whole result of the assessment, the truth of the simulated specimen, and what the alarm reported. RESULTS.csv depends
on the program and the programmes only; TIMES.csv has the seconds of each run. Columns of RESULTS.csv:
  outcome     ok, refused (with the message in `reason`), failed, time limit
  truth_*     of the simulation: loss, its reading in this form, stress ratio. lost is 1, 0, or empty: the record ends at the loss
  truth_q_lost    share of q that was lost after that and before it came back, 1 if the cap fell
  truth_slip  1 if the loss is within a runaway that found a new equilibrium
  least_p     smallest p' of shear, as a share of that at its start
  ideal_*     of the same programme on ideal instruments, if a servo or masses held a force; empty otherwise or if that run failed
  fall_reading    at which the cap ran away and found no new equilibrium
  verdict     collapse, none or indeterminate; then kind, onset, interval, notice, `reason` if indeterminate
  approaching, imminent, lost    first reading at which the level was reported; standing: the last level of the alarm
  left_50 ... left_5    whether the 90 % interval of the forecast contained the true stress ratio at the first forecast with at most that
              share of the way in the stress ratio left: 1, 0, or - without a forecast
"""
import argparse
import concurrent.futures
import contextlib
import csv
import json
import pathlib
import resource
import sqlite3
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from export_forms import StoredTest, forms  # noqa: E402

TIME_LIMIT_S = 60
LEFT = (50, 25, 10, 5)
LEVELS = ("approaching", "imminent", "lost")
COLUMNS = ["number", "form", "outcome", "readings", "status", "b_value", "truth_lost", "truth_reading", "truth_eta", "truth_q_lost",
           "truth_slip", "least_p", "ideal_lost", "ideal_eta",
           "fall_reading", "limit_eta", "verdict", "kind", "inside", "reading", "eta", "eta_low", "eta_high", "strength_lost", "detected_at_reading",
           *LEVELS, "standing", "withdrawn", *[f"left_{n}" for n in LEFT], "reason"]
FORCE = {"load", "constant_q"}
RETURNED = 1.05  # of the strength at the onset


def text(value):
    if value is None:
        return ""
    if isinstance(value, bool):
        return str(int(value))
    return f"{value:.6g}" if isinstance(value, float) else str(value)


class Runner:
    def __init__(self, options, work):
        self.options, self.work = options, work

    def run(self, database, *arguments):
        """(document or None, outcome, message) of a command."""
        command = [str(self.options.triax), *map(str, arguments), "--db", str(database), "--json"]
        try:
            done = subprocess.run(command, capture_output=True, timeout=TIME_LIMIT_S, check=False, cwd=self.work)
        except subprocess.TimeoutExpired:
            return None, "time limit", f"no result within {TIME_LIMIT_S} s"
        message = done.stderr.decode("utf-8", "replace").strip().replace(str(self.work), "").split("\n")[-1]
        if done.returncode < 0 or done.returncode > 2:
            return None, "failed", f"exit status {done.returncode}"
        try:
            document = json.loads(done.stdout)
        except ValueError:
            return None, "refused", message
        return document[0] if isinstance(document, list) else document, "ok", ""

    def test(self, programme):
        """Lines of one programme, and (programme, seconds, seconds of all its runs)."""
        number = int(programme.stem.split("_")[1])
        begun = time.monotonic()
        database = self.work / f"{programme.stem}.db"
        document, outcome, message = self.run(database, "simulate", programme)
        simulated = time.monotonic() - begun
        lines = []
        if document is None:
            lines.append({"number": number, "form": "simulated", "outcome": outcome, "reason": message})
        else:
            truth = self.truth(document, database, programme)
            lines.append(result(document, number, "simulated", truth, database) | {"outcome": outcome})
            if self.options.forms:
                lines += self.forms(database, number, truth)
        remove(database)
        return lines, (programme.stem, simulated, time.monotonic() - begun)

    def truth(self, document, database, programme):
        truth = document["collapse"]["truth"] or {}
        out = {"lost": bool(truth.get("lost_sustainability")), "eta": truth.get("eta"),
               "q_kPa": truth.get("q_kPa"), "time_s": truth.get("time_s"), "fall_s": None,
               "limit": document["collapse"]["limit_stress_ratio"], "ideal_lost": None, "ideal_eta": None}
        away = truth.get("run_aways", [])
        out["slip"] = out["lost"] and any(r["ending"] == "new equilibrium" and r["start_s"] - 1 <= out["time_s"] <= r["end_s"] for r in away)
        falls = [r["start_s"] for r in away if r["ending"] != "new equilibrium"]
        out["fall_s"] = min(falls, default=None)
        with sqlite3.connect(f"file:{database}?mode=ro", uri=True) as db:
            out["times"] = [t for (t,) in db.execute("SELECT time_s FROM scans ORDER BY id")]
            out |= consequences(db, out)
            controls = {c for (c,) in db.execute("SELECT control FROM stages WHERE role = 'shear'")}
        if controls & FORCE:
            ideal = programme.with_suffix(".ideal.toml")
            other = self.work / f"{programme.stem}.ideal.db"
            found, _, _ = self.run(other, "simulate", ideal)
            remove(other)
            if found:
                truth = found["collapse"]["truth"] or {}
                out |= {"ideal_lost": bool(truth.get("lost_sustainability")), "ideal_eta": truth.get("eta")}
        return out

    def forms(self, database, number, truth):
        lines = []
        for form, content, readings in forms(StoredTest(database), f"{self.options.seed}/{number}"):
            record = self.work / f"{database.stem}.{form.replace(' ', '_')}.csv"
            record.write_text(content, encoding="utf-8")
            stored = record.with_suffix(".db")
            document, outcome, message = self.run(stored, "replay", record)
            if document is None:
                lines.append({"number": number, "form": form, "outcome": outcome, "reason": message})
            else:
                lines.append(result(document, number, form, truth, stored, readings) | {"outcome": outcome})
            if not self.options.keep:
                record.unlink()
            remove(stored)
        return lines


def consequences(db, truth):
    """What the readings of the simulated test show of the loss."""
    rows = db.execute("SELECT s.time_s, s.q_kPa, s.p_eff_kPa FROM states s JOIN stages t ON t.test_id = s.test_id AND t.number = s.stage "
                      "WHERE t.role = 'shear' AND s.q_kPa IS NOT NULL ORDER BY s.reading").fetchall()
    if not rows:
        return {"q_lost": None, "least_p": None}
    out = {"q_lost": None, "least_p": min(p for _, _, p in rows) / rows[0][2] if rows[0][2] else None}
    if truth["lost"] and truth["q_kPa"]:
        strength, least = abs(truth["q_kPa"]), abs(truth["q_kPa"])
        for q in (abs(q) for t, q, _ in rows if t >= truth["time_s"]):
            if q > RETURNED * strength:
                break
            least = min(least, q)
        out["q_lost"] = 1 - least / strength
    return out


def remove(database):
    for ending in ("", "-wal", "-shm"):
        pathlib.Path(f"{database}{ending}").unlink(missing_ok=True)


def first_at(times, readings, instant):
    """Row of this form at or after an instant; None if the record ends before."""
    if instant is None:
        return None
    return next((row for row, reading in enumerate(readings) if times[reading] >= instant), None)


def verdict(collapse):
    if collapse["detected"]:
        return "collapse"
    return "none" if collapse["judged"]["complete"] else "indeterminate"


def coverage(database, truth, truth_row):
    """Of the forecasts before the true onset: whether the interval contained it, by what was left."""
    if truth_row is None or truth["eta"] is None:
        return {}
    with sqlite3.connect(f"file:{database}?mode=ro", uri=True) as db:
        points = db.execute("SELECT reading, eta, eta_low, eta_high FROM forecasts WHERE reading < ? AND eta IS NOT NULL ORDER BY reading",
                            (truth_row,)).fetchall()
    out = {}
    for share in LEFT:
        at = next((p for p in points if abs(truth["eta"] - p[1]) <= share / 100 * abs(truth["eta"])), None)
        out[f"left_{share}"] = "-" if at is None else int(at[2] <= truth["eta"] <= at[3])
    return out


def result(document, number, form, truth, database, readings=None):
    collapse = document["collapse"]
    readings = readings if readings is not None else range(len(truth["times"]))
    row = first_at(truth["times"], readings, truth["time_s"]) if truth["lost"] else None
    lost = truth["lost"] and row is not None
    events = [e for e in document["events"] if e["kind"] in LEVELS or e["kind"] == "warning_withdrawn"]
    levels = {level: next((e["detected_at_reading"] for e in events if e["kind"] == level), None) for level in LEVELS}
    out = {"number": number, "form": form, "readings": document["test"]["readings"], "status": document["test"]["status"],
           "b_value": (document["consolidation"] or {}).get("b_value"),
           "truth_lost": None if row is not None and row >= len(readings) - 1 else lost, "truth_reading": row, "truth_eta": truth["eta"],
           "truth_q_lost": 1.0 if truth["fall_s"] is not None else truth["q_lost"], "truth_slip": truth["slip"] or None,
           "least_p": truth["least_p"], "ideal_lost": truth["ideal_lost"], "ideal_eta": truth["ideal_eta"],
           "fall_reading": first_at(truth["times"], readings, truth["fall_s"]), "limit_eta": truth["limit"],
           "verdict": verdict(collapse), "kind": collapse["kind"], "inside": collapse["inside_limit_surface"], "reading": collapse["reading"],
           "eta": collapse["eta"], "eta_low": collapse["eta_low"], "eta_high": collapse["eta_high"],
           "strength_lost": collapse["strength_lost"], "detected_at_reading": (collapse["detected_at"] or {}).get("reading"), **levels,
           "standing": events[-1]["kind"] if events else "", "withdrawn": sum(e["kind"] == "warning_withdrawn" for e in events),
           "reason": collapse["judged"]["reason"]}
    return out | coverage(database, truth, row)


def opened(stack, path):
    """For lines that are there as soon as they are written."""
    return stack.enter_context(open(path, "w", newline="", encoding="utf-8", buffering=1))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path, metavar="FOLDER")
    parser.add_argument("--triax", type=pathlib.Path, required=True, metavar="PROGRAM")
    parser.add_argument("--seed", type=int, default=1, metavar="N", help="of the forms [1]")
    parser.add_argument("--jobs", type=int, default=2, metavar="N")
    parser.add_argument("--forms", action="store_true", help="also replay the forms of export_forms.py")
    parser.add_argument("--keep", type=pathlib.Path, metavar="FOLDER", help="keep the exported files there")
    parser.add_argument("--out", type=pathlib.Path, required=True, metavar="RESULTS.csv")
    parser.add_argument("--times", type=pathlib.Path, metavar="TIMES.csv")
    options = parser.parse_args()
    options.triax, options.folder = options.triax.resolve(), options.folder.resolve()
    programmes = sorted(p for p in options.folder.glob("*.toml") if p.suffixes == [".toml"])
    with tempfile.TemporaryDirectory() as name:
        work = options.keep.resolve() if options.keep else pathlib.Path(name)
        work.mkdir(parents=True, exist_ok=True)
        runner = Runner(options, work)
        with contextlib.ExitStack() as stack:
            results = csv.DictWriter(opened(stack, options.out), COLUMNS, lineterminator="\n")
            results.writeheader()
            times = csv.writer(opened(stack, options.times or work / "times.csv"), lineterminator="\n")
            times.writerow(("programme", "simulation_s", "all_s"))
            pool = stack.enter_context(concurrent.futures.ThreadPoolExecutor(options.jobs))
            for lines, (name, simulation, whole) in pool.map(runner.test, programmes):
                results.writerows({k: text(v) for k, v in line.items()} for line in lines)
                times.writerow((name, f"{simulation:.2f}", f"{whole:.2f}"))
    cpu = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(f"{len(programmes)} programmes, {cpu.ru_utime + cpu.ru_stime:.0f} s of processor time", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
