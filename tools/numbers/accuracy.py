# SPDX-License-Identifier: GPL-3.0-or-later
"""Blocks of bench/results/accuracy.md (tools/pages): output of the benchmarks of accuracy. Minutes each."""
from remade.benchmark import sampled


def intake(triax) -> str:
    shown = "--by kind --by language --by headings --by unit_style --by clock --by separator --by order --by blocks --by names"
    return sampled(triax, f"bench/intake/run.sh --seed 70000 --count 20000 {shown}", "bench/intake/run.sh --seed 1 --count 60 --by kind")


def verdicts(triax) -> str:
    return sampled(triax, "bench/verdicts/run.sh --seeds 6", "bench/verdicts/run.sh --seeds 1 --every 12")


def verdicts_unseen(triax) -> str:
    return sampled(triax, "bench/verdicts/run.sh --from 11 --seeds 2", "bench/verdicts/run.sh --from 11 --seeds 1 --every 20")


def detection(triax) -> str:
    return sampled(triax, "bench/detection/run.sh", "bench/detection/run.sh --seeds 1 --only ICU")
