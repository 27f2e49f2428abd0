# SPDX-License-Identifier: GPL-3.0-or-later
"""Blocks of docs/reference/benchmarks.md (tools/pages): lines of the pages in bench/results. No benchmark is run."""
import re
import sys

from remade.program import page_file


def part(page: str, start: str) -> str:
    """The text of a page from the line `start` to the end of its block or section."""
    match = re.search(rf"^{re.escape(start)}\n(.*?)(?=^## |^<!-- end of|\Z)", page_file(page).read_text(encoding="utf-8"), re.M | re.S)
    if not match:
        sys.exit(f"{page}: there is no line {start}")
    return match[1]


def lines(text: str, *patterns: str) -> str:
    """The printed lines that begin with one of the patterns. A heading, which has no decimals, is not repeated."""
    kept: list[str] = []
    for line in text.split("\n"):
        wanted = line.startswith("    ") and re.match("|".join(patterns), " ".join(line.split()))
        if wanted and (line not in kept or re.search(r"\d\.\d", line)):
            kept.append(line)
    return "\n".join(kept) or sys.exit(f"benchmarks: no line begins with {patterns}")


def latest(page: str, name: str, *patterns: str) -> str:
    """The lines of a block, after its command, date and commit."""
    block = part(page, f"<!-- numbers: {name} -->")
    return re.match(r".*, commit \w+", block)[0] + ":\n\n" + lines(block, *patterns)


def intake(triax) -> str:
    return latest("accuracy", "intake", "trait", "all")


def replay(triax) -> str:
    return latest("speed", "replay", "sqlite3", "triax replay", "ratio", "peak memory")


def xlsx(triax) -> str:
    return latest("speed", "xlsx", "xlsx", "ratio")


def point(triax) -> str:
    return latest("speed", "point", "law", "hypoplastic/S28", "sanisand")


def stability(triax) -> str:
    return latest("speed", "stability", "law", "sanisand/S28-general plane", "domain of")


def apparatus(triax) -> str:
    return latest("speed", "apparatus", "seconds", "rig, reduction", "resident memory", "24 h", "72 h", "with it")


def wire(triax) -> str:
    return latest("speed", "wire", "ours", "asio-echo", "python", "a scan of all .* 1000 idle", "ten a second", "1,000 idle")


def page(triax) -> str:
    return latest("speed", "page", "start", r"10\^6", "10 readings/s, 10 browsers")


def verdicts_unseen(triax) -> str:
    return latest("accuracy", "verdicts_unseen", "trait", "all", "(NOT )?held")


def detection(triax) -> str:
    return latest("accuracy", "detection", "detected", "method", r"(triax|maximum of q|sign over .*) all", "all bounds")


def kinds(triax) -> str:
    return lines(part("accuracy", "## Onsets that are difficult to locate"), r"\|error", "kind", r"standard instruments \d", "12 bits, 0.5", "cycles")


def warning(triax) -> str:
    """Limits that the alarm does not hold, and the guard: rows of eight columns."""
    return latest("alarm", "warning", "The alarm", "NOT held", "The guard", "by force tests", "caught", r"all( \S+){8}$")


def grains(triax) -> str:
    return lines(part("grain-engine", "## Speed"), "particle-steps", r"(triax|yade|LAMMPS) .*\d M", r"triax \d \d")


def grains_yade(triax) -> str:
    return lines(part("grain-engine", "## Comparison with yade"), "yade triax$", "porosity", "peak", r"η, ε_v \(%\) at 4")


def grains_lammps(triax) -> str:
    return lines(part("grain-engine", "## Comparison with LAMMPS"), "path", "10,000 medium, R", r"0\.5 %")
