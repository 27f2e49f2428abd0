#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/python/run.sh [--labels | POINTS [ROUNDS [READINGS]]]: one increment of SANISAND at each of POINTS points on one core, by one
# call from Python and by a loop in C++ that is written for it, ROUNDS times in turn, processor time; then how long the states of a
# test of READINGS come to Python. Fails if Python has less than 90 % of the loop's speed, if the two do not come to the same
# stresses, or if states that are loaded or mapped take more than 10 ms. --labels: small, # for what depends on the clock.
set -euo pipefail
cd "$(dirname "$0")/../.."
labels=
[[ ${1:-} != --labels ]] || { labels=--labels; set -- 2000 1 2000; }
points=${1:-1000000}
rounds=${2:-5}
readings=${3:-1000000}
[[ ${TRIAX_BUILT:-} ]] || tools/build release triax_python bench_cpp_loop bench_make_record >/dev/null
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export PYTHONPATH=build/release/python
for ((i = 0; i < rounds; ++i)); do
  taskset -c 0 build/release/bench/bench_cpp_loop "$points" 1 >>"$work/cpp"
  taskset -c 0 /usr/bin/python3 bench/python/increments.py "$points" 1 >>"$work/python"
done
if [[ $(cut -d' ' -f2 "$work/cpp" | sort -u) != $(cut -d' ' -f2 "$work/python" | sort -u) ]]; then
  echo "run.sh: Python and C++ do not come to the same stresses" >&2
  exit 1
fi
least() { cut -d' ' -f1 "$work/$1" | sort -n | head -n 1; }
cpp=$(least cpp) python=$(least python)
figure() { if [[ $labels ]]; then echo '#'; else printf "$1" "$2"; fi; }
printf 'one increment of sanisand/S28-general at each of %s points, processor time, least of %s rounds in turn\n\n' \
  "$(figure %d "$points")" "$(figure %d "$rounds")"
printf '%-44s %8s ns a point\n' 'loop in C++' "$(figure %.0f "$cpp")" 'Points.advance, one call from Python' "$(figure %.0f "$python")"
share=$(awk -v c="$cpp" -v p="$python" 'BEGIN {print 100 * c / p}')
printf "%-44s %8s %% of C++'s\n\n" 'speed from Python' "$(figure %.1f "$share")"
build/release/bench/bench_make_record "$readings" "$work/record.csv"
/usr/bin/python3 bench/python/views.py "$work/record.csv" $labels
[[ $labels ]] || awk -v s="$share" 'BEGIN { if (s < 90) { print "run.sh: less than 90 % of the speed of C++" >"/dev/stderr"; exit 1 } }'
