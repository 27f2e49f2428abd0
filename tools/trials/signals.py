# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl-C or SIGTERM at a random instant of a work: status 1 and a word of the operator, every reading that was committed is there and
is that of an undisturbed run, and nothing is left that claims to run. Before the program is ready for it, or once its result is
stored, the signal itself may end it."""
import signal

from .contents import check_whole, compare, connect, contents, readings_now
from .kills import repair, spools
from .trial import Trial, name_of
from .works import check_complete, check_nothing_waits, undisturbed, work

PARTS = ("simulate", "replay", "sweep", "grains", "merge")
SIGNALS = (signal.SIGINT, signal.SIGTERM)


def trial(t: Trial):
    t.choose(PARTS)
    of = work(t, t.part)
    whole = undisturbed(t, of)
    number = t.chance.choice(SIGNALS)
    locked = of.lasts_s > 0 and t.chance.random() < 0.2
    running = of.start(t)
    t.wait_while(running, t.chance.uniform(0, 1.1) * running.expected_s)
    foreign = None
    if locked and readings_now(t.database) > 0 and running.poll() is None:
        foreign = connect(t.database, timeout=30)
        foreign.execute("BEGIN IMMEDIATE")
        t.wait_while(running, t.chance.uniform(0, 4))
    # Of a sweep that is stopped only complete tests are kept.
    seen = 0 if t.part == "sweep" else readings_now(t.database) + sum(readings_now(p) for p in spools(t))
    running.send(number)
    if foreign:
        t.count("while the database was locked")
        t.wait_while(running, t.chance.uniform(0, 3))
        foreign.rollback()
        foreign.close()
    done = running.wait()
    if done.status == 0:
        t.count("after its end")
        return check_complete(t, of)
    check_record(t) if t.part == "simulate" else check_files_of_a_part(t)
    there = contents(t.database) if t.database.exists() and t.database.stat().st_size else {}
    if done.status == -number:
        complete = set(there) == set(whole.contents) and all(one["status"] == "complete" for one in there.values())
        t.must(not there or complete, f"the signal ended it amid its work: {done.err}")
        return t.count("before it was ready" if not there else "while it printed")
    t.count("amid the work")
    t.must(done.status == 1, f"ended by {name_of(done.status)}: {done.err}")
    t.must("operator" in done.err, f"does not say why it ended: {done.err}")
    if spools(t):
        t.must("triax tests repair" in done.err, f"readings wait without a word: {done.err}")
        t.count("readings left waiting")
        repair(t)
    check_nothing_waits(t)
    if not there and not t.database.exists():
        return
    check_whole(t.database)
    there = contents(t.database)
    kept = compare(there, whole.contents, may_lack=True, stopped=t.part != "sweep")
    t.must(kept >= seen, f"{seen} readings were committed, {kept} are there")
    t.must(all(one["status"] != "running" for one in there.values()), "something claims to run")


def check_record(t: Trial):
    """The record of a stopped test holds the readings of the database."""
    record = t.folder / "r.csv"
    if not record.exists():
        return
    rows = sum(1 for line in record.read_text(encoding="utf-8").splitlines() if line[:1].isdigit() or line[:1] == "-")
    stored = sum(len(one["scans"]) for one in contents(t.database).values())
    t.must(rows == stored, f"the record has {rows} readings, the database {stored}")


ENDS = {".json": b"}", ".pdf": b"%%EOF", ".svg": b"</svg>", ".csv": b"\n"}


def check_files_of_a_part(t: Trial):
    """Files of the stages that had ended: each to its end."""
    for path in t.folder.rglob("*"):
        ends = ENDS.get(path.suffix)
        t.must(not ends or path.read_bytes().rstrip(b" \r\n" if ends != b"\n" else b"").endswith(ends), f"{path.name} is half a file")
        t.must(".part-" not in path.name, f"{path.name} is left behind")
