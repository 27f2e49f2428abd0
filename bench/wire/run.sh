#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/wire/run.sh [--labels | REQUESTS [ROUNDS [MINUTES]]]: questions a second of `lxi benchmark -r` to our 34401A, to a bare Asio echo
# and to a stand-in in Python, in turn; the best of ROUNDS each. Then scans of seven meters, and ten a second for MINUTES
# (scans.py). Fails below 0.9 of the echo or twice the stand-in, or where a bound of scans.py does not hold. 11 minutes.
# --labels: seconds, # for every number, no bound.
set -euo pipefail
cd "$(dirname "$0")/../.."
if [[ ${1:-} == --labels ]]; then
  bench/wire/run.sh 200 1 0.05 8 | sed -E 's/[-+]?[0-9]+(\.[0-9]+)?/#/g' || true
  exit
fi
requests=${1:-20000}
rounds=${2:-5}
minutes=${3:-10}
scans=${4:-400}
[[ ${TRIAX_BUILT:-} ]] || tools/build release bench_bare_echo bench_seven_meters scpi_station triax >/dev/null
work=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null || true; rm -rf "$work"' EXIT
build/release/tests/wire/scpi_station >"$work/ours" &
build/release/bench/bench_bare_echo >"$work/echo" &
python3 bench/wire/stand_in.py >"$work/python" &
until grep -qs ready "$work/ours" && [[ -s $work/echo && -s $work/python ]]; do sleep 0.1; done
held=0
python3 bench/wire/answers.py "$requests" "$rounds" 1000 ours="$(sed -n 's/34401A .*://p' "$work/ours")" \
  asio-echo="$(cat "$work/echo")" python="$(cat "$work/python")" || held=1
kill $(jobs -p)
echo
python3 bench/wire/scans.py "$minutes" "$scans" || held=1
exit $held
