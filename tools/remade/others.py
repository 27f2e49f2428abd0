# SPDX-License-Identifier: GPL-3.0-or-later
"""Blocks of pages that rest on records of others, which are not ours to copy: TRIAX_RECORDS_OF_OTHERS names their folder."""
import os
import pathlib
import re
import sys

from remade.benchmark import digest


def of_others(triax, page: str, made) -> str:
    """What `made` says of the records; where they are missing, what stands on the page unless somebody changed it."""
    folder = os.environ.get("TRIAX_RECORDS_OF_OTHERS")
    if folder:
        body = made(triax, pathlib.Path(folder))
        return f"{body}\n<!-- as printed: {digest(body)} -->"
    kept = re.fullmatch(r"(.*)\n<!-- as printed: (\w+) -->", triax.standing, re.S)
    if kept and digest(kept[1]) == kept[2]:
        sys.stderr.write(f"{page}: TRIAX_RECORDS_OF_OTHERS names no folder: the block of recorded tests is taken as it stands\n")
        return triax.standing
    return f"somebody changed what stood here; with TRIAX_RECORDS_OF_OTHERS `tools/pages {page}` makes it anew"
