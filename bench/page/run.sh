#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/page/run.sh [MINUTES]: figures of load of `triax open`: what starting costs; a test of 10^6 readings; from a reading to ten clients; memory of the server over
# MINUTES (5); a hundred disconnects against the database; who records with and without browsers; and, where chromium and selenium are, from a
# reading to the pixels of ten browsers and the heap of a page (bench/page/pixels.py).
set -euo pipefail
cd "$(dirname "$0")/../.."
minutes=${1:-5}
[[ ${TRIAX_BUILT:-} ]] || tools/build release triax bench_make_record bench_recorder_timing >/dev/null
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
build/release/bench/bench_make_record 1000000 "$work/record.csv"
build/release/triax replay "$work/record.csv" --set specimen.height_mm=140 --set specimen.diameter_mm=70 --db "$work/million.db" >/dev/null
rm "$work/record.csv"
load() { python3 bench/page/load.py "$1" build/release/triax "$work" "${@:2}"; }
load start 20
load million 5
load latency 60 10
load disconnects 100
load memory "$minutes"
build/release/bench/bench_recorder_timing 20 5 10
python3 bench/page/pixels.py build/release/triax "$work" "$minutes" || [ $? = 77 ]
