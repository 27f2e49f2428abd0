# SPDX-License-Identifier: GPL-3.0-or-later
"""The program, as pages run it."""
import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def page_file(page: str) -> pathlib.Path:
    """README, or the page of that name in any folder of docs/ or in bench/results/: names are unique."""
    if page == "README":
        return ROOT / "README.md"
    found = sorted(path for folder in ("docs", "bench/results") for path in (ROOT / folder).rglob(f"{page}.md"))
    if len(found) != 1:
        sys.exit(f"{page}: docs/ and bench/results/ have {len(found)} pages of that name")
    return found[0]


def indented(text: str) -> str:
    return "\n".join(f"    {line}".rstrip() for line in text.strip("\n").split("\n"))


class Triax:
    """triax in a folder of its own, which is gone afterwards and has the samples in it; what was run once is not run again."""

    def __init__(self, folder: str, checking: bool = False):
        self.folder = pathlib.Path(folder)
        self.checking = checking
        self.standing = ""  # of the block that is made: what the page has
        self.program = os.path.abspath(os.environ.get("TRIAX", ROOT / "build/release/triax"))
        self.told: dict[tuple[str, ...], str] = {}
        (self.folder / "samples").symlink_to(ROOT / "samples")
        (self.folder / ".bin").mkdir()
        (self.folder / ".bin/triax").symlink_to(self.program)

    def shell(self, command: str, timeout_s: float | None = None) -> subprocess.CompletedProcess:
        """Runs a command as a reader types it; errors are in its output. Raises subprocess.TimeoutExpired."""
        environment = {**os.environ, "PATH": f"{self.folder}/.bin:{os.environ['PATH']}"}
        environment.pop("COLUMNS", None)
        return subprocess.run(["bash", "-c", command], cwd=self.folder, env=environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, timeout=timeout_s)

    def run(self, *arguments: str, may_fail: bool = False) -> str:
        if arguments not in self.told:
            done = subprocess.run([self.program, *arguments], cwd=self.folder, capture_output=True, text=True, check=False)
            if done.returncode not in ((0, 1) if may_fail else (0,)):
                sys.exit(f"triax {' '.join(arguments)}: status {done.returncode}\n{done.stderr}")
            self.told[arguments] = done.stdout
        return self.told[arguments]

    def documents(self, *arguments: str, may_fail: bool = False) -> list[dict]:
        """The JSON of a command: of several probed states, or several tests, one document each."""
        told = json.loads(self.run(*arguments, "--json", may_fail=may_fail))
        if isinstance(told, list):
            return told
        return told["states"] if "probing" in told and "states" in told else [told]

    def query(self, sql: str, *arguments: str) -> list[dict]:
        return json.loads(self.run("query", sql, "--format", "json", *arguments))

    @staticmethod
    def output_of(*command: str) -> str:
        """What a command of the tree prints, as a block of Markdown. A bound that is broken is told and ends nothing."""
        done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
        if done.returncode not in (0, 1):  # stopped, or not begun: what there is of it belongs on no page
            sys.exit(f"{' '.join(command)}: status {done.returncode}\n{done.stderr}")
        if done.returncode != 0:
            sys.stderr.write(f"{' '.join(command)}: status {done.returncode}\n{done.stderr}")
        return indented(done.stdout)

    @staticmethod
    def sample(name: str) -> str:
        return str(ROOT / "samples" / name)
