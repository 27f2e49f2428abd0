# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of README.md (tools/pages)."""
from remade.program import indented


def replay(triax) -> str:
    """The table of one test: its heading of three lines and its row."""
    return indented("\n".join(triax.run("replay", "samples/records/icu_6.csv").split("\n")[:4]))
