#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/wire/run.sh [REQUESTS [ROUNDS]]: questions a second of `lxi benchmark -r` to our 34401A, to a bare Asio echo and to
# a stand-in in Python, in turn; the best of ROUNDS each. Fails below 0.9 of the echo or twice the stand-in.
set -euo pipefail
cd "$(dirname "$0")/../.."
requests=${1:-20000}
rounds=${2:-5}
[[ ${TRIAX_BUILT:-} ]] || tools/build release bench_bare_echo scpi_station >/dev/null
work=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null; rm -rf "$work"' EXIT
build/release/tests/wire/scpi_station >"$work/ours" &
build/release/bench/bench_bare_echo >"$work/echo" &
python3 bench/wire/stand_in.py >"$work/python" &
until grep -qs ready "$work/ours" && [[ -s $work/echo && -s $work/python ]]; do sleep 0.1; done
python3 bench/wire/answers.py "$requests" "$rounds" 1000 ours="$(sed -n 's/34401A .*://p' "$work/ours")" \
  asio-echo="$(cat "$work/echo")" python="$(cat "$work/python")"
