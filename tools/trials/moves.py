# SPDX-License-Identifier: GPL-3.0-or-later
"""The database, its -wal or its folder is renamed, removed or replaced while a test is recorded into it: the run says so, and all readings
of the test are at its end in the database that is at the path then; a renamed file is whole without what was beside it."""
import os
import shutil

from .contents import check_whole
from .trial import Trial
from .works import check_complete, database_in_use, undisturbed, work

WORKS = ("simulate", "replay", "long")


def renamed(t: Trial):
    os.rename(t.database, t.database.parent / "moved.db")


def removed(t: Trial):
    t.database.unlink()


def replaced(t: Trial):
    other = t.folder / "other.db"
    other.write_bytes(database_in_use(t))
    os.rename(other, t.database)


def wal_removed(t: Trial):
    os.unlink(f"{t.database}-wal")


def folder_removed(t: Trial):
    shutil.rmtree(t.database.parent)


def folder_renamed(t: Trial):
    os.rename(t.database.parent, t.folder / "e")
    t.db = "e/t.db"


HOW = (renamed, removed, replaced, wal_removed, folder_removed, folder_renamed)
PARTS = tuple(how.__name__.replace("_", " ") for how in HOW)
SAYS, SAYS_END = "renamed, removed or replaced", "nothing is lost"


def trial(t: Trial):
    how = HOW[PARTS.index(t.choose(PARTS))]
    of = work(t, t.chance.choice(WORKS))
    undisturbed(t, of)
    (t.folder / "d").mkdir()
    t.db = "d/t.db"
    running = of.start(t)
    while not t.database.exists() and running.poll() is None:
        t.wait_while(running, 0.01)
    t.wait_while(running, 1 + t.chance.uniform(0, 0.6) * running.expected_s)
    if running.poll() is not None:
        return t.count("after its end")
    how(t)
    done = running.wait(120 + running.expected_s)
    # What ended before it could notice was stored, and is where it was moved to.
    if SAYS not in done.err:
        return t.count("amid its end")
    t.count("amid the work")
    t.must(done.status == 0, f"ended with status {done.status}: {done.err}")
    t.must(SAYS_END in done.err, f"did not say that nothing is lost: {done.err}")
    if how is replaced:
        return check_whole(t.database)
    check_complete(t, of)
    if how is renamed:
        check_whole(t.database.parent / "moved.db")
