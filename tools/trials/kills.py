# SPDX-License-Identifier: GPL-3.0-or-later
"""Killed (SIGKILL) at a random instant of a work, now and then while another program holds the database, or of the repair after it:
the database opens and is whole, what a reader had seen is there and is that of an undisturbed run, no file is half, readers show all
that is there, and repair and the same work again succeed."""
import pathlib
import signal
import sqlite3

from .contents import check_whole, compare, connect, contents, readings_now
from .trial import Trial
from .works import check_complete, check_files, check_nothing_waits, undisturbed, work

PARTS = ("simulate", "replay", "sweep", "grains", "merge", "repair", "waiting")


def spools(trial: Trial) -> list[pathlib.Path]:
    return [p for p in trial.database.parent.glob(f"{trial.database.name}.waiting-*") if "-" not in p.name.split(".waiting-")[1]]


def kill_amid(trial: Trial, of, lock: bool) -> int:
    """Gives the number of readings that a reader had seen committed just before."""
    running = of.start(trial)
    foreign = None
    if lock:
        while readings_now(trial.database) == 0 and running.poll() is None:
            trial.wait_while(running, 0.02)
        if running.poll() is None:
            foreign = connect(trial.database, timeout=20)
            foreign.execute("BEGIN IMMEDIATE")
        trial.wait_while(running, trial.chance.uniform(0, 6))
    else:
        trial.wait_while(running, trial.chance.uniform(0, 1.1) * running.expected_s)
    seen = readings_now(trial.database) + sum(readings_now(p) for p in spools(trial))
    running.send(signal.SIGKILL)
    done = running.wait()
    if foreign:
        foreign.rollback()
        foreign.close()
    trial.count("amid the work" if done.status < 0 else "after its end")
    if spools(trial):
        trial.count("while readings waited")
    return seen


def silence(database: pathlib.Path):
    """As if the writers had given no sign for an hour."""
    connection = connect(database, timeout=20)
    try:
        connection.execute("UPDATE leases SET last_sign_of_life = datetime('now', '-1 hour')")
    except sqlite3.OperationalError as error:
        if "no such table" not in str(error):
            raise
    finally:
        connection.close()


def check_readers(trial: Trial):
    """They show every test with every reading that is there."""
    there = contents(trial.database)
    shown = trial.document(trial.triax("tests", "--json", "--db", trial.db))
    tests = {key: one for key, one in there.items() if key[0] == "tests"}
    trial.must(len(shown["tests"] if isinstance(shown, dict) else shown) == len(tests), "a reader leaves out a test")
    counted = trial.document(trial.triax("query", "SELECT count(*) AS n FROM readings", "--db", trial.db, "--format", "json"))
    trial.must(counted[0]["n"] == sum(len(one["scans"]) for one in tests.values()), "a reader leaves out readings")


def repair(trial: Trial):
    done = trial.triax("tests", "repair", "--db", trial.db)
    trial.must(done.status == 0, f"repair ended with status {done.status}: {done.err}")


def trial(t: Trial):
    t.choose(PARTS)
    of = work(t, t.chance.choice(("simulate", "replay", "sweep")) if t.part in ("repair", "waiting") else t.part)
    whole = undisturbed(t, of)
    seen = kill_amid(t, of, t.part == "waiting")
    database = t.database
    check_files(t, of, whole, False)
    there = {}
    if database.exists():
        check_whole(database)
        there = contents(database)
        compare(there, whole.contents, may_lack=True)
    if there or seen:
        check_readers(t)
        silence(database)
        for spool in spools(t):
            check_whole(spool)
            silence(spool)
        if t.part == "repair":
            running = t.start("tests", "repair", "--db", t.db)
            t.wait_while(running, t.chance.uniform(0, 0.2))
            running.send(signal.SIGKILL)
            running.wait()
            check_whole(database)
        repair(t)
        check_nothing_waits(t)
        kept = compare(contents(database), whole.contents, may_lack=True)
        t.must(kept >= seen, f"{seen} readings were committed, {kept} are there")
        check_readers(t)
        t.must(all(one["status"] != "running" for one in contents(database).values()), "a killed test runs for ever")
    before = contents(database) if database.exists() else None
    done = of.start(t).wait()
    t.must(done.status == 0, f"run again it ended with status {done.status}: {done.err}")
    check_complete(t, of, before)
