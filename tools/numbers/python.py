# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples of docs/how-to/python.md with what they print, and the benchmark. The module must be built: triax_python."""
import os
import subprocess
import sys

from remade.benchmark import timed
from remade.program import ROOT, indented


def example(triax, name: str) -> str:
    """The code of samples/python/NAME.py behind its licence line, and its output in an empty folder."""
    script = ROOT / f"samples/python/{name}.py"
    surroundings = {**os.environ, "PYTHONPATH": str(ROOT / "build/release/python"), "PYTHONDONTWRITEBYTECODE": "1"}
    done = subprocess.run(["/usr/bin/python3", str(script)], cwd=triax.folder, env=surroundings, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{script.name}: status {done.returncode}\n{done.stderr}")
    code = script.read_text(encoding="utf-8").split("\n", 2)[2]
    return f"```python\n{code.strip()}\n```\n\n{indented(done.stdout)}"


def curves(triax) -> str:
    return example(triax, "curves")


def laws(triax) -> str:
    return example(triax, "laws")


def calibration(triax) -> str:
    return example(triax, "calibrate")


def speed(triax) -> str:
    return timed(triax, "bench/python/run.sh")
