# SPDX-License-Identifier: GPL-3.0-or-later
"""What a database holds, test by test and run by run, so that an undisturbed and a disturbed one can be compared to the bit."""
import pathlib
import sqlite3
import tempfile

from .trial import Broken, copy_files

# Of one reading each, in their order: of a test that was cut short the first of them are there.
SERIES = ("scans", "scan_details", "work_points")
# What is found before the end, and may be less in a test that was cut short.
EARLY = ("stages", "events", "sweep_members", "record_notes", "guesses", "grain_stages", "grain_points", "grain_probes")
# What differs from run to run.
OF_THE_RUN = {"id", "test_id", "run_id", "stored_at", "recorded_at", "wall_clock_s", "sweep", "status", "source", "digest"}


def connect(database: pathlib.Path, **how) -> sqlite3.Connection:
    return sqlite3.connect(database, isolation_level=None, **how)


def check_whole(database: pathlib.Path):
    """integrity_check and foreign keys of a copy."""
    with tempfile.TemporaryDirectory() as folder:
        copy = connect(copy_files(database, pathlib.Path(folder)))
        try:
            found = copy.execute("PRAGMA integrity_check").fetchall()
            astray = copy.execute("PRAGMA foreign_key_check").fetchall()
        except sqlite3.DatabaseError as error:
            raise Broken(f"{database.name}: {error}") from error
        finally:
            copy.close()
    if found != [("ok",)] or astray:
        raise Broken(f"{database.name}: integrity_check {found[:3]}, foreign keys {astray[:3]}")


def readings_now(database: pathlib.Path) -> int:
    """Committed so far, seen by a reader of its own; 0 where there is no table yet."""
    try:
        reader = sqlite3.connect(f"file:{database}?mode=ro", uri=True, isolation_level=None, timeout=5)
        try:
            return reader.execute("SELECT count(*) FROM scans").fetchone()[0]
        finally:
            reader.close()
    except sqlite3.Error:
        return 0


def rows_of(database: sqlite3.Connection, table: str, where: str) -> list[tuple]:
    names = [row[1] for row in database.execute(f"PRAGMA table_info({table})") if row[1] not in OF_THE_RUN]
    number = "id & 4294967295, " if table in SERIES else ""
    # A column in the order it has in the rows of a series; elsewhere any order that is always the same.
    order = "id" if table in SERIES else ", ".join(str(i + 1) for i in range(len(names)))
    return database.execute(f"SELECT {number}{', '.join(names)} FROM {table} WHERE {where} ORDER BY {order}").fetchall()


def contents(database: pathlib.Path, since: dict | None = None) -> dict:
    """{("tests", name, seed) or ("grain_runs", name, grains): {"id": ..., "status": ..., table: rows}} of a copy of the database:
    of all of it, or of what came after the contents `since`."""
    found: dict = {}
    with tempfile.TemporaryDirectory() as folder:
        copy = connect(copy_files(database, pathlib.Path(folder)))
        tables = [row[0] for row in copy.execute("SELECT name FROM sqlite_schema WHERE type = 'table' AND name <> 'leases'")]
        columns = {t: {row[1] for row in copy.execute(f"PRAGMA table_info({t})")} for t in tables}
        for owner, key, second in (("tests", "test_id", "seed"), ("grain_runs", "run_id", "grains")):
            first = max((one["id"] for of, one in (since or {}).items() if of[0] == owner), default=0)
            rows = copy.execute(f"SELECT id, name, {second}, status FROM {owner} WHERE id > {first}").fetchall() if owner in tables else []
            for number, name, value, status in rows:
                one = {"id": number, "status": status, owner: rows_of(copy, owner, f"id = {number}")}
                for table in tables:
                    if key in columns[table]:
                        one[table] = rows_of(copy, table, f"{key} = {number}")
                    elif table in SERIES and owner == "tests":
                        one[table] = rows_of(copy, table, f"id BETWEEN {number} << 32 AND {number} << 32 | 4294967295")
                if (owner, name, value) in found:
                    raise Broken(f"{name} with {second} {value} is in the database twice")
                found[owner, name, value] = one
        copy.close()
    return found


def compare(found: dict, whole: dict, may_lack=False, stopped=False) -> int:
    """What is complete is the same to the bit; what is not, or was `stopped` in good order, is a part of it. Gives the number of
    readings."""
    for key, one in found.items():
        if key not in whole:
            raise Broken(f"{key} was never asked for")
        for table, rows in whole[key].items():
            if isinstance(rows, list):
                compare_rows(f"{key}: {table}", table, one["status"] == "complete" and not stopped, one[table], rows)
    if not may_lack and set(found) != set(whole):
        raise Broken(f"missing: {sorted(set(whole) - set(found))}")
    if not may_lack and any(one["status"] != "complete" for one in found.values()):
        raise Broken("not complete")
    return sum(len(one.get("scans", [])) for one in found.values())


def compare_rows(what: str, table: str, is_whole: bool, rows: list, whole: list):
    if table == "warnings":  # of the database, not of the test
        rows = [row for row in rows if not any("was read before" in str(cell) for cell in row)]
    if is_whole:
        if rows != whole:
            raise Broken(f"{what} differs from that of an undisturbed run\n{first_difference(rows, whole)}")
    elif table in SERIES:
        if table == "work_points":  # the last windows reach into what was not read any more
            rows = rows[:-64]
        if rows != whole[:len(rows)]:
            raise Broken(f"{what} is not the beginning of an undisturbed run's\n{first_difference(rows, whole)}")
    elif table in EARLY and not {row for row in rows if "aborted" not in row} <= set(whole):
        raise Broken(f"{what} holds what an undisturbed run has not: {set(rows) - set(whole)}")


def first_difference(one, other) -> str:
    for number, (a, b) in enumerate(zip(one, other)):
        if a != b:
            return f"row {number}: {a}\ninstead of {b}"
    return f"{len(one)} rows instead of {len(other)}"
