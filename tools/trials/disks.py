# SPDX-License-Identifier: GPL-3.0-or-later
"""The disk of the database is full for a random time and then freed (a small file system of its own; a limit on the size of files,
raised later, where the user may not mount one): the work ends as if it had not been, and where it had to wait it says so."""
import os
import pathlib
import resource
import subprocess
import time

from .contents import compare, contents
from .locks import beside, check_end
from .trial import Trial
from .works import undisturbed, work

PARTS = ("simulate", "replay", "sweep", "long", "grains", "merge", "output")


class SmallDisk:
    """A file system at `folder`; `mounted` is false where that is not allowed."""

    def __init__(self, folder: pathlib.Path, megabytes: int):
        self.folder = folder
        folder.mkdir(exist_ok=True)
        self.mounted = os.geteuid() == 0 and subprocess.run(
            ["mount", "-t", "tmpfs", "-o", f"size={megabytes}m", "tmpfs", folder], capture_output=True, check=False).returncode == 0

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.mounted:
            subprocess.run(["umount", "-l", self.folder], check=False)

    def fill(self):
        with open(self.folder / "ballast", "ab", buffering=0) as ballast:
            for size in (1 << 16, 1 << 12, 64):
                try:
                    while True:
                        ballast.write(bytes(size))
                except OSError:
                    continue

    def free(self):
        (self.folder / "ballast").unlink()


class Limit:
    """On the size of any file that the running program writes: as if no block were left."""

    def __init__(self, running, database: pathlib.Path):
        self.pid = running.process.pid
        written = [p.stat().st_size for p in database.parent.glob(f"{database.name}*") if p.is_file()]
        resource.prlimit(self.pid, resource.RLIMIT_FSIZE, (max([1 << 20, *written]), resource.RLIM_INFINITY))

    def free(self):
        resource.prlimit(self.pid, resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))


def full_for_a_time(t: Trial, of, disk: SmallDisk | None):
    before = disk is not None and t.chance.random() < 0.3
    seconds = t.hold_s or t.chance.choice((0.2, 1, 3, 8)) * t.chance.uniform(0.5, 1.5)
    if before:
        disk.fill()
    running = of.start(t)
    if not before:
        t.wait_while(running, min(10, t.chance.uniform(0, 0.8) * running.expected_s))
    full = disk
    if running.poll() is None and disk is None:
        full = Limit(running, t.database)
    elif disk and not before:
        disk.fill()
    begin = time.monotonic()
    t.count("amid the work" if running.poll() is None else "after its end")
    others = beside(t) if disk else []
    t.wait_while(running, seconds)
    # A limit lets a file of another name still grow: whether it met one cannot be said.
    waited_s = time.monotonic() - begin if running.poll() is None and disk else 0
    if full and (disk or running.poll() is None):
        full.free()
    check_end(t, running, of, None, waited_s)
    for other in others:
        other.wait()


def output_on_a_full_disk(t: Trial, disk: SmallDisk):
    """States that a run of grains saves wait for the disk; other files may be refused, in words, but none is half, and the database
    has all of it."""
    of = work(t, t.chance.choice(("simulate", "grains")))
    whole = undisturbed(t, of)
    at = t.folder / of.output
    target = disk.folder / at.name
    of.arguments = tuple(str(target) if a == of.output else a for a in of.arguments)
    disk.fill()
    with open(disk.folder / "ballast", "r+b") as ballast:  # a little room: a part of it fits
        ballast.truncate(max(0, ballast.seek(0, os.SEEK_END) - t.chance.choice((0, 1 << 14, 1 << 16, 1 << 18))))
    running = of.start(t)
    t.wait_while(running, t.hold_s or t.chance.uniform(0, 6))
    disk.free()
    done = running.wait()
    t.must(done.status in (0, 1), f"status {done.status}: {done.err}")
    t.must(done.status == 0 or "No space left" in done.err, f"does not say that the disk is full: {done.err}")
    t.count("output written" if done.status == 0 else "output refused")
    for path in disk.folder.rglob("*"):
        if path.is_file():
            name = str(path.relative_to(disk.folder))
            good = path.suffix == ".pdf" or path.read_bytes() == whole.files.get(name)
            t.must(good, f"{name} is not that of an undisturbed run")
    t.must(of.name != "grains" or (target / "grains_isotropic.grains").exists(), "a state is lost")
    compare(contents(t.database), whole.contents)


def trial(t: Trial):
    t.choose(PARTS)
    limited = t.part in ("replay", "sweep") and t.chance.random() < 0.3
    with SmallDisk(t.folder / "disk", 48 if t.hold_s < 60 else 256) as disk:
        if disk.mounted and t.part == "output":
            return output_on_a_full_disk(t, disk)
        if not disk.mounted:
            t.count("limits on files: this user may not mount a small disk")
            t.part = t.chance.choice(("replay", "sweep"))
        elif not limited:
            t.db = "disk/t.db"
        of = work(t, t.part)
        undisturbed(t, of)
        full_for_a_time(t, of, disk if t.db != "t.db" else None)
