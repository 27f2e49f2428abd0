# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of docs/benchmarks.md (tools/pages): what the benchmarks print. Minutes each, on a machine that does nothing else."""


def replay(triax) -> str:
    return triax.output_of("bench/replay/run.sh")


def verdicts(triax) -> str:
    return triax.output_of("bench/verdicts/run.sh", "--seeds", "6")


def detection(triax) -> str:
    return triax.output_of("bench/detection/run.sh")


def point(triax) -> str:
    """The first of the two tables; the second is the diagram below it."""
    return triax.output_of("bash", "-c", "bench/point/run.sh | grep -v '^#'")


def grains(triax) -> str:
    """On a packing that it makes itself; beside busy processes of its own, too."""
    return triax.output_of("bench/grains/run.sh")
