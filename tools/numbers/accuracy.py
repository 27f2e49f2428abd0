# SPDX-License-Identifier: GPL-3.0-or-later
"""Blocks of bench/results/accuracy.md (tools/pages): output of the benchmarks of accuracy. Minutes each."""
from remade.benchmark import sampled


def verdicts(triax) -> str:
    return sampled(triax, "bench/verdicts/run.sh --seeds 6", "bench/verdicts/run.sh --seeds 1 --every 12")


def verdicts_unseen(triax) -> str:
    return sampled(triax, "bench/verdicts/run.sh --from 11 --seeds 2", "bench/verdicts/run.sh --from 11 --seeds 1 --every 20")


def detection(triax) -> str:
    return sampled(triax, "bench/detection/run.sh", "bench/detection/run.sh --seeds 1 --only ICU")
