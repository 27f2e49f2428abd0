#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/assessment/run.sh [--seed N] [--count M] [--jobs N] [--forms] [--out RESULTS.csv] [--misses] [--only NUMBER]... [--keep FOLDER]
# bench/assessment/run.sh --check FILE [--refresh] [--count M] [--jobs N] [--only NUMBER]...
# Draws M random test programmes (make_programmes.py), simulates each of them (at most 60 s), with --forms also replays what laboratories
# would export (export_forms.py), and prints how the assessment compares with the truth of the simulated specimens (tables.py). --out keeps
# the results, one line for each test and form, --misses lists the programmes behind each count, --keep keeps programmes and exported files.
# --check compares the results of seed 1 with those in FILE (compare.py) and fails if any differs. With --refresh it stores them in FILE
# instead, for all programmes, for --count M or for --only NUMBER.
# Seeds below 1000 are for development. Published results use seeds from 1000 on, and never the same seed twice after a change.
set -euo pipefail
cd "$(dirname "$0")/../.."
seed=1
count=
jobs=2
out=
check=
refresh=
work=
make=()
run=()
table=()
while [[ $# -gt 0 ]]; do
  case $1 in
    --seed) seed=$2; shift ;;
    --count) count=$2; shift ;;
    --jobs) jobs=$2; shift ;;
    --out) out=$2; shift ;;
    --only) make+=(--only "$2"); shift ;;
    --keep) work=$2; run+=(--keep "$2/files"); shift ;;
    --check) check=$2; shift ;;
    --refresh) refresh=--refresh ;;
    --forms) run+=(--forms) ;;
    --misses) table+=(--misses) ;;
    *) echo "unknown option $1; must be one of: --seed, --count, --jobs, --forms, --out, --misses, --only, --keep, --check, --refresh" >&2
       exit 2 ;;
  esac
  shift
done
if [[ ! $work ]]; then
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
fi
mkdir -p "$work"
if [[ $check ]]; then
  seed=1
  run+=(--forms)
  [[ $count ]] || count=$(python3 bench/assessment/compare.py "$check")
fi
count=${count:-400}
python3 bench/assessment/make_programmes.py --seed "$seed" --count "$count" --out "$work/programmes" "${make[@]}"
[[ ${TRIAX_BUILT:-} ]] || tools/build release triax >/dev/null
results=${out:-$work/results.csv}
python3 bench/assessment/run_tests.py "$work/programmes" --triax "${TRIAX:-build/release/triax}" --seed "$seed" --jobs "$jobs" \
  --out "$results" --times "$work/times.csv" "${run[@]}"
if [[ $check ]]; then
  python3 bench/assessment/compare.py "$check" "$results" $refresh
  exit
fi
heading="seed $seed, $count programmes, commit $(git rev-parse --short HEAD), $(date '+%-d %B %Y')"
python3 bench/assessment/tables.py "$results" "$work/programmes/index.csv" --heading "$heading" --times "$work/times.csv" "${table[@]}"
