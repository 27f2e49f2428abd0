# SPDX-License-Identifier: GPL-3.0-or-later
"""Input files spoiled at random (bytes, lines, words, numbers, length, encoding): status 0, 1 or 2, one printable line at status 2,
bounded time and memory, no signal, nothing half written, JSON whole and without NaN. What can be computed for longer than a few
seconds has to stop at a Ctrl-C."""
import pathlib
import signal

from .contents import check_whole
from .mutations import mutant
from .trial import MOST_MEGABYTES, Trial, name_of
from .works import FROM_STATE, GRAINS, ROOT, once, pieces, run

SEEDS = ROOT / "tests/fuzz/seeds"
SAMPLES = ROOT / "samples"
LONG_S, STOP_S, READ_S = 6, 60, 60


def few_lines(path: pathlib.Path) -> bytes:
    """The head, and readings from anywhere."""
    return b"".join(path.read_bytes().splitlines(keepends=True)[:400])


def one_of(t: Trial, *patterns: str) -> pathlib.Path:
    return t.chance.choice(sorted(p for pattern in patterns for p in ROOT.glob(pattern)))


def record(t: Trial):
    path = one_of(t, "samples/records/*.csv", "tests/fuzz/seeds/record_fuzz/*")
    sets = t.chance.choice(((), ("--set", "specimen.height_mm=140", "--set", "specimen.diameter_mm=70")))
    return {path.name: few_lines(path)}, path.name, ("replay", path.name, *sets, "--db", "t.db", "--json")


def ags(t: Trial):
    path = one_of(t, "samples/records/*.ags", "tests/fuzz/seeds/ags_fuzz/*")
    return {path.name: path.read_bytes()}, path.name, ("replay", path.name, "--db", "t.db", "--json")


def dialect(t: Trial):
    files = {name: (SAMPLES / "dialects" / name).read_bytes() for name in ("my_lab.toml", "my_lab_record.txt")}
    return files, t.chance.choice(sorted(files)), ("replay", "my_lab_record.txt", "--dialect", "my_lab.toml", "--db", "t.db", "--json")


def programme(t: Trial):
    path = one_of(t, "samples/programmes/*.toml", "tests/fuzz/seeds/programme_fuzz/*.toml")
    return {path.name: path.read_bytes()}, path.name, ("simulate", path.name, "--db", "t.db", "--json")


def path_of_a_point(t: Trial):
    path = one_of(t, "samples/paths/*.toml")
    files = {path.name: path.read_bytes()}
    if path.name == "from_table.toml":
        files["from_table.csv"] = (SAMPLES / "paths/from_table.csv").read_bytes()
    return files, t.chance.choice(sorted(files)), ("element", path.name, "--json")


def incremental_driver(t: Trial):
    files = {f"d/{p.name}": p.read_bytes() for p in (SAMPLES / "incremental_driver").iterdir()}
    return files, t.chance.choice(sorted(files)), ("element", "d", "--json")


def materials(t: Trial):
    files = {"m.toml": (SAMPLES / "materials/table2_per_test.toml").read_bytes(), "p.toml": (SAMPLES / "paths/icu_100.toml").read_bytes()}
    return files, "m.toml", ("element", "p.toml", "--materials", "m.toml", "--json")


def grain_programme(t: Trial):
    return {"g.toml": GRAINS.encode()}, "g.toml", ("grains", "g.toml", "--db", "t.db", "--output", "g", "--jobs", "1", "--json")


def grain_state(t: Trial):
    files = {"p.toml": FROM_STATE.encode(), "s.grains": pieces(t)["s.grains"]}
    return files, "s.grains", ("grains", "p.toml", "--db", "t.db", "--jobs", "1", "--json")


def grain_piece(t: Trial):
    files = dict(pieces(t))
    return files, t.chance.choice(("1.json", "2.json")), ("grains", "p.toml", "--merge", "1.json", "2.json", "--db", "t.db", "--json")


def domain_piece(t: Trial):
    def make(folder: pathlib.Path):
        for i in "12":
            run(t, folder, "domain", "--material", "inl2/S28-general", "--void-ratio", "1.086", "--p-kPa", "20:200/4", "--q-kPa",
                "-60:120/4", "--directions", "12", "--piece", f"{i}/2", "--output", f"{i}.json")
        return {name: (folder / name).read_bytes() for name in ("1.json", "2.json")}
    files = dict(once(t, "domain-pieces", make))
    return files, t.chance.choice(("1.json", "2.json")), ("domain", "--merge", "1.json", "2.json", "--json")


FILES = (record, record, ags, dialect, programme, path_of_a_point, incremental_driver, materials, grain_programme, grain_state,
         grain_piece, domain_piece)
PARTS = tuple(one.__name__.replace("_", " ") for one in FILES)
# These may have been asked for hours of work.
LONG = (programme, path_of_a_point, incremental_driver, grain_programme, materials)


def trial(t: Trial):
    kind = FILES[PARTS.index(t.choose(PARTS))]
    files, victim, arguments = kind(t)
    for name, data in files.items():
        (t.folder / name).parent.mkdir(exist_ok=True)
        (t.folder / name).write_bytes(mutant(data, t.chance) if name == victim else data)
    before = t.files()
    running = t.start(*arguments)
    t.wait_while(running, LONG_S if kind in LONG else READ_S)
    told_to_stop = running.poll() is None
    t.must(not told_to_stop or kind in LONG, f"did not end within {READ_S} s")
    if told_to_stop:
        t.count("stopped after some seconds")
        running.send(signal.SIGINT)
    done = running.wait(STOP_S)
    check(t, done, told_to_stop)
    new = {name: data for name, data in t.files().items() if before.get(name) != data}
    t.must(not set(new) & set(before), f"changed {sorted(set(new) & set(before))}")
    if done.status == 2:
        t.must(not new, f"status 2, but there is {sorted(new)}")
    for name in new:
        t.must(".part-" not in name, f"{name} is left behind")
    if t.database.exists() and t.database.stat().st_size:
        check_whole(t.database)


def check(t: Trial, done, told_to_stop: bool):
    allowed = (0, 1, 2, -signal.SIGINT) if told_to_stop else (0, 1, 2)
    t.must(done.status in allowed, f"ended by {name_of(done.status)}: {done.err[-1000:]}")
    t.must(done.megabytes < MOST_MEGABYTES, f"took {done.megabytes:.0f} MB")
    t.count({0: "taken", 1: "failed while running", 2: "refused"}.get(done.status, "stopped by the signal"))
    lines = done.err.strip("\n").split("\n")
    if done.status == 2:
        t.must(len(lines) == 1, f"status 2 with {len(lines)} lines: {done.err[:1000]}")
    if done.status in (1, 2):
        t.must(lines[-1].startswith("triax: "), f"status {done.status} without a reason: {done.err[-300:]}")
        t.must(lines[-1].replace("\ufeff", "").isprintable() and len(lines[-1]) < 2000, f"no line to print: {lines[-1][:2000]!r}")
    if done.status == 0 or done.out.strip():
        if done.status in (0, 1):
            t.document(done)
    t.must(done.status != 2 or not done.out, f"status 2 with output: {done.out[:200]!r}")
