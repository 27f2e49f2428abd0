#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/replay/run.sh [--labels | ROWS [PAIRS]]: replay of a record against the yardstick, `sqlite3 .import` of the same
# file into an empty database, in turn, PAIRS times each. Then memory at a tenth of the length and
# whole, what naive second-order work finds on that record, and what the alarm costs. Fails if the collapse is not found or the
# ratio is above 1. --labels: one pair, # for what depends on the clock.
set -euo pipefail
cd "$(dirname "$0")/../.."
labels=0
[[ ${1:-} != --labels ]] || { labels=1; shift; }
rows=${1:-1000000}
pairs=${2:-7}
runs=$pairs
((!labels)) || runs=1
[[ ${TRIAX_BUILT:-} ]] || tools/build release triax bench_make_record bench_naive_work bench_alarm_cost >/dev/null
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
build/release/bench/bench_make_record "$rows" "$work/record.csv"
build/release/bench/bench_make_record $((rows / 10)) "$work/tenth.csv"

# timed LABEL COMMAND...: appends wall seconds and peak kilobytes of the whole process to $work/LABEL
timed() {
  local label=$1
  shift
  /usr/bin/time -a -o "$work/$label" -f '%e %M' "$@" >/dev/null
}
import() { rm -f "$work"/import.db*; timed import sqlite3 "$work/import.db" ".import --csv $work/record.csv readings"; }
replay() {
  rm -f "$work"/replay.db*
  timed "$1" build/release/triax replay "$work/$2" --set specimen.height_mm=140 --set specimen.diameter_mm=70 \
    --db "$work/replay.db"
}
if ((!labels)); then
  replay warm record.csv
  import
  rm "$work/import"
fi
replay tenth tenth.csv
for ((i = 0; i < runs; ++i)); do import; replay replay record.csv; done

median() { sort -n | awk '{v[NR]=$1} END {print (NR % 2) ? v[(NR+1)/2] : (v[NR/2]+v[NR/2+1])/2}'; }
column() { awk -v c="$2" '{print $c}' "$work/$1"; }
# DIGITS: a number of standard input, or # where only the words are asked for.
figure() { if ((labels)); then cat >/dev/null; echo '#'; else awk -v d="$1" '{printf "%.*f", d, $1}'; fi; }
# LABEL: least and largest of its seconds.
span() { echo "$(column "$1" 1 | sort -n | head -n 1 | figure 2)-$(column "$1" 1 | sort -n | tail -n 1 | figure 2)"; }
printf '%d readings, %s bytes; %d pairs, medians of wall time\n\n' "$rows" "$(stat -c %s "$work/record.csv")" "$pairs"
printf '%-58s %7s s  (%s)\n' 'sqlite3 .import' "$(column import 1 | median | figure 2)" "$(span import)"
printf '%-58s %7s s  (%s)\n' 'triax replay (parse, reduce, W2, collapse, store)' "$(column replay 1 | median | figure 2)" "$(span replay)"
ratio=$(paste -d' ' <(column replay 1) <(column import 1) | awk '{print $1/$2}' | median)
printf '%-58s %7s    (pair by pair, median)\n' 'ratio triax/sqlite3' "$(figure 2 <<<"$ratio")"
printf '%-58s %7s MB, at a tenth of the record %s MB\n' 'peak memory of triax' \
  "$(column replay 2 | median | awk '{print $1/1024}' | figure 1)" "$(column tenth 2 | median | awk '{print $1/1024}' | figure 1)"
printf '%-58s %7.1f MB\n\n' 'database' "$(stat -c %s "$work/replay.db" | awk '{print $1/1048576}')"
build/release/bench/bench_naive_work "$rows"
echo
build/release/bench/bench_alarm_cost "$rows" $((labels ? 1 : 5)) |
  if ((labels)); then sed -E 's/ [0-9]+ ns/ # ns/g; s/ [0-9.]+$/ #/'; else cat; fi

# What the replay itself found, from the record's text: a flow near the true peak; and nothing slower.
build/release/triax report --db "$work/replay.db" --format json |
  sed -n '/"collapse"/,/"criteria"/p' | grep -q '"kind": "flow"' || { echo "the replay found no flow collapse" >&2; exit 1; }
((labels)) || awk -v r="$ratio" 'BEGIN { if (r > 1) { print "slower than the yardstick: ratio " r >"/dev/stderr"; exit 1 } }'
