#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/warning/figures.sh FOLDER [OPTIONS of bench_warning]: the worst failures of the alarm as figures. Runs the trials as run.sh does
# and leaves in FOLDER, of the five worst of each kind, the record (KIND-PLACE.csv) and the forecast beside what was measured and the
# truth (KIND-PLACE_alarm.svg).
set -euo pipefail
cd "$(dirname "$0")/../.."
folder=$(realpath -m "${1:?bench/warning/figures.sh needs a folder}")
mkdir -p "$folder"
tools/build release triax bench_warning >/dev/null
build/release/bench/bench_warning --seeds 46 --from 101 "${@:2}" --worst "$folder" || { status=$?; ((status == 1)) || exit "$status"; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for record in "$folder"/*-[1-5].csv; do
  name=$(basename "$record" .csv)
  build/release/triax replay "$record" --db "$work/$name.db" >/dev/null
  build/release/triax report --db "$work/$name.db" --figures "$work/$name" >/dev/null 2>&1
  cp "$work/$name"/*_alarm.svg "$folder/${name}_alarm.svg"
done
