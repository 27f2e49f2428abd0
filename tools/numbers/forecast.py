# SPDX-License-Identifier: GPL-3.0-or-later
"""The warnings for recorded tests, on docs/explanation/forecast.md (tools/pages).

The records are not ours to copy: TRIAX_RECORDS_OF_OTHERS names their folder. Without it nobody can make the blocks anew, and a check asks
only that no hand changed them since.
"""
import json
import os
import pathlib
import subprocess
import sys

from remade.others import of_others

RECORDS = (
    ("kfs", ("TMU-MT1", "TMU-MT4", "TMU-AP1", "TMU-AP2", "TMU-MT2", "TMU-MT3", "TMU-MT6", "TMU1", "TMD1", "TMD3", "TMD8", "TMD24"), ".dat"),
    ("nerlerk", ("Nerlerk270_CIU_G101", "Nerlerk270_CIU_G103", "Nerlerk270_CIU_G107", "Nerlerk270_CID_G151"), ".csv"),
    ("cyclic", ("SJT-20", "SJT-34", "ZNF-03"), ".csv"),
)


def replayed(triax, record: pathlib.Path, *options: str) -> str:
    surroundings = {name: value for name, value in os.environ.items() if name != "COLUMNS"}
    done = subprocess.run([triax.program, "replay", str(record), "--live", "--db", "others.db", *options], cwd=triax.folder,
                          env=surroundings, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{record.name}: status {done.returncode}\n{done.stderr}")
    return done.stdout


def before(lead) -> str:
    if lead is None:
        return ""
    n = lead["readings"]
    return f"{n} before" if n > 0 else f"{-n} after" if n < 0 else "at it"


def stated(forecast: dict) -> str:
    probability = forecast["failure_probability"]
    return f"η {forecast['eta_forecast']:.2f}" if probability is None else f"failure within a cycle {probability:.0%}"


def said(told: dict, level: str) -> str:
    lead, outlook = told["live"]["before_onset"][level], told["collapse"]["warning"][level]
    if lead:
        return f"{before(lead)}, {stated(outlook)}"
    if outlook:
        return f"at reading {outlook['reading']}, {stated(outlook)}"
    times = sum(row["event"] is not None and row["event"]["kind"] == level for row in told["live"]["rows"])
    return "–" if times == 0 else f"{times} ×, taken back"


def known(collapse: dict) -> str:
    if not collapse["detected"]:
        return "–"
    detected_at = collapse["detected_at"]
    return f"{detected_at['reading'] - collapse['reading']} after" if detected_at else "when the record had ended"


def row(told: dict) -> str:
    c = told["collapse"]
    kind = "not judged" if c["kind"] is None else c["kind"].replace("_", " ")
    if c["kind"] == "none" and c["reading"] is not None:
        kind = "none (failure)"
    onset = "–" if c["reading"] is None or c["eta"] is None else f"{c['reading']}, η {c['eta']:.2f}"
    return (f"| {told['test']['name']} | {told['test']['readings']} | {kind} | {onset} | {said(told, 'approaching')} | {said(told, 'imminent')} "
            f"| {known(c)} |")


def plural(n: int) -> str:
    return "none" if n == 0 else "one" if n == 1 else str(n)


def counted(told: list[dict]) -> str:
    """How often it was in time."""
    fell = [t for t in told if t["collapse"]["detected"]]
    stood = [t for t in told if t["collapse"]["detected"] is False]
    leads = [t["live"]["before_onset"]["imminent"] for t in fell]
    ahead = sum(lead is not None and lead["readings"] > 0 for lead in leads)
    late = sum(lead is not None and lead["readings"] <= 0 for lead in leads)
    near = sum((t["live"]["before_onset"]["approaching"] or {"readings": 0})["readings"] > 0 for t in fell)
    false = sum(t["collapse"]["warning"]["imminent"] is not None for t in stood)
    false_near = sum(t["collapse"]["warning"]["approaching"] is not None for t in stood)
    return f"""\
Of {len(fell)} records with a collapse *imminent* was said before the onset, and left standing, in {plural(ahead)}; only after it in {plural(late)}; never, or taken
back, in {plural(len(fell) - ahead - late)}. *Approaching* stood before the onset in {plural(near)}. Of {len(stood)} without a collapse *imminent* stood to the end in \
{plural(false)}, *approaching* in {plural(false_near)}."""


def all_of_them(triax, folder: pathlib.Path) -> str:
    told = [json.loads(replayed(triax, folder / place / f"{name}{ending}", "--json")) for place, names, ending in RECORDS for name in names]
    lines = ["| record | readings | result | onset at reading | approaching | imminent | lost, known |", "|---|---|---|---|---|---|---|"]
    return "\n".join([*lines, *map(row, told), "", counted(told)])


def recorded(triax) -> str:
    return of_others(triax, "live", all_of_them)
