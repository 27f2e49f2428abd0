# SPDX-License-Identifier: GPL-3.0-or-later
"""One trial: a folder of its own, the program in it, chance, and what must hold."""
import collections
import dataclasses
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import time

MOST_SECONDS, MOST_MEGABYTES = 60, 1500


class Broken(Exception):
    """What must hold did not."""


@dataclasses.dataclass
class Done:
    """A program that ended; `status` is below 0 where a signal ended it."""
    status: int
    out: bytes
    err: str
    seconds: float
    megabytes: float


class Running:
    """The program, started in a folder."""

    def __init__(self, command: list[str], folder: pathlib.Path, number: int):
        self.command, self.begin = command, time.monotonic()
        self.out, self.err = folder / f".out-{number}", folder / f".err-{number}"
        with open(self.out, "wb") as out, open(self.err, "wb") as err:
            self.process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=out, stderr=err,
                                            env={**os.environ, "COLUMNS": "80", "TERM": "dumb"})
        self.ended = None
        self.expected_s = 0.0

    def poll(self):
        """What it ended as; None while it runs."""
        if self.ended is None:
            pid, status, usage = os.wait4(self.process.pid, os.WNOHANG)
            if pid != 0:
                self.process.returncode = os.waitstatus_to_exitcode(status)
                self.ended = Done(self.process.returncode, self.out.read_bytes(), self.err.read_text(errors="replace"),
                                  time.monotonic() - self.begin, usage.ru_maxrss / 1024)
        return self.ended

    def wait(self, seconds=MOST_SECONDS):
        """Until it ends; one that does not is killed, and the property is broken."""
        end = time.monotonic() + seconds
        while self.poll() is None:
            if time.monotonic() > end:
                self.send(signal.SIGKILL)
                while self.poll() is None:
                    time.sleep(0.01)
                raise Broken(f"did not end within {seconds} s")
            time.sleep(0.002)
        return self.ended

    def send(self, number):
        if self.ended is None:
            os.kill(self.process.pid, number)


class Trial:
    """`chance` is seeded: the same trial makes the same choices. `counts` are of the kind of trial, over all of them."""

    def __init__(self, program: str, folder: pathlib.Path, chance: random.Random, counts: collections.Counter, undisturbed: dict,
                 hold_s: float = 0, wanted: str = ""):
        self.program, self.folder, self.chance, self.counts = program, folder, chance, counts
        self.undisturbed, self.hold_s, self.wanted = undisturbed, hold_s, wanted
        self.db = "t.db"
        self.part = ""
        self.told: list[str] = []

    def choose(self, parts) -> str:
        """What it disturbs, a line of the table."""
        self.part = self.chance.choice(parts)
        if self.wanted:
            self.must(self.wanted in parts, f"there is no {self.wanted} in it, but {', '.join(parts)}")
            self.part = self.wanted
        return self.part

    @property
    def database(self) -> pathlib.Path:
        return self.folder / self.db

    def start(self, *arguments, folder=None) -> Running:
        command = [self.program, *map(str, arguments)]
        self.told.append(" ".join(command))
        return Running(command, folder or self.folder, len(self.told))

    def triax(self, *arguments, seconds=MOST_SECONDS) -> Done:
        """Runs the program to its end. Whatever it is given: no crash, bounded time and memory."""
        done = self.start(*arguments).wait(seconds)
        self.must(done.status in (0, 1, 2), f"ended by {name_of(done.status)}: {self.told[-1]}\n{done.err[-500:]}")
        self.must(done.megabytes < MOST_MEGABYTES, f"took {done.megabytes:.0f} MB: {self.told[-1]}")
        return done

    @staticmethod
    def must(holds, otherwise: str):
        if not holds:
            raise Broken(otherwise)

    def count(self, what: str):
        self.counts[what] += 1

    def document(self, done: Done):
        """What it printed as JSON: whole, in UTF-8, every number finite."""
        try:
            return json.loads(done.out.decode("utf-8"), parse_constant=not_a_number)
        except (ValueError, UnicodeDecodeError) as error:
            raise Broken(f"JSON of {self.told[-1]}: {error}") from error

    def wait_while(self, running: Running, seconds: float):
        """So long, or until it ends."""
        end = time.monotonic() + seconds
        while running.poll() is None and time.monotonic() < end:
            time.sleep(min(0.002, max(0.0, end - time.monotonic())))

    def files(self) -> dict[str, bytes]:
        """All but what the program printed."""
        return {str(p.relative_to(self.folder)): p.read_bytes()
                for p in sorted(self.folder.rglob("*")) if p.is_file() and not p.name.startswith((".out-", ".err-"))}


def name_of(status: int) -> str:
    return f"status {status}" if status >= 0 else signal.Signals(-status).name


def not_a_number(word: str):
    raise ValueError(f"{word} in it")


def copy_files(database: pathlib.Path, to: pathlib.Path) -> pathlib.Path:
    """The database with what its -wal holds, to be opened without touching the original."""
    to.mkdir(parents=True, exist_ok=True)
    for ending in ("", "-wal"):
        if (file := pathlib.Path(str(database) + ending)).exists():
            shutil.copy(file, to / file.name)
    return to / database.name
