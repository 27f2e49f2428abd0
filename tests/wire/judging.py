# SPDX-License-Identifier: GPL-3.0-or-later
"""What the judges of the wire have in common: foreign tools, pairs of pseudo-terminals, stations of ours, checks that are counted."""
import os
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import time

PROGRAMS = pathlib.Path(os.environ.get("WIRE_PROGRAMS", "build/release/tests/wire"))
SKIPPED = 77
SCPI_STATION = str(PROGRAMS / "scpi_station")
checks = failures = 0


def needs(*tools: str, modules: tuple = ()) -> None:
    """Ends the judge as skipped where a tool is missing. Python modules of Debian are looked for with Debian's own interpreter too."""
    missing = [tool for tool in tools if not shutil.which(tool)]
    for module in modules:
        try:
            __import__(module)
        except ImportError:
            debian = "/usr/bin/python3"
            if os.path.exists(debian) and sys.executable != debian and "JUDGED_BY_DEBIAN" not in os.environ:
                os.execve(debian, [debian, *sys.argv], os.environ | {"JUDGED_BY_DEBIAN": "1"})
            missing.append(f"python module {module}")
    if missing:
        print("skipped, not installed here:", ", ".join(missing))
        sys.exit(SKIPPED)


def check(what: str, right: bool, found="") -> None:
    global checks, failures
    checks += 1
    if not right:
        failures += 1
        print(f"FAILED: {what}: {found}")


def same(what: str, found, wanted) -> None:
    check(what, found == wanted, f"{found!r} instead of {wanted!r}")


def verdict() -> None:
    print(f"{checks} checks, {failures} failed")
    sys.exit(1 if failures or not checks else 0)


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def wait_until(reached, seconds=5.0) -> bool:
    end = time.monotonic() + seconds
    while not reached():
        if time.monotonic() > end:
            return False
        time.sleep(0.01)
    return True


class SerialPair:
    """Two pseudo-terminals that socat holds together: what is written to one is read from the other."""

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory()
        self.ends = [os.path.join(self.folder.name, name) for name in ("a", "b")]
        self.socat = subprocess.Popen(["socat"] + [f"pty,raw,echo=0,link={end}" for end in self.ends])
        if not wait_until(lambda: all(os.path.exists(end) for end in self.ends)):
            raise RuntimeError("socat made no pair of terminals")
        return self.ends

    def __exit__(self, *_):
        self.socat.terminate()
        self.socat.wait()
        self.folder.cleanup()


class Station:
    """NAME_station serve LINK...: `links` are those it took; `told` what it has printed since."""

    def __init__(self, name: str, *links: str):
        self.out = tempfile.TemporaryFile("w+")
        self.process = subprocess.Popen([str(PROGRAMS / name), "serve", *links], stdin=subprocess.PIPE, stdout=self.out)
        if not wait_until(lambda: len(self.lines()) >= len(links) or self.process.poll() is not None):
            raise RuntimeError("the station says nothing")
        self.links = self.lines()[:len(links)]
        self.told = len(links)

    def lines(self) -> list[str]:
        self.out.seek(0)
        return self.out.read().splitlines()

    def new_lines(self) -> list[str]:
        lines = self.lines()[self.told:]
        self.told += len(lines)
        return lines

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.stdin.close()
        self.process.wait(5)


def run(*words: str, seconds=20) -> subprocess.CompletedProcess:
    return subprocess.run(words, capture_output=True, text=True, timeout=seconds)


class Served:
    """Our instruments at free ports: `ports["34401A"]`. They end with this script at the latest."""

    def __init__(self, *arguments):
        self.process = subprocess.Popen([SCPI_STATION, *arguments], stdout=subprocess.PIPE, text=True)
        self.ports = {}
        for line in self.process.stdout:
            if line == "ready\n":
                return
            name, address = line.split()
            self.ports[name] = address.rsplit(":", 1)[1]
        raise SystemExit("the instruments did not begin")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()


def output_of(*command, **more):
    """The output of a command that must end well."""
    done = subprocess.run(command, capture_output=True, text=True, timeout=30, **more)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(command)}: status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def expect(found, wanted, what):
    if found != wanted:
        raise SystemExit(f"{what}: {found!r} instead of {wanted!r}")
    print(f"ok: {what}")
