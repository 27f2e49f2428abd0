# SPDX-License-Identifier: GPL-3.0-or-later
"""Noise on a line loses, doubles and flips bytes of what instruments say to `triax run`. No reading is invented by it, no ramp ends short of
its target, and `triax replay` takes the record. The relays are between `triax serve` and `triax run`, in lock step: a serial pad over
pseudo-terminals, a scanner and a pressure controller by TCP, a pressure controller by Modbus.

NOISE=0.005 sets the fraction of bytes (default: 0.0005), SEEDS=3 repeats it with other bytes, LINES=pad,scanner chooses lines."""
import contextlib
import csv
import os
import pathlib
import random
import re
import socket
import subprocess
import tempfile
import threading
import tty

from judging import PROGRAMS, check, free_port, verdict, wait_until

TRIAX = str(pathlib.Path(os.environ.get("TRIAX", PROGRAMS.parent.parent / "triax")).resolve())
SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"
FRACTION = float(os.environ.get("NOISE", "0.0005"))
# Fraction of a channel's largest reading by which no reading is beyond its neighbours.
INVENTED = 0.02


class Noise:
    """What a line does to the bytes of an instrument; `kind` None: nothing."""

    def __init__(self):
        self.kind, self.bytes = None, 0

    def spoil(self, part: bytes) -> bytes:
        out = bytearray()
        for byte in part:
            hit = self.kind and random.random() < FRACTION
            self.bytes += bool(hit)
            if not hit:
                out.append(byte)
            elif self.kind == "double":
                out += bytes([byte, byte])
            elif self.kind == "flip":
                out.append(byte ^ 1 << random.randrange(7 if part.isascii() else 8))
        return bytes(out)


def relay_terminals(noise: Noise) -> list[str]:
    """Two linked pseudo-terminals: what is written to the first comes spoilt out of the second."""
    (instrument, its_end), (client, our_end) = os.openpty(), os.openpty()
    for end in (instrument, its_end, client, our_end):
        tty.setraw(end)

    def pump(a: int, b: int, spoil) -> None:
        while part := os.read(a, 4096):
            os.write(b, spoil(part))

    threading.Thread(target=pump, args=(instrument, client, noise.spoil), daemon=True).start()
    threading.Thread(target=pump, args=(client, instrument, lambda part: part), daemon=True).start()
    return [os.ttyname(its_end), os.ttyname(our_end)]


def relay_tcp(noise: Noise, to_port: int) -> int:
    door = socket.create_server(("127.0.0.1", 0))

    def pump(a: socket.socket, b: socket.socket, spoil) -> None:
        with contextlib.suppress(OSError):
            while part := a.recv(65536):
                b.sendall(spoil(part))
        for one in (a, b):
            with contextlib.suppress(OSError):
                one.shutdown(socket.SHUT_RDWR)

    def serve() -> None:
        while True:
            client, _ = door.accept()
            try:
                instrument = socket.create_connection(("127.0.0.1", to_port))
            except OSError:
                client.close()
                continue
            for one in (client, instrument):
                one.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            threading.Thread(target=pump, args=(client, instrument, lambda part: part), daemon=True).start()
            threading.Thread(target=pump, args=(instrument, client, noise.spoil), daemon=True).start()

    threading.Thread(target=serve, daemon=True).start()
    return door.getsockname()[1]


def rig_text(line: str, noise: Noise) -> str:
    """A rig of the samples with free ports, of which one instrument is behind a relay."""
    text = (SAMPLES / "rigs" / ("serial_pad.toml" if line == "pad" else "icu_6.toml")).read_text()
    text = text.replace("../programmes/icu_6.toml", "p.toml")
    if line == "controller":
        text = re.sub(r"modbus-tcp://([\d.:]+)/\d", r"tcp://\1", text)
    for port in sorted(set(re.findall(r"127\.0\.0\.1:(\d+)", text))):
        text = text.replace(f"127.0.0.1:{port}", f"127.0.0.1:{free_port()}")
    if line == "pad":
        its_end, our_end = relay_terminals(noise)
        text = text.replace("/tmp/triax-pad-instrument", its_end).replace("/tmp/triax-pad", our_end)
        return text.replace('personality = "pad"', 'personality = "pad.toml"')
    name = "scanner" if line == "scanner" else "cell controller"
    link = re.search(rf'name = "{name}"\nlink = "([^"]*)"', text)[1]
    port = re.search(r":(\d+)", link)[1]
    behind = link.replace(port, str(relay_tcp(noise, int(port))))
    return text.replace(f'link = "{link}"', f'link = "{behind}"\nserved_at = "{link}"')


