#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/point/run.sh [FILE.svg|FILE.png]: one increment of each law against one solution of a 6 x 6 system, in both spaces;
# then error against time per path for each law, as tables and (with FILE.svg) as a diagram.
set -euo pipefail
cd "$(dirname "$0")/../.."
tools/build release bench_increments bench_work_precision >/dev/null
build/release/bench/bench_increments
build/release/bench/bench_work_precision "$@" | sed 's/^/# /'
