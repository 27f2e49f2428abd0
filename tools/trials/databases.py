# SPDX-License-Identifier: GPL-3.0-or-later
"""A database that is damaged (bytes, pages, its length, a -wal or -shm that is not its own) or has the schema of a stranger, under every
reader and writer: no crash, bounded time and memory, one line that says so where a command fails, whole JSON where it does not, and no
reader changes a byte; a foreign schema is refused by all."""
import contextlib
import pathlib
import random
import sqlite3

from .trial import Trial
from .works import database_in_use, work

READERS = (("tests",), ("tests", "--json"), ("tests", "show", "1"), ("query", "tests", "--format", "csv"), ("query", "list"),
           ("query", "SELECT * FROM readings", "--format", "json"), ("query", "grain_runs", "--format", "json"),
           ("report", "1", "--json"), ("report", "1"), ("report", "1", "--format", "html", "--output", "r.html"),
           ("probe", "--test", "1", "--json"))
WRITERS = (("tests", "repair"), ("tests", "rename", "1", "other"), ("tests", "tag", "1", "loose"), ("tests", "remove", "1"), "simulate")


def flip_bytes(data: bytearray, chance: random.Random):
    for _ in range(chance.choice((1, 1, 2, 8, 64, 1024))):
        data[chance.randrange(len(data))] = chance.randrange(256)


def flip_in_header(data: bytearray, chance: random.Random):
    for _ in range(chance.choice((1, 1, 2, 4))):
        data[chance.randrange(100)] = chance.choice((0, 1, 255, chance.randrange(256)))


def cut(data: bytearray, chance: random.Random):
    del data[chance.randrange(len(data)):]


def zero_a_run(data: bytearray, chance: random.Random):
    at, length = chance.randrange(len(data)), chance.choice((16, 512, 4096, 32768))
    data[at:at + length] = bytes(len(data[at:at + length]))


def page_size(data: bytes) -> int:
    return max(512, int.from_bytes(data[16:18], "big")) or 65536


def pages_mixed(data: bytearray, chance: random.Random):
    size = page_size(data)
    a, b = (chance.randrange(len(data) // size) * size for _ in range(2))
    if chance.random() < 0.5:
        data[a:a + size], data[b:b + size] = data[b:b + size], data[a:a + size]
    else:
        data[a:a + size] = data[b:b + size]


def page_header(data: bytearray, chance: random.Random):
    """The head of a page of a tree: kind, free blocks, cells; pointers behind it."""
    at = chance.randrange(1, max(2, len(data) // page_size(data))) * page_size(data)
    for _ in range(chance.choice((1, 2, 3))):
        place = at + chance.randrange(40)
        if place < len(data):
            data[place] = chance.randrange(256)


def grown(data: bytearray, chance: random.Random):
    data += chance.randbytes(chance.choice((1, 511, 32768)))


DAMAGE = (flip_bytes, flip_bytes, flip_in_header, cut, zero_a_run, pages_mixed, page_header, page_header, grown)
PARTS = (*(one.__name__.replace("_", " ") for one in DAMAGE), "beside", "foreign schema")
ENDLESS = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT i AS test_id FROM n"
FOREIGN = ("CREATE TRIGGER a AFTER INSERT ON scans BEGIN DELETE FROM scans; END",
           "CREATE TRIGGER a AFTER UPDATE ON leases BEGIN DELETE FROM tests; END",
           f"CREATE VIEW a AS {ENDLESS}", f"DROP VIEW states; CREATE VIEW states AS {ENDLESS}", f"DROP TABLE tags; CREATE VIEW tags AS {ENDLESS}",
           "CREATE UNIQUE INDEX a ON scans (stage, time_s)", "ALTER TABLE tests ADD COLUMN a REAL DEFAULT 1",
           "ALTER TABLE scans ADD COLUMN a REAL AS (abs(-9223372036854775807 - stage))")


def beside(t: Trial, base: bytes):
    """A -wal or -shm that is of nothing, or of another database."""
    for ending in t.chance.choice((("-wal",), ("-shm",), ("-wal", "-shm"), ("-journal",))):
        path = pathlib.Path(str(t.database) + ending)
        kind = t.chance.choice(("noise", "empty", "short", "own pages"))
        head = bytes.fromhex("377f0682002de218") + page_size(base).to_bytes(4, "big") + bytes(4)
        path.write_bytes({"noise": t.chance.randbytes(40000), "empty": b"", "short": head,
                          "own pages": head + t.chance.randbytes(16) + base[:40000]}[kind])


def one_line(t: Trial, done):
    lines = done.err.strip("\n").split("\n")
    t.must(done.status == 0 or (lines[-1].startswith("triax:") and len(lines) <= 3), f"status {done.status} with {done.err!r}")


def trial(t: Trial):
    base = database_in_use(t)
    data = bytearray(base)
    if t.choose(PARTS) == "beside":
        t.database.write_bytes(data)
        beside(t, base)
    elif t.part == "foreign schema":
        t.database.write_bytes(data)
        with contextlib.closing(sqlite3.connect(t.database)) as foreign:
            foreign.executescript(t.chance.choice(FOREIGN))
    else:
        DAMAGE[PARTS.index(t.part)](data, t.chance)
        t.database.write_bytes(data)
    before = {name: bytes_ for name, bytes_ in t.files().items() if not name.endswith("-shm")}
    for arguments in t.chance.sample(READERS, 4):
        done = t.triax(*arguments, "--db", t.db)
        t.count({0: "readers answered", 1: "readers told", 2: "readers told"}[done.status])
        one_line(t, done)
        t.must(t.part != "foreign schema" or done.status == 2, f"triax {' '.join(arguments)} read a foreign schema")
        if done.status == 0 and "json" in " ".join(arguments):
            t.document(done)
        after = {name: bytes_ for name, bytes_ in t.files().items() if not name.endswith("-shm") and name != "r.html"}
        t.must({k: v for k, v in after.items() if v or k in before} == before, f"triax {' '.join(arguments)} changed {differing(before, after)}")
    writer = t.chance.choice(WRITERS)
    if writer == "simulate":
        done = work(t, "replay").start(t).wait()
        t.must(done.status in (0, 1, 2), f"ended with status {done.status}: {done.err}")
    else:
        done = t.triax(*writer, "--db", t.db)
    t.must(t.part != "foreign schema" or done.status == 2, f"a foreign schema was written: {done.err}")
    t.count("writers went on" if done.status == 0 else "writers told")
    one_line(t, done)


def differing(before: dict, after: dict) -> list[str]:
    """An empty file that was not there is no change."""
    return sorted(name for name in {*before, *after} if before.get(name) != after.get(name) and (name in before or after[name]))
