#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/warning/run.sh [OPTIONS of bench_warning]: warnings and forecasts of an onset in 1,056 simulated tests, with instruments from good
# to cheap, readings from dense to sparse, air, rests and loops. The seeds (1001 to 1024) are not those of development (below 1000): the
# alarm alone, with two earlier tests, with a simulation, and the best possible forecasts. Then, with four of the seeds, the result of a
# guard that hands the load over. Prints which bounds are held.
set -euo pipefail
cd "$(dirname "$0")/../.."
tools/build release bench_warning >/dev/null
build/release/bench/bench_warning --seeds 24 --from 1001 "$@" || { status=$?; ((status == 1)) || exit "$status"; }  # 1: a bound is not held
build/release/bench/bench_warning --guard --seeds 4 --from 1001 "$@"
