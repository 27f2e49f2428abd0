#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/grains/run.sh [--state FILE[.gz]] [--peers FOLDER] [--jobs "1 2"] [--steps N]
# Particle-steps per second of the discrete element engine, as "triax THREADS PARTICLE_STEPS_PER_S", and those of
# yade and LAMMPS where they are installed and FOLDER holds run_yade.sh and run_lammps.sh, which take
# "NUMBER_OF_GRAINS THREADS" and print such lines. Then the ratios, and one thread and two beside none, one and two busy
# processes that the program starts itself, as "shared BUSY ONE TWO RATIO LEAST MOST".
# FILE (or $TRIAX_GRAINS_STATE): "N lox hix loy hiy loz hiz", then "x y z r" a grain, in metres; without it a specimen of
# 10,000 grains is made and compressed to 100 kPa first (a minute or two).
set -euo pipefail
state=${TRIAX_GRAINS_STATE:-} peers= threads="1 2" steps=3000
while (($#)); do
  case $1 in
    --state) state=$2 ;;
    --peers) peers=$2 ;;
    --jobs) threads=$2 ;;
    --steps) steps=$2 ;;
    *) echo "run.sh: unknown option $1" >&2; exit 2 ;;
  esac
  shift 2
done
[[ -z $state ]] || state=$(realpath -e "$state")
[[ -z $peers ]] || peers=$(realpath -e "$peers")
cd "$(dirname "$0")/../.."
tools/build release bench_grains_speed >/dev/null
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
if [[ $state == *.gz ]]; then
  gunzip -c "$state" >"$scratch/state.txt"
  state=$scratch/state.txt
elif [[ -z $state ]]; then
  state=$scratch/state.txt
  build/release/bench/bench_grains_speed make "$state"
fi
grains=$(head -n 1 "$state" | cut -d ' ' -f 1)
echo "# $grains grains, load $(cut -d ' ' -f 1 /proc/loadavg)"
for t in $threads; do
  build/release/bench/bench_grains_speed "$state" "$t" "$steps" 5
  [[ -n $peers ]] || continue
  ! command -v yade >/dev/null || "$peers/run_yade.sh" "$grains" "$t"
  ! command -v lmp >/dev/null || "$peers/run_lammps.sh" "$grains" "$t"
done | tee "$scratch/rates.txt"
awk '/^#/ {next} {rate[$1, $2] = $3; if ($1 != "triax") peer[$1, $2] = $1; if ($1 == "triax") own[$2] = $3}
  END {
    for (key in peer) {split(key, k, SUBSEP); if (k[2] in own) printf "# triax over %s, %d: %.2f\n", k[1], k[2], own[k[2]] / rate[key]}
    if (1 in own && 2 in own) printf "# two threads over one: %.2f\n", own[2] / own[1]
  }' "$scratch/rates.txt"
build/release/bench/bench_grains_speed shared "$state"
