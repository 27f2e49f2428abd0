# SPDX-License-Identifier: GPL-3.0-or-later
"""A test with more readings than a sheet has rows is refused in one line, and nothing is written of it or of the tests beside it."""
import tempfile
from pathlib import Path

from workbooks import REDUCED, expect, triax

with tempfile.TemporaryDirectory() as made:
    folder = Path(made)
    with open(folder / "long.csv", "w") as file:
        file.write(REDUCED[0] + "\n")
        file.writelines(f"{i * 1e-7:.7f},{i % 977 * 0.05:.2f},{100 + i % 13}\n" for i in range(1_048_570))
    (folder / "short.csv").write_text("\n".join(REDUCED) + "\n")
    for record in ("short.csv", "long.csv"):
        expect(triax(folder, "replay", record).returncode, 0, record)
    (folder / "out").mkdir()
    ended = triax(folder, "export", "--format", "xlsx", "--output", "out")
    expect(ended.returncode, 2, ended.stderr)
    expect(ended.stderr.count("\n"), 1, ended.stderr)
    expect("at most 1048576 rows" in ended.stderr, True, ended.stderr)
    expect(list((folder / "out").iterdir()), [], "files")
