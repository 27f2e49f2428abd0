#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/calibrate/run.sh [recovery|umat|coverage|left-out|seeds|speed] [--sets N] [--labels]: calibration of virtual tests with known parameters: how near the true ones
# are from exact tests (umat: with the plug-in of the tests, a process for each run of the driver), how often intervals of noisy ones hold
# them, how often the 90 % intervals of eta at collapse hold, each test predicted from the others, how often ten seeds end in one optimum,
# and how long 12 tests and 8 parameters take, with runs of the driver a second beside those of the bare driver. N sets a law (20), a
# twentieth of them for umat, five times as many for coverage.
# --labels: small, # in place of the numbers.
set -euo pipefail
cd "$(dirname "$0")/../.."
[[ ${TRIAX_BUILT:-} ]] || tools/build release bench_calibrate >/dev/null; [[ ${TRIAX_BUILT:-} ]] || tools/build release umat_fixture >/dev/null 2>&1 || true
bench() { build/release/bench/bench_calibrate "$@" ${labels:+--labels}; }
labels=
part=all
sets=20
while [[ $# -gt 0 ]]; do
  case $1 in
    --sets) sets=$2; shift ;;
    --labels) labels=1 ;;
    *) part=$1 ;;
  esac
  shift
done
wanted() { [[ $part == all || $part == "$1" ]]; }
if wanted recovery; then
  for law in mohr_coulomb cam_clay norsand hypoplastic sanisand; do bench --law "$law" --sets "$sets" --tests 8; done
fi
if wanted umat; then
  if [[ -f build/release/tests/libumat_fixture.so ]]; then bench --law umat --sets "$(((sets + 19) / 20))" --tests 6 --searches 1
  else echo "umat: not run, there is no Fortran compiler for its plug-in"; fi
fi
if wanted left-out; then
  for law in norsand sanisand hypoplastic; do
    for off in 0 0.005; do
      bench --law "$law" --sets "$sets" --tests 8 --stress-noise-kPa 0.5 --strain-noise 2e-5 --void-ratio-noise "$off" --left-out
    done
  done
fi
if wanted coverage; then
  for law in mohr_coulomb cam_clay norsand hypoplastic sanisand; do
    bench --law "$law" --sets "$((sets * 5))" --tests 8 --stress-noise-kPa 0.5 --strain-noise 2e-5 --intervals-only
  done
fi
if wanted seeds; then
  bench --law hypoplastic --sets 1 --tests 8 --searches 10 --stress-noise-kPa 0.5 --strain-noise 2e-5
  bench --law norsand --sets 1 --tests 8 --searches 10 --stress-noise-kPa 0.5 --strain-noise 2e-5
fi
if wanted speed; then
  bench --law hypoplastic --sets 1 --tests 12 --searches 3 --threads 2 --stress-noise-kPa 0.5 --strain-noise 2e-5 --bare
fi
