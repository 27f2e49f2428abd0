# SPDX-License-Identifier: GPL-3.0-or-later
"""Blocks of bench/results/alarm.md (tools/pages): output of the benchmark of the alarm. Minutes."""
from remade.benchmark import sampled


def warning(triax) -> str:
    return sampled(triax, "bench/warning/run.sh", "bench/warning/run.sh --seeds 1 --only ICU")
