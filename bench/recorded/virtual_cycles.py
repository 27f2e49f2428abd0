#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/recorded/virtual_cycles.py [--program FILE] [--keep FOLDER]
# Simulates undrained cyclic tests on sand that shakes down, shows cyclic mobility or fails, and
# prints each warning `imminent` that triax issued and withdrew. A warning that remains in a test
# without failure is an error. --keep keeps the programmes and the records in a folder.
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

HEAD = """# {title}
[test]
name = "{title}"
type = "CYC"
seed = {seed}
scan_interval_s = {interval}

[specimen]
material = "{material}"
height_mm = 140.0
diameter_mm = 70.0
void_ratio = {void_ratio}
specific_gravity = 2.65
initial_effective_stress_kPa = 20.0

[rig]
back_pressure_kPa = 300.0
water_bulk_modulus_GPa = 2.2
system_compliance_mm3_per_kPa = 0.2
drainage_resistance_kPa_s_per_mm3 = 0.1
instruments = "standard"

[rig.frame]
travel_mm = 24.0

[[stages]]
name = "consolidation"
role = "consolidation"
drainage = "open"
axial = "free"
cell_rate_kPa_per_min = 10.0
cell_target_kPa = 450.0
end = [{{quantity = "cell_pressure_kPa", above = 450.0}}]

[[stages]]
name = "rest until drainage has died away"
role = "consolidation"
drainage = "open"
axial = "free"
end = [{{quantity = "volume_rate_mm3_per_min", below = 20.0}}]
time_limit_min = 240.0
"""
HALF = """
[[stages]]
name = "{name}"
role = "shear"
drainage = "closed"
axial = "load"
load_rate_N_per_min = {rate}
end = [{{quantity = "{quantity}", {side} = {value}}}, {{quantity = "axial_strain_pct", above = 12.0}}, \
{{quantity = "axial_strain_pct", below = -12.0}}]
time_limit_min = 60.0
"""
REST = """
[[stages]]
name = "rest"
role = "shear"
drainage = "closed"
axial = "dead_load"
end = [{{quantity = "time_min", above = {minutes}}}]
"""
RATE = 40.0  # N/min; 3.85 N are 1 kPa

# Blocks of (middle of q, amplitude of q, cycles), in kPa; None: a rest of two cycles. The third
# value of a test is the number of readings in a cycle of the first block, the last one whether the
# specimen fails.
SAND = "sanisand/S28-general"
TESTS = {
    "dense, two-way, small": (SAND, 0.75, 80, [(0, 12, 20)], False),
    "dense, one-way, small": (SAND, 0.75, 80, [(20, 10, 20)], False),
    "dense, cyclic mobility": (SAND, 0.75, 80, [(0, 45, 12)], False),
    "dense, biased mobility": (SAND, 0.75, 80, [(25, 50, 12)], False),
    "dense, amplitude times 1.2": (SAND, 0.75, 80, [(0, 20, 6), (0, 24, 6)], False),
    "dense, amplitude times 1.5": (SAND, 0.75, 80, [(0, 20, 6), (0, 30, 6)], False),
    "dense, rest of two cycles": (SAND, 0.75, 80, [(0, 20, 6), None, (0, 20, 6)], False),
    "dense, 20 readings a cycle": (SAND, 0.75, 20, [(0, 20, 12)], False),
    "dense, 300 readings a cycle": (SAND, 0.75, 300, [(0, 20, 8)], False),
    "medium, small": (SAND, 0.9, 80, [(0, 8, 15)], False),
    "medium, mobility": (SAND, 0.85, 80, [(0, 25, 15)], False),
    "loose, small": (SAND, 1.0, 80, [(0, 5, 15)], False),
    "loose, two-way, fails": (SAND, 1.05, 80, [(0, 12, 40)], True),
    "loose, biased, fails": (SAND, 1.05, 80, [(20, 12, 40)], True),
}


def programme(title, seed, material, void_ratio, readings, blocks):
    cycle_min = 4 * blocks[0][1] * 3.85 / RATE
    text = HEAD.format(
        title=title, seed=seed, interval=round(60 * cycle_min / readings, 2), material=material,
        void_ratio=void_ratio,
    )
    half = 0
    for block in blocks:
        if block is None:
            text += REST.format(minutes=2 * cycle_min)
            continue
        middle, amplitude, cycles = block
        for _ in range(cycles):
            for direction, side in ((1, "above"), (-1, "below")):
                half += 1
                text += HALF.format(
                    name=f"half cycle {half}", rate=direction * RATE, quantity="q_kPa", side=side,
                    value=middle + direction * amplitude,
                )
    return text


def run(triax, folder, title, test, seed):
    material, void_ratio, readings, blocks, fails = test
    stem = title.replace(",", "").replace(" ", "_")
    path = pathlib.Path(folder, stem + ".toml")
    path.write_text(programme(title, seed, material, void_ratio, readings, blocks))
    done = subprocess.run(
        [triax, "simulate", str(path), "--format", "json", "--db", str(path.with_suffix(".sqlite"))],
        capture_output=True, text=True,
    )
    if done.returncode not in (0, 1) or not done.stdout.strip():
        return f"{title:30} failed: {done.stderr.strip().splitlines()[-1:]}", False
    report = json.loads(done.stdout)
    report = report[0] if isinstance(report, list) else report
    events = report.get("events", [])
    issued = sum(e["kind"] == "imminent" for e in events)
    withdrawn = sum(e["kind"] == "warning_withdrawn" for e in events)
    stands = bool(report["collapse"]["warning"]["imminent"])
    wrong = stands != fails or (not fails and issued > 1)
    cyclic = report.get("cyclic") or {}
    line = (
        f"{title:30} {report['collapse'].get('kind') or '-':14} cycles {cyclic.get('cycles', 0):5}  issued {issued}  "
        f"withdrawn {withdrawn}  remains {'yes' if stands else 'no':3}  {'WRONG' if wrong else ''}"
    )
    for event in events:
        if event["kind"] in ("imminent", "warning_withdrawn", "loss_of_sustainability", "approaching", "lost"):
            line += f"\n    {event['kind']} at reading {event['reading']}: {event['detail']}"
    return line, not wrong


def main():
    parser = argparse.ArgumentParser(description="Warnings in virtual cyclic tests")
    parser.add_argument("--program", default="build/release/triax")
    parser.add_argument("--keep")
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    right = True
    with tempfile.TemporaryDirectory() as folder:
        folder = options.keep or folder
        pathlib.Path(folder).mkdir(exist_ok=True)
        for seed, (title, test) in enumerate(TESTS.items(), 1):
            if options.only not in title:
                continue
            line, is_right = run(options.program, folder, title, test, seed)
            print(line, flush=True)
            right = right and is_right
    sys.exit(0 if right else 1)


if __name__ == "__main__":
    main()
