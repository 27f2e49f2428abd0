# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of docs/reference/benchmarks.md (tools/pages): what the benchmarks print. Minutes each, on a machine that does nothing else."""
from remade.benchmark import sampled, timed


def replay(triax) -> str:
    return timed(triax, "bench/replay/run.sh")


def xlsx(triax) -> str:
    return timed(triax, "bench/xlsx/run.sh")


def verdicts(triax) -> str:
    return sampled(triax, "bench/verdicts/run.sh --seeds 6", "bench/verdicts/run.sh --seeds 1 --every 12")


def verdicts_unseen(triax) -> str:
    return sampled(triax, "bench/verdicts/run.sh --from 11 --seeds 2", "bench/verdicts/run.sh --from 11 --seeds 1 --every 20")


def detection(triax) -> str:
    return sampled(triax, "bench/detection/run.sh", "bench/detection/run.sh --seeds 1 --only ICU")


def warning(triax) -> str:
    return sampled(triax, "bench/warning/run.sh", "bench/warning/run.sh --seeds 1 --only ICU")


def point(triax) -> str:
    return timed(triax, "bench/point/run.sh")


def stability(triax) -> str:
    return timed(triax, "bench/stability/run.sh")


def apparatus(triax) -> str:
    return timed(triax, "bench/apparatus/run.sh")


def wire(triax) -> str:
    """On an otherwise quiet machine: it measures milliseconds."""
    return timed(triax, "bench/wire/run.sh")


def page(triax) -> str:
    """On an otherwise quiet machine, with chromium: it measures milliseconds. An hour and a quarter."""
    return timed(triax, "bench/page/run.sh")


def grains(triax) -> str:
    """On a packing that it makes itself; beside busy processes of its own, too."""
    return triax.output_of("bench/grains/run.sh")
