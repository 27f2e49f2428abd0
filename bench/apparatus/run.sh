#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/apparatus/run.sh [TESTS [PAIRS]]: the virtual apparatus. A CSU test at 10 readings a second on one core against
# the bare material point driven through the same increments; a sweep of TESTS seeds with one job and with two, PAIRS
# times in turn; memory of a test of 72 hours, without and with the database. Fails if that memory grows.
set -euo pipefail
cd "$(dirname "$0")/../.."
tests=${1:-24}
pairs=${2:-3}
tools/build release triax bench_apparatus_speed bench_apparatus_memory >/dev/null
programme=samples/programmes/csu_26.toml
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

taskset -c 0 build/release/bench/bench_apparatus_speed "$programme" "$work/speed.db"

# sweep JOBS: appends the wall seconds of the whole process to $work/JOBS
sweep() {
  rm -f "$work"/sweep.db*
  /usr/bin/time -a -o "$work/$1" -f %e build/release/triax simulate "$programme" --sweep "seed=1..$tests" --jobs "$1" \
    --db "$work/sweep.db" >/dev/null
}
median() { sort -n | awk '{v[NR]=$1} END {print (NR % 2) ? v[(NR+1)/2] : (v[NR/2]+v[NR/2+1])/2}'; }
for ((i = 0; i < pairs; ++i)); do sweep 1; sweep 2; done
printf '\n# sweep of %d tests as the programme has it, stored: JOBS SECONDS (medians of %d)\n' "$tests" "$pairs"
for jobs in 1 2; do printf '%d %.2f\n' "$jobs" "$(median <"$work/$jobs")"; done
printf '# %.2f times faster with two jobs\n' "$(paste -d' ' "$work/1" "$work/2" | awk '{print $1/$2}' | median)"

printf '\n# 72 hours at a reading a second, no database: HOURS RESIDENT_KB\n'
build/release/bench/bench_apparatus_memory "$programme"
printf '# the same with the database\n'
build/release/bench/bench_apparatus_memory "$programme" "$work/memory.db"
printf '# database: %s bytes\n' "$(stat -c %s "$work/memory.db")"
