# SPDX-License-Identifier: GPL-3.0-or-later
"""What the program is disturbed at: works that end by themselves, and what they leave where nobody disturbs them."""
import contextlib
import dataclasses
import pathlib
import shutil

from .contents import check_whole, compare, connect, contents
from .trial import Broken, Done, Running, Trial

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAMME = (ROOT / "tests/fuzz/seeds/programme_fuzz/icu.toml").read_text(encoding="utf-8")
RECORD = ROOT / "samples/records/icu_6.csv"
DB = "t.db"

SPECIMEN = """[run]
name = "few"
[specimen]
grains = 60
seed = 3
pressure_kPa = 100.0
compaction_friction_deg = 20.0
[[stages]]
name = "isotropic"
action = "isotropic"
pressure_kPa = 100.0
save = true
"""
PROBES = """[[stages]]
name = "probes"
action = "probes"
directions = 6
norm_kPa = 1.0
"""
GRAINS = SPECIMEN + """[[stages]]
name = "drained"
action = "drained"
radial_stress_kPa = 100.0
strain_rate_per_s = 0.5
end_axial_strain_pct = 1.0
[[stages]]
name = "rest"
action = "rest"
""" + PROBES
FROM_STATE = """[run]
name = "merged"
[specimen]
state = "s.grains"
""" + PROBES

# A reading a second, of the test's own clock, as long as it is left to run.
LONG = PROGRAMME[:PROGRAMME.index("[[stages]]")] + """[[stages]]
name = "shear"
role = "shear"
drainage = "open"
axial = "displacement"
axial_rate_mm_per_min = 0.0005
time_limit_min = 100000
end = [{{quantity = "time_min", above = {minutes:.1f}}}]
"""
LONG_SPEED = 100


@dataclasses.dataclass
class Work:
    """`speeds`: to choose from, the results do not depend on them. `output`: a file or folder, whole or absent."""
    name: str
    arguments: tuple[str, ...]
    inputs: dict[str, bytes]
    output: str = ""
    speeds: tuple[str, ...] = ("max",)
    lasts_s: float = 0     # by the clock of the test, which --speed goes by; 0: it stores no readings

    def lay_out(self, folder: pathlib.Path):
        for name, data in self.inputs.items():
            (folder / name).write_bytes(data)

    def start(self, trial: Trial) -> Running:
        self.lay_out(trial.folder)
        speed = trial.chance.choice(self.speeds)
        arguments = [trial.db if a == DB else a for a in self.arguments]
        running = trial.start(*arguments, *([] if speed == "max" else ["--speed", speed]))
        running.expected_s = undisturbed(trial, self).seconds + (0 if speed == "max" else self.lasts_s / float(speed))
        return running


@dataclasses.dataclass
class Undisturbed:
    contents: dict
    files: dict[str, bytes]
    seconds: float


def run(trial: Trial, folder: pathlib.Path, *arguments: str) -> Done:
    done = trial.start(*arguments, folder=folder).wait(600)
    trial.told.pop()
    if done.status != 0:
        raise Broken(f"undisturbed, {' '.join(arguments)} ended with status {done.status}: {done.err}")
    return done


def once(trial: Trial, key: str, make):
    """What all trials share is made by the first that asks for it, in a folder beside theirs."""
    if key not in trial.undisturbed:
        folder = trial.folder.parent / f"undisturbed-{key}"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        trial.undisturbed[key] = make(folder)
    return trial.undisturbed[key]


def pieces(trial: Trial) -> dict[str, bytes]:
    """A programme of probes of a saved state, and its two pieces."""
    def make(folder: pathlib.Path):
        (folder / "g.toml").write_text(SPECIMEN, encoding="utf-8")
        run(trial, folder, "grains", "g.toml", "--output", "g", "--jobs", "1")
        (folder / "g/grains_isotropic.grains").rename(folder / "s.grains")
        (folder / "p.toml").write_text(FROM_STATE, encoding="utf-8")
        for i in "12":
            run(trial, folder, "grains", "p.toml", "--piece", f"{i}/2", "--output", f"{i}.json", "--jobs", "1")
        return {name: (folder / name).read_bytes() for name in ("s.grains", "p.toml", "1.json", "2.json")}
    return once(trial, "pieces", make)


