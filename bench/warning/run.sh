#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench/warning/run.sh [OPTIONS of bench_warning]: what is said of an onset before it comes, over simulated tests with
# instruments from good to cheap and readings from dense to sparse. Prints; no bound is asked yet.
set -euo pipefail
cd "$(dirname "$0")/../.."
tools/build release bench_warning >/dev/null
build/release/bench/bench_warning "$@"
