#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/calibrate/run.sh [recovery|coverage|left-out|seeds|speed] [--sets N] [--labels]: calibration of virtual tests with known parameters.
# recovery: how near the true ones are from exact tests, with as many searches as the program makes. coverage: how often the 95 % intervals of
# noisy ones hold them, from the optimum next to the truth. left-out: how often the 90 % intervals of eta at collapse hold, each test predicted
# from the others. seeds: how often ten seeds end in one optimum. speed: how long 12 tests and 8 parameters take, with runs of the driver a
# second beside those of the bare driver. N sets a law (20); five times as many for coverage, N for its plug-in (the UMAT of the tests, of which
# each law is a process). Fails where not all parameters of exact tests are within 1 %, and where intervals hold more or less often than 93 to
# 97 % by more than three standard errors.
# --labels: small, # in place of the numbers.
set -euo pipefail
cd "$(dirname "$0")/../.."
[[ ${TRIAX_BUILT:-} ]] || tools/build release bench_calibrate >/dev/null; [[ ${TRIAX_BUILT:-} ]] || tools/build release umat_fixture >/dev/null 2>&1 || true
failed=0
bench() { build/release/bench/bench_calibrate "$@" ${labels:+--labels} || failed=1; }
plugin() {
  if [[ -f build/release/tests/libumat_fixture.so ]]; then bench --law umat "$@"
  else echo "umat: not run, there is no Fortran compiler for its plug-in"; fi
}
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
  for law in mohr_coulomb cam_clay norsand hypoplastic sanisand; do bench --law "$law" --sets "$sets" --tests 8 --searches 3; done
  plugin --sets "$sets" --tests 4 --searches 3
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
  plugin --sets "$sets" --tests 4 --stress-noise-kPa 0.5 --strain-noise 2e-5 --intervals-only
fi
if wanted seeds; then
  bench --law hypoplastic --sets 1 --tests 8 --searches 10 --stress-noise-kPa 0.5 --strain-noise 2e-5
  bench --law norsand --sets 1 --tests 8 --searches 10 --stress-noise-kPa 0.5 --strain-noise 2e-5
fi
if wanted speed; then
  bench --law hypoplastic --sets 1 --tests 12 --searches 3 --threads 2 --stress-noise-kPa 0.5 --strain-noise 2e-5 --bare
fi
exit $failed
