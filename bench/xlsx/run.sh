#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/xlsx/run.sh [--labels | ROWS [PAIRS]]: replay of a workbook of 20 columns beside the same record as CSV, in turn, PAIRS times
# each, and the memory of both. Fails above 3 times the time of CSV or above 100 MB. --labels: one pair of 20,000 rows, # for what
# depends on the clock or on the number of rows.
set -euo pipefail
cd "$(dirname "$0")/../.."
labels=0
[[ ${1:-} != --labels ]] || { labels=1; shift; set -- 20000 1; }
rows=${1:-1000000}
pairs=${2:-5}
[[ ${TRIAX_BUILT:-} ]] || tools/build release triax >/dev/null
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 bench/xlsx/make_tables.py "$rows" "$work/record.csv" "$work/record.xlsx"
replay() {
  rm -f "$work"/replay.db*
  /usr/bin/time -a -o "$work/times.$1" -f '%e %M %U' build/release/triax replay "$work/record.$1" \
    --set specimen.height_mm=140 --set specimen.diameter_mm=70 --db "$work/replay.db" >/dev/null
}
for ((i = 0; i < pairs; ++i)); do replay csv; replay xlsx; done
median() { sort -n | awk '{v[NR]=$1} END {print (NR % 2) ? v[(NR+1)/2] : (v[NR/2]+v[NR/2+1])/2}'; }
column() { awk -v c="$2" '{print $c}' "$work/times.$1"; }
# DIGITS: a number of standard input, or # where only the words are asked for.
figure() { if ((labels)); then cat >/dev/null; echo '#'; else awk -v d="$1" '{printf "%.*f", d, $1}'; fi; }
printf '%s rows of 20 columns, %s pairs, medians\n\n' "$(figure 0 <<<"$rows")" "$(figure 0 <<<"$pairs")"
for kind in csv xlsx; do
  printf '%-5s %7s MB of file  %7s s  %7s s of processor  %7s MB of memory\n' "$kind" \
    "$(stat -c %s "$work/record.$kind" | awk '{print $1/1048576}' | figure 1)" "$(column $kind 1 | median | figure 2)" \
    "$(column $kind 3 | median | figure 2)" "$(column $kind 2 | median | awk '{print $1/1024}' | figure 1)"
done
ratios=$(paste -d' ' <(column xlsx 1) <(column csv 1) | awk '{print $1/$2}')
processor=$(paste -d' ' <(column xlsx 3) <(column csv 3) | awk '{print $1/$2}' | median)
ratio=$(median <<<"$ratios")
printf 'ratio xlsx/csv, pair by pair: %s of time (%s-%s), %s of processor\n' "$(figure 2 <<<"$ratio")" \
  "$(sort -n <<<"$ratios" | head -n 1 | figure 2)" "$(sort -n <<<"$ratios" | tail -n 1 | figure 2)" "$(figure 2 <<<"$processor")"
((labels)) || awk -v r="$ratio" -v m="$(column xlsx 2 | median)" \
  'BEGIN { if (r > 3 || m > 100 * 1024) { print "a workbook costs too much" >"/dev/stderr"; exit 1 } }'