def run(noise: Noise, kind: str | None, folder: pathlib.Path) -> tuple[list[str], list[list[str]], str]:
    with subprocess.Popen([TRIAX, "serve", "rig.toml", "--lock-step"], cwd=folder, stdout=subprocess.PIPE, text=True) as server:
        wait_until(lambda: "control" in server.stdout.readline(), 10)
        for old in ("r.csv", "r.db", "z.db"):
            (folder / old).unlink(missing_ok=True)
        with subprocess.Popen([TRIAX, "run", "p.toml", "--rig", "rig.toml", "--db", "r.db", "--record", "r.csv"], cwd=folder,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as client:
            wait_until((folder / "r.db").exists, 10)
            noise.kind = kind
            said = client.communicate(timeout=100)[0]
            noise.kind = None
        server.terminate()
    with open(folder / "r.csv") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    return rows[0], rows[1:], said


def invented(head: list[str], rows: list[list[str]], largest: list[float]) -> list[str]:
    """Cells beyond the range of their neighbours by more than INVENTED of the channel's largest."""
    found = []
    for i, row in enumerate(rows):
        for c in range(2, len(head)):
            near = sorted(float(rows[j][c]) for j in (i - 2, i - 1, i + 1, i + 2) if 0 <= j < len(rows) and rows[j][c])
            allowed = INVENTED * largest[c]
            if row[c] and len(near) > 2 and not near[0] - allowed <= float(row[c]) <= near[-1] + allowed:
                found.append(f"{head[c]} {row[c]} at {row[0]} s beside {near}")
    return found


def try_line(line: str, folder: pathlib.Path) -> None:
    noise = Noise()
    programme = (SAMPLES / "programmes" / "icu_6.toml").read_text()
    programme = programme.replace('"time_min", above = 20.0', '"time_min", above = 2.0').replace('strain_pct", above = 10.0', 'strain_pct", above = 0.5')
    (folder / "p.toml").write_text(programme)
    # A reply that lost its end is awaited until the deadline.
    pad = (SAMPLES.parent / "lab" / "wire" / "personalities" / "pad.toml").read_text()
    (folder / "pad.toml").write_text(pad.replace("deadline_ms = 500", "deadline_ms = 200"))
    (folder / "rig.toml").write_text(rig_text(line, noise))
    head, clean, said = run(noise, None, folder)
    largest = [max((abs(float(row[c])) for row in clean if row[c]), default=0) for c in range(len(head))]
    check(f"{line}: readings without noise", len(clean) > 500 and not invented(head, clean, largest), said)
    for kind in ("lose", "double", "flip"):
        for seed in range(int(os.environ.get("SEEDS", "1"))):
            random.seed(seed)
            noise.bytes = 0
            _, rows, said = run(noise, kind, folder)
            what = f"{line}, {kind}, seed {seed}"
            empty = sum(not cell for row in rows for cell in row[2:])
            print(f"{what}: {noise.bytes} bytes, {len(rows)} readings, {empty} empty cells", *re.findall("safe state from[^\n]*", said)[:1])
            check(f"{what}: noise", noise.bytes > 0, noise.bytes)
            found = invented(head, rows, largest)
            check(f"{what}: nothing is invented", not found, f"{len(found)}: {found[:3]}")
            consolidated = [float(row[4]) for row in rows if row[1] == "3" and row[4]]
            check(f"{what}: the ramp reaches its target", "safe state" in said or abs(consolidated[-1] - 400) < 1, consolidated[-1:])
            if empty:
                check(f"{what}: gaps are told", "gives no readings" in said, said)
            again = subprocess.run([TRIAX, "replay", "r.csv", "--db", "z.db"], cwd=folder, capture_output=True, text=True)
            check(f"{what}: the record is read", again.returncode == 0, again.stderr)


with tempfile.TemporaryDirectory() as made:
    for one in os.environ.get("LINES", "pad,scanner,controller,modbus").split(","):
        try_line(one, pathlib.Path(made))
verdict()
