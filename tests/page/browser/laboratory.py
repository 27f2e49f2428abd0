# SPDX-License-Identifier: GPL-3.0-or-later
"""triax open, with a database of its own, in a folder that is gone afterwards."""
import json
import os
import pathlib
import re
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = os.path.abspath(os.environ.get("TRIAX", ROOT / "build/release/triax"))


class Laboratory:
    """`programmes` (names of samples) are simulated into the database first. `address` lets one browser in."""

    def __init__(self, *programmes: str, more: tuple = ()):
        self.room = tempfile.TemporaryDirectory(prefix="triax-page-")
        self.folder = pathlib.Path(self.room.name)
        self.db = self.folder / "triax.db"
        for name in programmes:
            self.triax("simulate", str(ROOT / f"samples/programmes/{name}.toml"), "--db", str(self.db))
        self.more = more
        self.open()

    def open(self) -> None:
        with open(self.folder / "said", "w", encoding="utf-8") as said:
            self.process = subprocess.Popen([PROGRAM, "open", "--db", str(self.db), *self.more], cwd=self.folder, stdout=said, stderr=subprocess.STDOUT)
        self.address = self.told(r"http://\S+")
        self.origin = re.match(r"http://[^/]+", self.address).group()

    def close(self) -> None:
        self.process.terminate()
        try:
            self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()

    def again(self) -> "Laboratory":
        """Opened anew: an address lets one browser in."""
        self.close()
        self.open()
        return self

    def triax(self, *arguments: str) -> str:
        done = subprocess.run([PROGRAM, *arguments], cwd=self.folder, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise SystemExit(f"triax {' '.join(arguments)}: status {done.returncode}\n{done.stderr}")
        return done.stdout

    def told(self, pattern: str, seconds: float = 20) -> str:
        end = time.monotonic() + seconds
        while time.monotonic() < end and self.process.poll() is None:
            found = re.search(pattern, (self.folder / "said").read_text(encoding="utf-8"))
            if found:
                return found.group()
            time.sleep(0.02)
        raise SystemExit(f"triax open did not say {pattern}: {(self.folder / 'said').read_text(encoding='utf-8')}")

    def report(self, test) -> dict:
        return json.loads(self.triax("report", str(test), "--json", "--db", str(self.db)))

    def query(self, sql: str) -> list:
        return json.loads(self.triax("query", sql, "--format", "json", "--db", str(self.db)))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()
        self.room.cleanup()
