#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""tables.py RESULTS.csv INDEX.csv [--heading TEXT] [--times TIMES.csv] [--misses]

Prints what run_tests.py measured, by form, control, law, B, p'0 and quality of the instruments. Columns:
  tests      results that were assessed
  missed     the specimen was lost inside its limit surface within the record, and the result is "none"
  false      the result is a collapse, and the specimen was not lost (cyclic mobility is not counted)
  indet.     indeterminate
  covered    the 95 % interval of the onset contains the true stress ratio, with the exact 95 % bounds of the share (Clopper, Pearson 1934)
  error      median and 90 % of the absolute error of the stress ratio
  imminent   `imminent` was reported before the reading of the fall, of the tests that fell
  alarms     `imminent` was reported, and the specimen was not lost
  stands     the result is "none", and `imminent` stands at the last reading
Neither lost nor not lost (one of UNCOUNTED): a loss at the limit surface, one of less than 10 % of q, a slip to a new equilibrium, a record
that ends at the loss, a test without a loss in which p' fell below 5 % of its start, and a test in which a servo or masses held a force and
the programme on ideal instruments has another outcome, or a stress ratio that differs by more than 0.05.
"""
import argparse
import csv
import pathlib
import statistics
import sys

AT_LIMIT = 0.95           # of the limit surface
MAX_SERVO_ERROR = 0.05    # of the stress ratio
WORTH_A_LOSS = 0.10       # of q
LIQUEFIED = 0.05          # of p'
UNCOUNTED = ("at the limit", "small loss", "slip", "ends at the loss", "liquefied", "servo")
LEFT = ("left_50", "left_25", "left_10", "left_5")


def cumulated(k, n, p):
    """P(X <= k) of the binomial distribution."""
    term = total = (1 - p) ** n
    if not term:
        return 1.0 if p < k / n else 0.0
    for i in range(k):
        term *= (n - i) / (i + 1) * p / (1 - p)
        total += term
    return min(1.0, total)


def exact_bounds(hits, count, level=0.95):
    """Clopper and Pearson's bounds of a share."""
    tail = (1 - level) / 2

    def solve(k, wanted):
        low, high = 0.0, 1.0
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if cumulated(k, count, middle) > wanted else (low, middle)
        return (low + high) / 2
    return (0.0 if hits == 0 else solve(hits - 1, 1 - tail)), (1.0 if hits == count else solve(hits, tail))


def value(row, key):
    return float(row[key]) if row.get(key) not in ("", None) else None


def limit_of(row):
    """The stress ratio of the limit surface, smaller in extension: M_e = 3 M / (3 + M)."""
    limit, eta = value(row, "limit_eta"), value(row, "truth_eta") or 0
    return 3 * limit / (3 + limit) if limit and eta < 0 else limit


def truth(row):
    """"lost", "not lost", or one of UNCOUNTED."""
    if row["truth_lost"] == "" or row["truth_slip"]:
        return "slip" if row["truth_slip"] else "ends at the loss"
    lost = row["truth_lost"] == "1"
    if row["ideal_lost"]:
        ideal = row["ideal_lost"] == "1"
        eta, other = value(row, "truth_eta"), value(row, "ideal_eta")
        if row["truth_eta"] and not ideal or not row["truth_eta"] and ideal:
            return "servo"
        if eta is not None and other is not None and abs(eta - other) > MAX_SERVO_ERROR:
            return "servo"
    if lost:
        limit = limit_of(row)
        if limit and abs(value(row, "truth_eta")) >= AT_LIMIT * limit:
            return "at the limit"
        return "small loss" if (value(row, "truth_q_lost") or 0) < WORTH_A_LOSS else "lost"
    if row["truth_eta"]:
        return "not lost"  # in this form, which ends before
    return "liquefied" if (value(row, "least_p") or 0) < LIQUEFIED else "not lost"


def missed(row):
    return truth(row) == "lost" and row["verdict"] == "none"


def false_collapse(row):
    return truth(row) == "not lost" and row["verdict"] == "collapse" and row["kind"] != "cyclic_mobility"


def has_interval(row):
    return truth(row) == "lost" and row["verdict"] == "collapse" and row["eta_low"] != "" and row["kind"] != "cyclic_mobility"


def covered(row):
    return value(row, "eta_low") <= value(row, "truth_eta") <= value(row, "eta_high")


def error(row):
    return abs(value(row, "eta") - value(row, "truth_eta"))


def fell(row):
    return row["fall_reading"] != "" and truth(row) == "lost"


def warned(row):
    return row["imminent"] != "" and int(row["imminent"]) < int(row["fall_reading"])


def false_alarm(row):
    return truth(row) == "not lost" and row["imminent"] != ""


def stands(row):
    return row["verdict"] == "none" and row["standing"] == "imminent"


def share(hits, count):
    if not count:
        return f"{'-':>24}"
    low, high = exact_bounds(hits, count)
    return f"{hits:>5}/{count:<5}{100 * low:5.1f}-{100 * high:<5.1f} "


