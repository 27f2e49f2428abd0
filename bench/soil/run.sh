#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/soil/run.sh [OPTIONS of bench_soil]: how often the 95 % intervals of `triax soil` hold the truth over 1,000 virtual campaigns of
# 3 to 20 tests on sands whose laws are known, with instruments of three classes; and how often one spoilt test is named.
set -euo pipefail
cd "$(dirname "$0")/../.."
[[ ${TRIAX_BUILT:-} ]] || tools/build release bench_soil >/dev/null
build/release/bench/bench_soil "$@" || { status=$?; ((status == 1)) || exit "$status"; }  # 1: a bound is not held
