#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/detection/run.sh [OPTIONS of bench_detection]: the monitor and three naive methods over at least 2,000 simulated
# tests through noisy instruments, against the specimen's own truth. Fails if a bound is broken.
set -euo pipefail
cd "$(dirname "$0")/../.."
[[ ${TRIAX_BUILT:-} ]] || tools/build release bench_detection >/dev/null
build/release/bench/bench_detection "$@"
