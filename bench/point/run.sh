#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/point/run.sh [--labels | FILE.svg | FILE.png]: one increment of each law against one solution of a 6 x 6 system, in both
# spaces. With FILE instead error against time per path for each law, as tables and as a diagram.
set -euo pipefail
cd "$(dirname "$0")/../.."
[[ ${TRIAX_BUILT:-} ]] || tools/build release bench_increments bench_work_precision >/dev/null
case ${1:-} in
  '' | --labels) build/release/bench/bench_increments "$@" ;;
  *) build/release/bench/bench_work_precision "$@" ;;
esac
