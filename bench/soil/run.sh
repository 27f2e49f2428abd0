#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/soil/run.sh [OPTIONS of bench_soil]: how often the 95 % intervals of `triax soil` hold the truth over 1,000 virtual campaigns of
# 3 to 20 tests on sands whose laws are known, with instruments of three classes; and how often one spoilt test is named,
# beside how often the best test that knows the scatter of specimens would name it (bench/soil/limit.hpp). Fails where a share is out of 93
# to 97 % by more than its number of campaigns explains (three standard deviations).
set -euo pipefail
cd "$(dirname "$0")/../.."
[[ ${TRIAX_BUILT:-} ]] || tools/build release bench_soil >/dev/null
build/release/bench/bench_soil "$@"
