#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Renews the golden texts from the built program; look at the difference before you commit it.
set -euo pipefail
cd "$(dirname "$0")/../.."
triax=${1:-build/release/triax}
triax=$(realpath "$triax")
golden=tests/cli/golden
mkdir -p "$golden"
"$triax" --help >"$golden/help.txt"
for command in simulate replay report query tests element materials probe domain grains serve run record rig open calibrate soil export about; do "$triax" "$command" --help >"$golden/help_$command.txt"; done
"$triax" query --list >"$golden/query_list.txt"
# A lost control is status 1 by contract.
for path in icu_100 load_beyond_limit; do
  "$triax" element "samples/paths/$path.toml" >"$golden/element_$path.txt" 2>"$golden/element_$path.err" || true
done
"$triax" probe --material inl2/S28-general --p-kPa 70 --eta 0.5,0.6,0.7 --void-ratio 1.086 >"$golden/probe_etas.txt"
"$triax" probe --material inl2/S28-general --p-kPa 70 --eta 0.6 --void-ratio 1.086 --probes >"$golden/probe_directions.txt"
"$triax" probe --path samples/paths/icu_100.toml --every 25 >"$golden/probe_path.txt"
"$triax" domain --material inl2/S28-general --void-ratio 1.086 --p-kPa 20:200/7 --q-kPa -120:240/19 \
  >"$golden/domain_inl2.txt"

# Lines "$ triax ..." of the session stay; what the program answers is written anew below each.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp samples/records/icu_6.csv "$work"
printf 'axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa\n0,0,100\n0.1,5,101\n0.2,9,103\n' >"$work/tiny.csv"
(
  cd "$work"
  for record in icu_6.csv tiny.csv "icu_6.csv --set test.name=again"; do "$triax" replay $record >replayed.txt; done
)
grep '^\$ triax ' "$golden/tests_session.txt" | while read -r line; do
  printf '%s\n' "$line"
  status=0
  (cd "$work" && eval "\"$triax\" ${line#\$ triax }" </dev/null 2>&1) || status=$?
  if [ "$status" -ne 0 ]; then echo "[status $status]"; fi
done | sed -E 's/[0-9]{4}-[0-9]{2}-[0-9]{2}([ T])[0-9]{2}:[0-9]{2}/YYYY-MM-DD\1HH:MM/; s/HH:MM:[0-9]{2}Z/HH:MM:SSZ/' >"$work/session.txt"
cp "$work/session.txt" "$golden/tests_session.txt"
scratch=$(mktemp -d)
cp samples/records/results.ags "$scratch"
program=$(realpath "$triax")
(cd "$scratch" && "$program" replay results.ags) >"$golden/replay_ags4.txt"
rm -r "$scratch"