def line(name, rows):
    assessed = [r for r in rows if r["outcome"] == "ok"]
    lost = [r for r in assessed if truth(r) == "lost"]
    stable = [r for r in assessed if truth(r) == "not lost"]
    onset = [r for r in assessed if has_interval(r)]
    errors = sorted(error(r) for r in onset)
    falls = [r for r in assessed if fell(r)]
    middle, far = (statistics.median(errors), errors[min(len(errors) - 1, int(0.9 * len(errors)))]) if errors else (None, None)
    return (f"{name:<27}{len(assessed):>6}{sum(map(missed, lost)):>6}/{len(lost):<5}{sum(map(false_collapse, stable)):>5}/{len(stable):<5}"
            f"{sum(r['verdict'] == 'indeterminate' for r in assessed):>7}  {share(sum(map(covered, onset)), len(onset))}"
            + (f"{middle:8.4f}{far:8.4f}" if errors else f"{'-':>8}{'-':>8}")
            + f"{sum(map(warned, falls)):>7}/{len(falls):<5}{sum(map(false_alarm, stable)):>5}/{len(stable):<5}"
            f"{sum(map(stands, assessed)):>5}")


HEAD = (f"{'':<27}{'tests':>6}{'missed':>8}{'':4}{'false':>7}{'':4}{'indet.':>7}  {'covered, 95 % bounds':<24}{'error':>8}{'90 %':>8}"
        f"{'imminent':>11}{'alarms':>8}{'stands':>9}")


def group_of(row, key):
    if key == "b_value":
        b = value(row, key)
        return "unknown" if b is None else next((name for limit, name in ((0.8, "below 0.80"), (0.95, "0.80 to 0.95")) if b < limit), "from 0.95")
    if key == "p0_kPa":
        return next((f"below {limit}" for limit in (50, 150, 500) if float(row[key]) < limit), "from 500")
    if key == "quality":
        return next((name for limit, name in ((0.25, "0.00 to 0.25, good"), (0.5, "0.25 to 0.50"), (0.75, "0.50 to 0.75"))
                     if float(row[key]) < limit), "0.75 to 1.00, terrible")
    return {"0": "no", "1": "yes"}.get(row[key], row[key])


def unique(values):
    return list(dict.fromkeys(values))


def forecasts(rows):
    out = ["", f"90 % interval of the forecast contains the onset     {'contained':>12}{'of':>6}{'no forecast':>14}"]
    for key in LEFT:
        lost = [r for r in rows if truth(r) == "lost" and r[key] != "" and r["form"] == "simulated"]
        made = [r for r in lost if r[key] != "-"]
        out.append(f"{key[5:] + ' % of the stress ratio left':<53}{sum(r[key] == '1' for r in made):>12}{len(made):>6}{len(lost) - len(made):>14}")
    return out


def print_table(rows):
    simulated = [r for r in rows if r["form"] == "simulated"]
    print(HEAD)
    for form in unique(r["form"] for r in rows):
        print(line(form, [r for r in rows if r["form"] == form]))
    for key, name in (("control", "control"), ("law", "law"), ("b_value", "B"), ("p0_kPa", "p'0, kPa"), ("quality", "instruments"),
                      ("extension", "extension"), ("membrane", "membrane")):
        print(f"\n{name} (as simulated)")
        for group in sorted(unique(group_of(r, key) for r in simulated)):
            print(line("  " + group, [r for r in simulated if group_of(r, key) == group]))
    print(*forecasts(rows), sep="\n")
    uncounted = [truth(r) for r in simulated if r["outcome"] == "ok"]
    print("\nneither lost nor not lost: " + ", ".join(f"{uncounted.count(w)} {w}" for w in UNCOUNTED))
    outcomes = [r["outcome"] for r in simulated]
    print("simulations: " + ", ".join(f"{outcomes.count(o)} {o}" for o in sorted(set(outcomes))))
    outcomes = [r["outcome"] for r in rows if r["form"] != "simulated" and r["outcome"] != "ok"]
    if outcomes:
        print("forms: " + ", ".join(f"{outcomes.count(o)} {o}" for o in sorted(set(outcomes))))


def print_misses(rows):
    kinds = (("missed", missed), ("false collapse", false_collapse), ("interval without the truth", lambda r: has_interval(r) and not covered(r)),
             ("no `imminent` before the fall", lambda r: fell(r) and not warned(r)), ("false `imminent`", false_alarm),
             ("none while `imminent` stands", stands))
    print("\nnumbers of the programmes")
    for name, holds in kinds:
        for form in unique(r["form"] for r in rows):
            found = [r["number"] for r in rows if r["form"] == form and r["outcome"] == "ok" and holds(r)]
            if found:
                print(f"{name}, {form}: {' '.join(found)}")
    for row in rows:
        if row["outcome"] != "ok":
            print(f"{row['outcome']}: {row['number']}, {row['form']}: {row['reason']}")


def print_times(path, limit_s=60):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    slow = [r for r in rows if float(r["simulation_s"]) >= limit_s]
    print(f"\nsimulations of {limit_s} s or more: {len(slow)}" + "".join(f"\n  {r['programme']}" for r in slow))


def read(results, index):
    with open(index, newline="", encoding="utf-8") as file:
        drawn = {row["number"]: row for row in csv.DictReader(file)}
    with open(results, newline="", encoding="utf-8") as file:
        return [drawn[row["number"]] | row for row in csv.DictReader(file)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", type=pathlib.Path, metavar="RESULTS.csv")
    parser.add_argument("index", type=pathlib.Path, metavar="INDEX.csv")
    parser.add_argument("--heading", metavar="TEXT")
    parser.add_argument("--times", type=pathlib.Path, metavar="TIMES.csv")
    parser.add_argument("--misses", action="store_true", help="list the programmes behind each count")
    options = parser.parse_args()
    rows = read(options.results, options.index)
    if options.heading:
        print(options.heading + "\n")
    print_table(rows)
    if options.misses:
        print_misses(rows)
    if options.times:
        print_times(options.times)
    return 0


if __name__ == "__main__":
    sys.exit(main())
