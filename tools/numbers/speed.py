# SPDX-License-Identifier: GPL-3.0-or-later
"""Blocks of bench/results/speed.md (tools/pages): output of the benchmarks of speed. Minutes each, on an idle machine."""
from remade.benchmark import timed


def replay(triax) -> str:
    return timed(triax, "bench/replay/run.sh")


def xlsx(triax) -> str:
    return timed(triax, "bench/xlsx/run.sh")


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
