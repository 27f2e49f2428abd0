# SPDX-License-Identifier: GPL-3.0-or-later
"""Blocks of bench/results/grain-engine.md (tools/pages): output of the benchmark of the grain engine. Minutes."""


def grains(triax) -> str:
    """On a packing that it makes itself; beside busy processes of its own, too."""
    return triax.output_of("bench/grains/run.sh")
