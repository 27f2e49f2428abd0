#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/page/run.sh [--labels | MINUTES]: figures of load of `triax open`: what starting costs; a test of 10^6 readings; from a reading
# to ten clients; a hundred disconnects against the database; who records with and without browsers; from a reading to the pixels of ten
# browsers; then, side by side over MINUTES (60), the heap of a page and the memory of the server. Chromium and selenium must be there.
# Status 1 where a bound is not held. --labels: seconds, # for every number, no bound.
set -euo pipefail
cd "$(dirname "$0")/../.."
[[ ${TRIAX_BUILT:-} ]] || tools/build release triax bench_make_record bench_recorder_timing >/dev/null
work=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null || true; rm -rf "$work"' EXIT
status=0
held() { "$@" || { local ended=$?; ((ended == 1)) || exit "$ended"; status=1; }; }  # 1: a bound is not held
part() { held python3 "bench/page/$1.py" "$2" build/release/triax "$work" "${@:3}"; }

# READINGS STARTS TIMES SECONDS BREAKS PAIRS BROWSERS MINUTES WARM_UP_S
all() {
  build/release/bench/bench_make_record "$1" "$work/record.csv"
  build/release/triax replay "$work/record.csv" --set specimen.height_mm=140 --set specimen.diameter_mm=70 --db "$work/million.db" >/dev/null
  rm "$work/record.csv"
  part load start "$2"
  part load million "$3"
  part load latency "$4" 10
  part load disconnects "$5"
  held build/release/bench/bench_recorder_timing "$4" "$6" 10
  part pixels pixels "$4" "$7"
  part pixels heap "$8" "$9" >"$work/heap" &
  part load memory "$8" "$9"
  wait $! || status=1
  cat "$work/heap"
}
if [[ ${1:-} == --labels ]]; then
  all 20000 1 1 3 3 1 1 0.1 1 | sed -E 's/[-+]?[0-9]+(\.[0-9]+)?/#/g'
  exit
fi
all 1000000 20 5 30 100 5 10 "${1:-60}" 90
exit $status
