# SPDX-License-Identifier: GPL-3.0-or-later
"""Another program holds the lock of the database (a transaction, or the whole file to itself) for a random time during a work, or
from before it on; readers and a repair may come meanwhile: the work ends as if nobody had, nothing is lost or left waiting, and where
it had to wait it says so."""
import sqlite3
import time

from .contents import connect, contents, readings_now
from .trial import Trial
from .works import check_complete, database_in_use, undisturbed, work

PARTS = ("simulate", "replay", "sweep", "long", "grains", "merge")
SAYS, SAYS_END = "until the database can be written", "nothing is lost"
# A work has something to store sooner, and is silent for two seconds (db::Patience::quiet) after that.
CERTAINLY_S = 8


def lock(trial: Trial, alone: bool) -> sqlite3.Connection:
    foreign = connect(trial.database, timeout=30)
    if alone:
        foreign.execute("PRAGMA locking_mode = EXCLUSIVE")
    foreign.execute(trial.chance.choice(("BEGIN IMMEDIATE", "BEGIN EXCLUSIVE")))
    foreign.execute("UPDATE tests SET name = name WHERE id < 0")
    return foreign


def beside(t: Trial) -> list:
    """What a user may do meanwhile: look, which shows what there was, and repair, which harms nobody that lives."""
    if t.chance.random() < 0.3 and (seen := readings_now(t.database)):
        done = t.triax("query", "SELECT count(*) AS n FROM readings", "--db", t.db, "--format", "json")
        t.must(done.status == 0 and t.document(done)[0]["n"] >= seen, f"{seen} readings are not shown: {done.out!r} {done.err}")
    if t.chance.random() < 0.3 and t.database.exists() and t.database.stat().st_size:
        folder = t.folder / "beside"
        folder.mkdir()
        return [t.start("tests", "repair", "--db", t.database, folder=folder)]
    return []


def check_end(t: Trial, running, of, since, waited_s: float, allowed_s: float = 120):
    """Of a work that could store nothing for so long, while it had something to store."""
    done = running.wait(allowed_s + running.expected_s)
    t.must(done.status == 0, f"ended with status {done.status}: {done.err}")
    if SAYS in done.err:
        t.count("said that they wait")
        t.must(SAYS_END in done.err, f"did not say that it waits no longer: {done.err}")
    t.must(waited_s < CERTAINLY_S or SAYS in done.err, f"waited {waited_s:.1f} s without a word: {done.err}")
    check_complete(t, of, since)


def trial(t: Trial):
    t.choose(PARTS)
    of = work(t, t.part)
    undisturbed(t, of)
    seconds = t.hold_s or t.chance.choice((0.2, 1, 3, 8)) * t.chance.uniform(0.5, 1.5)
    # SQLite gives the file to one alone only where no other has it open.
    alone, before = t.chance.random() < 0.2, t.chance.random() < 0.3
    since = None
    if alone or before:
        (t.database).write_bytes(database_in_use(t))
        since = contents(t.database)
        foreign = lock(t, alone)
        running = of.start(t)
    else:
        running = of.start(t)
        while not (t.database).exists() and running.poll() is None:
            t.wait_while(running, 0.01)
        t.wait_while(running, min(10, t.chance.uniform(0, 0.6) * running.expected_s))
        foreign = lock(t, False)
    begin = time.monotonic()
    t.count("amid the work" if running.poll() is None else "after its end")
    others = [] if alone else beside(t)
    t.wait_while(running, seconds)
    waited_s = time.monotonic() - begin if running.poll() is None else 0
    foreign.rollback()
    foreign.close()
    check_end(t, running, of, since, waited_s)
    for other in others:
        told = other.wait()
        t.must(told.status in (0, 1), f"{' '.join(other.command)} ended with status {told.status}: {told.err}")
