#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/grains/lammps_path.sh [--packing FILE[.gz]] [--kind strain_path|drained|isotropic] [--ratio R] [--strain E]
#                             [--rate RATE] [--bins N] [--ranks N] [--output PREFIX]
# The same path here and in LAMMPS under MPI, from one state at 100 kPa: settles the packing, writes the path for LAMMPS,
# follows it in both, and prints q, p and s1 - s3/R (kPa) at equal strains: "triax" as it is, "bare" from a state that
# lost its tangential forces and came to rest again as LAMMPS has to, and "lammps"; then the largest differences from triax.
# FILE: "N lox hix loy hiy loz hiz", then "x y z r" a grain, in metres; without it a specimen of 1,000 grains is made.
# PREFIX keeps the files (PREFIX.lammps.in, .lammps.data, .lammps.csv, .triax.csv, .bare.csv).
set -euo pipefail
packing= kind=strain_path ratio=1 strain=0.01 rate=0.2 bins=12 ranks=2 output=
while (($#)); do
  case $1 in
    --packing) packing=$(realpath -e "$2") ;;
    --kind) kind=$2 ;;
    --ratio) ratio=$2 ;;
    --strain) strain=$2 ;;
    --rate) rate=$2 ;;
    --bins) bins=$2 ;;
    --ranks) ranks=$2 ;;
    --output) output=$(realpath "$2") ;;
    *) echo "lammps_path.sh: unknown option $1" >&2; exit 2 ;;
  esac
  shift 2
done
for tool in lmp mpirun; do
  command -v $tool >/dev/null || { echo "lammps_path.sh: $tool is not installed (packages lammps, openmpi-bin)" >&2; exit 1; }
done
cd "$(dirname "$0")/../.."
tools/build release bench_lammps_path bench_grains_speed >/dev/null
bin=$PWD/build/release/bench
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
if [[ $packing == *.gz ]]; then
  gunzip -c "$packing" >"$scratch/packing.txt"
  packing=$scratch/packing.txt
elif [[ -z $packing ]]; then
  packing=$scratch/packing.txt
  "$bin/bench_grains_speed" make "$packing" 1000
fi
prefix=${output:-$scratch/path}
"$bin/bench_lammps_path" "$kind" "$packing" "$prefix" "$ratio" "$strain" "$rate" "$bins"
as_root=()
[[ $(id -u) -ne 0 ]] || as_root=(--allow-run-as-root)
start=$SECONDS
(cd "$(dirname "$prefix")" && OMP_NUM_THREADS=1 mpirun "${as_root[@]}" --oversubscribe -n "$ranks" \
  lmp -in "$(basename "$prefix").lammps.in" -log none >"$prefix.lammps.out" 2>&1) ||
  { tail -n 5 "$prefix.lammps.out" >&2; exit 1; }
echo "# LAMMPS on $ranks ranks: $((SECONDS - start)) s; $(grep -h '^rest:' "$prefix.lammps.out"); $(grep -h '^end:' "$prefix.lammps.out")"
# Rows of the three tables at twenty equal strains (isotropic: at equal pressures), in between by lines.
awk -F, -v by="$([[ $kind == isotropic ]] && echo p_kPa || echo axial_strain)" '
  FNR == 1 {file++; for (k = 1; k <= NF; k++) column[file, $k] = k; rows[file] = 0; next}
  {n = ++rows[file]; for (k = 1; k <= NF; k++) value[file, n, k] = $k}
  function at(file, x, name,   i, b, c, w) {
    b = column[file, by]; c = column[file, name]
    for (i = 2; i <= rows[file]; i++)
      if ((value[file, i, b] - x) * (value[file, i - 1, b] - x) <= 0 && value[file, i, b] != value[file, i - 1, b]) {
        w = (x - value[file, i - 1, b]) / (value[file, i, b] - value[file, i - 1, b])
        return value[file, i - 1, c] + w * (value[file, i, c] - value[file, i - 1, c])
      }
    return "-"
  }
  END {
    names = by == "p_kPa" ? "volumetric_strain" : "q_kPa p_kPa path_stress_kPa volumetric_strain"
    many = split(names, name, " ")
    printf "%12s", by
    for (m = 1; m <= many; m++) printf "  %s: triax bare lammps", name[m]
    print ""
    first = value[1, 1, column[1, by]]; last = value[1, rows[1], column[1, by]]
    for (s = 1; s <= 20; s++) {
      x = first + (last - first) * s / 20 * 0.9999
      printf "%12.6g", x
      for (m = 1; m <= many; m++) {
        for (f = 1; f <= 3; f++) {v[f] = at(f, x, name[m]); printf v[f] == "-" ? "  %9s" : "  %9.5g", v[f]}
        for (f = 2; f <= 3; f++) if (v[f] != "-" && v[1] != "-") {
          d = v[f] - v[1]; if (d < 0) d = -d
          if (d > most[f, m]) most[f, m] = d
        }
      }
      print ""
    }
    for (m = 1; m <= many; m++) printf "# %s: largest difference from triax: bare %.4g, lammps %.4g\n", name[m], most[2, m], most[3, m]
  }' "$prefix.triax.csv" "$prefix.bare.csv" "$prefix.lammps.csv"
