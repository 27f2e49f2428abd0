#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/recorded/run.sh [--records FOLDER] [--labels FILE] [--tolerance ROWS] [--list] [--fit]
# Compares what triax finds in recorded tests with their labels, and with simple methods (score.py).
# FOLDER [../shared/data] has the records, FILE [bench/recorded/labels.csv] the labels. Records that
# are missing are listed and not counted. --fit also prints the score of the cyclic warning on tests
# that it was not fitted to (fit_cyclic.py). bench/results/accuracy.md says where the records are from.
# A labels file of your own has the same columns:
#   file            in FOLDER
#   type            undrained, drained or cyclic
#   kind            flow, limited or none
#   onset_authors, onset_peak_q, onset_r_u
#                   row of the onset (from 0) by the authors, by the largest q before it falls, and
#                   by a pore pressure ratio of 0.95; may be empty. The first one is decisive
#   rows_per_cycle  of a cyclic test
#   fit             yes: the cyclic warning was fitted to this test
#   columns         places of q (kPa), p' (kPa) and axial strain (%), from 1, as 1:3:4
#   replay          options for triax replay
#   source, licence
set -euo pipefail
cd "$(dirname "$0")/../.."
records=../shared/data
labels=bench/recorded/labels.csv
options=()
fit=
while [[ $# -gt 0 ]]; do
  case $1 in
    --records) records=$2; shift ;;
    --labels) labels=$2; shift ;;
    --tolerance) options+=("$1" "$2"); shift ;;
    --list) options+=("$1") ;;
    --fit) fit=1 ;;
    *) echo "unknown option $1; must be one of: --records, --labels, --tolerance, --list, --fit" >&2; exit 2 ;;
  esac
  shift
done
[[ ${TRIAX_BUILT:-} ]] || tools/build release triax bench_print_cycles >/dev/null
python3 bench/recorded/score.py --program "${TRIAX:-build/release/triax}" --records "$records" --labels "$labels" "${options[@]}"
if [[ $fit ]]; then
  for disturbed in "" "--every 2" "--every 4" "--noise"; do
    echo "cyclic warning, one test left out at a time${disturbed:+, $disturbed}:"
    # shellcheck disable=SC2086 # two words
    python3 bench/recorded/fit_cyclic.py --records "$records" --labels "$labels" $disturbed | tail -1
  done
fi
