#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/intake/run.sh [--seed N] [--count M] [--trait KEY=VALUE]... [--by TRAIT]... [--list OUTCOME]... [--check]
# Writes M tables of triaxial tests with known meaning (make_tables.py), lets triax propose how it reads each one, and prints how many
# it reads right, by trait (score.py). --check: only checks the tables themselves (check_tables.py). Fails if less than 95 % are read or
# if any is read with a wrong meaning. Seeds below 1000 are for development. Published results use a seed from 1000 on, whose headings
# are partly held back from the others, and never the same seed twice after a change of the lexicon.
#   bench/intake/run.sh --seed 3 --count 500 --trait language=zh --list wrong
#   bench/intake/make_tables.py --list-traits      # traits and their values
# A reader other than triax: bench/intake/score.py FOLDER -- COMMAND
set -euo pipefail
cd "$(dirname "$0")/../.."
seed=1
count=2000
make=()
score=(--jobs 2)
check=
while [[ $# -gt 0 ]]; do
  case $1 in
    --seed) seed=$2; shift ;;
    --count) count=$2; shift ;;
    --trait) make+=(--trait "$2"); shift ;;
    --by | --list) score+=("$1" "$2"); shift ;;
    --check) check=1 ;;
    *) echo "unknown option $1; must be one of: --seed, --count, --trait, --by, --list, --check" >&2; exit 2 ;;
  esac
  shift
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 bench/intake/make_tables.py --seed "$seed" --count "$count" --out "$work" "${make[@]}"
if [[ $check ]]; then
  python3 bench/intake/check_tables.py "$work"
  exit
fi
[[ ${TRIAX_BUILT:-} ]] || tools/build release triax >/dev/null
python3 bench/intake/score.py "$work" "${score[@]}" -- build/release/triax replay {} --propose --proposal-format expected
