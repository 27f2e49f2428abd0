#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/xlsx/run.sh [ROWS [PAIRS]]: replay of a workbook of 20 columns beside the same record as CSV, in turn, PAIRS times
# each, and the memory of both. Fails above 3 times the time of CSV or above 100 MB.
set -euo pipefail
cd "$(dirname "$0")/../.."
rows=${1:-1000000}
pairs=${2:-3}
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
for kind in csv xlsx; do
  printf '%-5s %12s bytes  %7.2f s  %7.2f s of processor  %6.1f MB\n' "$kind" "$(stat -c %s "$work/record.$kind")" \
    "$(column $kind 1 | median)" "$(column $kind 3 | median)" "$(column $kind 2 | median | awk '{print $1/1024}')"
done
ratio=$(paste -d' ' <(column xlsx 1) <(column csv 1) | awk '{print $1/$2}' | median)
printf 'ratio xlsx/csv %.2f (%d rows, %d pairs, median)\n' "$ratio" "$rows" "$pairs"
awk -v r="$ratio" -v m="$(column xlsx 2 | median)" 'BEGIN { if (r > 3 || m > 100 * 1024) { print "a workbook costs too much" >"/dev/stderr"; exit 1 } }'
