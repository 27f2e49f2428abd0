#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/warning/run.sh [OPTIONS of bench_warning]: what is said of an onset before it comes, over 2,024 simulated tests
# with instruments from good to cheap, readings from dense to sparse, air, rests and loops, on seeds that the alarm's rules were not
# tuned on (1 to 16 were): the alarm by itself, with two earlier tests, with a simulation, and what could be known at most. Then, over eight of the seeds, what
# a guard that hands the load over catches. Prints whether the bounds are held.
set -euo pipefail
cd "$(dirname "$0")/../.."
tools/build release bench_warning >/dev/null
build/release/bench/bench_warning --seeds 46 --from 101 "$@" || { status=$?; ((status == 1)) || exit "$status"; }  # 1: a bound is not held
build/release/bench/bench_warning --guard --seeds 8 --from 101 "$@"
