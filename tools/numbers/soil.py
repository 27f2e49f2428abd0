# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of docs/how-to/soil.md (tools/pages): what the benchmark prints, and what the program says of the Karlsruhe tests."""
import os
import pathlib
import subprocess

from remade.benchmark import sampled
from remade.others import of_others

# Void ratio of the one undrained test that does not have it in its file; those of the others were not found.
VOID_RATIOS = {"TMU1": "0.828"}


def campaigns(triax) -> str:
    return sampled(triax, "bench/soil/run.sh", "bench/soil/run.sh --campaigns 12 --spoilt 4")


def all_of_them(triax, folder: pathlib.Path) -> str:
    surroundings = {name: value for name, value in os.environ.items() if name != "COLUMNS"}

    def said(*arguments: str) -> str:
        return subprocess.run([triax.program, *arguments, "--db", "karlsruhe.db"], cwd=triax.folder, env=surroundings, capture_output=True,
                              text=True, check=True).stdout

    for record in sorted((folder / "kfs").glob("*.dat")):
        void_ratio = VOID_RATIOS.get(record.stem)
        said("replay", str(record), "--set", "specimen.material=Karlsruhe fine sand",
             *(["--set", f"specimen.consolidated_void_ratio={void_ratio}"] if void_ratio else []))
    values = said("soil").split("\n\n  Test ")[0]
    return "\n".join(f"    {line}".rstrip() for line in values.splitlines())


def karlsruhe(triax) -> str:
    return of_others(triax, "soil", all_of_them)
