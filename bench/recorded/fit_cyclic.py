#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/recorded/fit_cyclic.py --records FOLDER [--labels FILE] [--program FILE] [--every N] [--noise]
# Fits the coefficients of lab/warning/cyclic_warning.cpp to recorded undrained cyclic tests with a
# known row of instability, and prints how well the model does, leaving out one test at a time.
#   python3 bench/recorded/fit_cyclic.py --records ../shared/data
# --every N uses every Nth row, and --noise adds noise of 0.2 kPa and 0.001 % (standard deviation).
# The score is F1 over windows that end at every tenth row from the end of the first cycle to the
# row of instability. A window is true if the instability is at most one cycle away.
import argparse
import math
import pathlib
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import records

ISSUE, WITHDRAW = 0.6, 0.1  # warning_limits::kIssue, kWithdraw


def probability(c, x):
    z = c[0] + sum(a * b for a, b in zip(c[1:], x))
    return 1 / (1 + math.exp(-max(-30.0, min(30.0, z))))


def solve(matrix, right):
    rows = [list(row) + [value] for row, value in zip(matrix, right)]
    n = len(rows)
    for i in range(n):
        best = max(range(i, n), key=lambda k: abs(rows[k][i]))
        rows[i], rows[best] = rows[best], rows[i]
        for k in range(i + 1, n):
            factor = rows[k][i] / rows[i][i]
            rows[k] = [a - factor * b for a, b in zip(rows[k], rows[i])]
    found = [0.0] * n
    for i in reversed(range(n)):
        found[i] = (rows[i][n] - sum(rows[i][k] * found[k] for k in range(i + 1, n))) / rows[i][i]
    return found


def fit(windows, start=None):
    """Logistic regression by Newton's method, with a slight ridge so that it converges."""
    c = list(start) if start else [0.0] * (len(windows[0][0]) + 1)
    for _ in range(60):
        hessian = [[1e-3 * (i == j) for j in range(len(c))] for i in range(len(c))]
        gradient = [-1e-3 * value for value in c]
        for numbers, is_true in windows:
            p, x = probability(c, numbers), [1.0, *numbers]
            for i, xi in enumerate(x):
                gradient[i] += (is_true - p) * xi
                for j, xj in enumerate(x):
                    hessian[i][j] += p * (1 - p) * xi * xj
        step = solve(hessian, gradient)
        scale = min(1.0, 5 / max(map(abs, step)))
        c = [a + scale * b for a, b in zip(c, step)]
        if max(map(abs, step)) < 1e-6:
            break
    return c


def numbers_of(tests, program):
    """For each test a list with the four numbers of each row, or None, and whether q has turned."""
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for test in tests:
            files.append(pathlib.Path(folder, test["name"]))
            files[-1].write_text("".join(f"{r.q} {r.p} {r.strain}\n" for r in test["rows"]))
        text = subprocess.run([program, *map(str, files)], check=True, capture_output=True, text=True).stdout
    found = []
    for block in text.split("\n\n")[: len(tests)]:
        fields = [line.split()[2:] for line in block.splitlines()]
        found.append([(None if f[1:] == ["-"] else [float(v) for v in f[1:]], f[0] == "1") for f in fields])
    return found


def levels(c, numbers):
    level, found = False, []
    for x, has_turned in numbers:
        if x is not None:
            p = probability(c, x)
            level = not (has_turned and p < WITHDRAW) if level else p >= ISSUE
        found.append(level)
    return found


def windows_of(test):
    cycle = test["rows_per_cycle"]
    return range(cycle - 1, test["onset"] + 1, max(1, cycle // 8))


def disturb(test, every, noise, generator):
    rows = test["rows"][::every]
    if noise:
        changed = []
        for r in rows:
            dq, du = generator.gauss(0, 0.2), generator.gauss(0, 0.2)
            changed.append(records.Row(r.q + dq, r.p + dq / 3 - du, r.strain + generator.gauss(0, 0.001)))
        rows = changed
    return dict(test, rows=rows, onset=test["onset"] // every, rows_per_cycle=test["rows_per_cycle"] // every)


def main():
    parser = argparse.ArgumentParser(description="Fit the cyclic warning to recorded tests")
    parser.add_argument("--records", required=True, type=pathlib.Path)
    parser.add_argument("--labels", type=pathlib.Path, default=pathlib.Path(__file__).with_name("labels.csv"))
    parser.add_argument("--program", default="build/release/bench/bench_print_cycles")
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--noise", action="store_true")
    options = parser.parse_args()
    tests = [t for t in records.read(options.records, options.labels)[0] if t["fit"]]
    clean = numbers_of(tests, options.program)

    def data(left_out=None):
        return [
            (numbers[e][0], int(test["onset"] - e <= test["rows_per_cycle"]))
            for test, numbers in zip(tests, clean)
            if test["name"] != left_out
            for e in windows_of(test)
            if numbers[e][0]
        ]

    whole = fit(data())
    print("all tests:", " ".join(f"{v:.4g}" for v in whole))
    generator = random.Random(1)
    changed = [disturb(t, options.every, options.noise, generator) for t in tests]
    numbers = numbers_of(changed, options.program) if options.every > 1 or options.noise else clean
    total = records.WarningScore()
    for test, of_test in zip(changed, numbers):
        c = fit(data(test["name"]), whole)
        score = records.WarningScore()
        score.add(test, levels(c, of_test))
        total.add(test, levels(c, of_test))
        print(f"{test['name']}  lead {score.leads[0]:5.2f} cycles  withdrawn {score.withdrawn}")
    print(f"  {total.text()}")


if __name__ == "__main__":
    main()
