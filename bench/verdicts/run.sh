#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/verdicts/run.sh [OPTIONS of bench_verdicts]: verdicts on more than 5,000 simulated records with what happens to records in
# laboratories, in three forms, against the specimens' own truth. Fails if a bound is broken.
set -euo pipefail
cd "$(dirname "$0")/../.."
[[ ${TRIAX_BUILT:-} ]] || tools/build release bench_verdicts >/dev/null
build/release/bench/bench_verdicts "$@"
