#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/stability/run.sh [--labels]: one stress probe of each law against one solution of a 2 x 2 and of a 6 x 6 system, in both
# planes; then a bifurcation domain of 200 x 200 states with 360 directions each on one thread and on two.
set -euo pipefail
cd "$(dirname "$0")/../.."
[[ ${TRIAX_BUILT:-} ]] || tools/build release bench_probes >/dev/null
build/release/bench/bench_probes "$@"
