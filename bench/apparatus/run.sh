#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/apparatus/run.sh [--labels | TESTS [PAIRS]]: the virtual apparatus. A CSU test at 10 readings a second on one core against
# the bare material point driven through the same increments; a sweep of TESTS seeds with one job and with two, PAIRS
# times in turn; memory of a test of 72 hours, without and with the database. Fails if that memory grows.
set -euo pipefail
cd "$(dirname "$0")/../.."
labels=
[[ ${1:-} != --labels ]] || { labels=--labels; shift; }
tests=${1:-24}
pairs=${2:-3}
[[ ${TRIAX_BUILT:-} ]] || tools/build release triax bench_apparatus_speed bench_apparatus_memory >/dev/null
programme=samples/programmes/csu_26.toml
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

taskset -c 0 build/release/bench/bench_apparatus_speed $labels "$programme" "$work/speed.db"

# sweep JOBS TESTS: appends the wall seconds of the whole process to $work/JOBS
sweep() {
  rm -f "$work"/sweep.db*
  /usr/bin/time -a -o "$work/$1" -f %e build/release/triax simulate "$programme" --sweep "seed=1:$2:1" --jobs "$1" \
    --db "$work/sweep.db" >/dev/null
}
median() { sort -n | awk '{v[NR]=$1} END {printf "%.2f", (NR % 2) ? v[(NR+1)/2] : (v[NR/2]+v[NR/2+1])/2}'; }
one='#' two='#' faster='#'
if [[ $labels ]]; then
  sweep 2 2
else
  for ((i = 0; i < pairs; ++i)); do sweep 1 "$tests"; sweep 2 "$tests"; done
  one=$(median <"$work/1") two=$(median <"$work/2")
  faster=$(paste -d' ' "$work/1" "$work/2" | awk '{print $1/$2}' | median)
fi
printf '\nsweep of %d tests as the programme has it, stored, seconds (medians of %d pairs)\n' "$tests" "$pairs"
printf 'one job %s, two jobs %s, times faster %s\n' "$one" "$two" "$faster"

printf '\nresident memory in a test of 72 hours at a reading a second, without database\n'
build/release/bench/bench_apparatus_memory $labels "$programme"
printf 'with it\n'
build/release/bench/bench_apparatus_memory $labels "$programme" "$work/memory.db"
size=$(stat -c %s "$work/memory.db" | awk '{printf "%.1f", $1/1048576}')
[[ ! $labels ]] || size='#'
printf 'database in the end: %s MB\n' "$size"
