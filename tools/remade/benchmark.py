# SPDX-License-Identifier: GPL-3.0-or-later
"""The output of a benchmark, as one run printed it, kept on a page with what it ran on.

Times differ from run to run, so a check does not ask for equal figures. It runs the benchmark with --labels, which measures nothing and
prints # for what the clock says: all else is what the page has. Where nothing depends on the clock but the whole takes minutes, a check
runs a sample, whose digest stands beside the table. Neither lets a figure be changed by hand: the digest of what was printed stands there.
"""
import datetime
import hashlib
import os
import re
import shlex
import subprocess
import sys

from remade.program import ROOT, Triax

NUMBER = r"[-+]?[\d.]+(?:e[-+]?\d+)?"


def digest(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def machine() -> str:
    with open("/proc/cpuinfo", encoding="utf-8") as cpus:
        kinds = re.findall(r"^model name\s*:\s*(.+)$", cpus.read(), re.M)
    return f"{kinds[0].strip() if kinds else 'unknown processor'}, {len(os.sched_getaffinity(0))} cores"


def run_now(command: str) -> str:
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.strip()
    day = datetime.date.today()
    load = f"load {os.getloadavg()[0]:.1f} before it{', raised priority' if os.nice(0) < 0 else ''}"
    told = f"`{command}`, {day.day} {day:%B %Y}, commit {commit}, {machine()}, {load}:"
    printed = Triax.output_of(*shlex.split(command))
    return f"{told}\n\n{printed}\n<!-- as printed: {digest(printed)} -->"


def printed_part(kept: str) -> str:
    """What the benchmark printed, of a block; nothing where somebody changed it since."""
    whole = re.fullmatch(r"`.*?:\n\n(.*)\n<!-- as printed: (\w+) -->(?:\n<!-- sample .*? -->)?", kept, re.S)
    return whole[1] if whole and digest(whole[1]) == whole[2] else ""


def agrees(label: str, line: str) -> bool:
    words = re.split(r"(#)", " ".join(label.split()))
    return re.fullmatch("".join(NUMBER if w == "#" else re.escape(w) for w in words), " ".join(line.split())) is not None


def timed(triax, command: str) -> str:
    """A benchmark whose figures depend on the clock."""
    if not triax.checking:
        if os.getloadavg()[0] > 0.5:
            sys.stderr.write(f"{command}: the machine does something else (load {os.getloadavg()[0]:.1f}): its times will say little\n")
        return run_now(command)
    labels = triax.output_of(*shlex.split(command), "--labels")
    lines = printed_part(triax.standing).split("\n")
    if len(lines) == len(labels.split("\n")) and all(map(agrees, labels.split("\n"), lines)):
        return triax.standing
    return f"as `{command} --labels` prints it, and by no other hand:\n\n{labels}"


def sampled(triax, command: str, sample: str) -> str:
    """A benchmark that prints the same on any machine, but takes minutes; `sample` takes seconds."""
    if not triax.checking:
        return f"{run_now(command)}\n<!-- sample `{sample}`: {digest(triax.output_of(*shlex.split(sample)))} -->"
    found = digest(triax.output_of(*shlex.split(sample)))
    if printed_part(triax.standing) and triax.standing.endswith(f"\n<!-- sample `{sample}`: {found} -->"):
        return triax.standing
    return f"{triax.standing}\n`{sample}` prints something else ({found}), or a hand changed this: `tools/pages` makes the table anew"