def work(trial: Trial, name: str) -> Work:
    programme = {"p.toml": PROGRAMME.encode()}
    simulate = ("simulate", "p.toml", "--db", DB)
    if name == "simulate":
        return Work(name, (*simulate, "--json", "--record", "r.csv"), programme, "r.csv", ("max", "400", "1500"), 1906)
    if name == "replay":
        return Work(name, ("replay", str(RECORD), "--db", DB, "--json"), {}, "", ("max", "1500", "5000"), 6560)
    if name == "sweep":
        return Work(name, (*simulate, "--json", "--sweep", "seed=1:4:1", "--jobs", "2"), programme, "", ("max", "800", "3000"), 3812)
    if name == "long":  # lasts longer than a disturbance of hold_s, or of some seconds
        lasts_s = LONG_SPEED * (1.15 * trial.hold_s + 8)
        return Work(name, simulate, {"p.toml": LONG.format(minutes=lasts_s / 60).encode()}, "", (str(LONG_SPEED),), lasts_s)
    if name == "grains":
        return Work(name, ("grains", "g.toml", "--db", DB, "--output", "g", "--jobs", "1", "--json"), {"g.toml": GRAINS.encode()}, "g")
    return Work(name, ("grains", "p.toml", "--merge", "1.json", "2.json", "--db", DB, "--output", "m", "--json"), pieces(trial), "m")


def undisturbed(trial: Trial, of: Work) -> Undisturbed:
    def make(folder: pathlib.Path):
        of.lay_out(folder)
        done = run(trial, folder, *of.arguments)
        return Undisturbed(contents(folder / DB), made_files(folder, of), done.seconds)
    return once(trial, of.name, make)


def database_in_use(trial: Trial) -> bytes:
    """One that holds a test and a run of grains already."""
    def make(folder: pathlib.Path):
        for name in ("replay", "grains"):
            one = work(trial, name)
            one.lay_out(folder)
            run(trial, folder, *one.arguments)
        with contextlib.closing(connect(folder / DB)) as database:
            database.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        return (folder / DB).read_bytes()
    return once(trial, "database", make)


def made_files(folder: pathlib.Path, of: Work) -> dict[str, bytes]:
    at = folder / of.output
    found = [at] if at.is_file() else sorted(at.rglob("*")) if of.output and at.is_dir() else []
    return {str(p.relative_to(folder)): p.read_bytes() for p in found if p.is_file()}


def check_files(trial: Trial, of: Work, whole: Undisturbed, all_of_them: bool):
    """Each that is there is the whole one (a PDF holds its time: to its end)."""
    found = made_files(trial.folder, of)
    for name, data in found.items():
        good = data.rstrip().endswith(b"%%EOF") if name.endswith(".pdf") else data == whole.files.get(name)
        trial.must(good, f"{name} is not that of an undisturbed run")
    trial.must(not all_of_them or set(found) == set(whole.files), f"files missing: {sorted(set(whole.files) - set(found))}")
    for path in trial.folder.rglob("*.part-*"):
        raise Broken(f"{path.name} is left behind")


def check_complete(trial: Trial, of: Work, since: dict | None = None):
    """As if nobody had disturbed it, in what came after the contents `since`; nothing waits any more."""
    whole = undisturbed(trial, of)
    check_whole(trial.database)
    compare(contents(trial.database, since), whole.contents)
    check_files(trial, of, whole, True)
    check_nothing_waits(trial)


def check_nothing_waits(trial: Trial):
    left = [p.name for p in trial.database.parent.glob(f"{DB}.waiting-*")]
    trial.must(not left, f"still waiting: {left}")
