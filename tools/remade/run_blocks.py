# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the blocks of commands of a page, as a reader pastes them: in order, in one folder that is empty but for the samples.

`triax open` and `triax serve` run until the end of the page, as in another terminal. A block that cannot run here stands with its reason
in not_run.toml, by its first line ("*": all of the page).
"""
import os
import re
import signal
import subprocess
import tomllib

from remade.program import ROOT, Triax
from remade.transcript import expected_status
from remade.unchecked import FENCED, INDENTED, first_line, only_commands

NOT_RUN = ROOT / "tools/remade/not_run.toml"
TIME_LIMIT_S = 240
# In front of the program: servers go to the background, and have to be alive after a second.
WRAPPER = """#!/bin/bash
case "$1" in
open|serve)
  for word in "$@"; do [ "$word" != --help ] || exec {program} "$@"; done
  setsid {program} "$@" >server.out 2>&1 </dev/null &
  echo $! >>servers
  sleep 2
  kill -0 $! || {{ cat server.out; exit 1; }} ;;
*) exec {program} "$@" ;;
esac
"""


def blocks_of(text: str, generated: re.Pattern) -> list[str]:
    """The blocks of commands in their order; of transcripts only the commands."""
    def commands(match: re.Match) -> str:
        if match["kind"] == "numbers":
            return ""
        lines = re.sub(r"\\\n", "\\\\", match["body"]).split("\n")
        return "\n\n" + "\n".join(line.replace("\\", "\\\n") for line in lines if line.startswith("    $ ")) + "\n\n"

    text = generated.sub(commands, text)
    found = [(m.start(), m["body"]) for m in FENCED.finditer(text)]
    found += [(m.start(), m["body"]) for m in INDENTED.finditer(FENCED.sub(lambda m: re.sub(r"[^\n]", "x", m.group()), text))]
    return [re.sub(r"^ {4}", "", body, flags=re.M).strip("\n") for _, body in sorted(found) if only_commands(body)]


def stop_servers(triax: Triax) -> None:
    servers = triax.folder / "servers"
    for server in servers.read_text(encoding="utf-8").split() if servers.exists() else []:
        try:
            os.killpg(int(server), signal.SIGKILL)
        except ProcessLookupError:
            pass


def run_block(block: str, triax: Triax) -> str | None:
    """What went wrong."""
    script = re.sub(r"^\$ ", "", block, flags=re.M)
    try:
        done = triax.shell(f"set -e\n{script}", TIME_LIMIT_S)
    except subprocess.TimeoutExpired:
        return f"still running after {TIME_LIMIT_S} s: {first_line(block)}"
    if done.returncode != expected_status(script):
        return f"exit status {done.returncode}, not {expected_status(script)}: {block}\n{done.stdout[-1000:]}"
    return None


def run_page(page: str, text: str, triax: Triax, generated: re.Pattern) -> list[str]:
    """What went wrong, one text for each block."""
    reasons = tomllib.loads(NOT_RUN.read_text(encoding="utf-8")).get(page, {})
    if "*" in reasons:
        return []
    program = triax.folder / ".bin/triax"
    program.unlink()
    program.write_text(WRAPPER.format(program=triax.program), encoding="utf-8")
    program.chmod(0o755)
    try:
        wrong = [run_block(block, triax) for block in blocks_of(text, generated) if not reasons.pop(first_line(block), None)]
    finally:
        stop_servers(triax)
    wrong += [f"not_run.toml lists a block that the page does not have: {key}" for key in reasons]
    return [f"{page}: {one}" for one in wrong if one]
