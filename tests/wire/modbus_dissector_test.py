# SPDX-License-Identifier: GPL-3.0-or-later
"""tshark dissects what our client and our controllers said to each other, TCP and RTU, and finds nothing malformed.

No capture is needed: a relay between both keeps the bytes, which are put into packets of TCP. A byte that is spoilt on the way shows that
the dissector would have noticed.
"""
import os
import pathlib
import select
import socket
import struct
import tempfile
import threading

from judging import PROGRAMS, SerialPair, Station, check, needs, run, same, verdict

needs("tshark", "socat")
QUESTIONS = ["target_kPa=250.5", "rate_kPa_per_min=5", "mode=2", "valve_open=1", "pressure_kPa", "volume_mm3", "piston", "mode", "valve_open"]


class Relay(threading.Thread):
    """Between two open ends; keeps (from the first end, bytes) of each piece."""

    def __init__(self, ends):
        super().__init__(daemon=True)
        self.ends, self.pieces = ends, []
        self.start()

    def run(self):
        while True:
            for end in select.select(self.ends, [], [])[0]:
                piece = os.read(end, 4096)
                if not piece:
                    return
                first = end == self.ends[0]
                self.pieces.append((first, piece))
                os.write(self.ends[1 if first else 0], piece)


def packets(pieces, path: pathlib.Path) -> None:
    """A capture file (LINKTYPE_RAW) of one TCP connection, port 40000 to 502."""
    sent = {True: 1, False: 1}
    with path.open("wb") as out:
        out.write(struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 65535, 101))
        for number, (first, piece) in enumerate(pieces):
            ports = (40000, 502) if first else (502, 40000)
            tcp = struct.pack(">HHIIBBHHH", *ports, sent[first], sent[not first], 0x50, 0x18, 65535, 0, 0)
            sent[first] += len(piece)
            ends = (b"\x0a\0\0\1", b"\x0a\0\0\2") if first else (b"\x0a\0\0\2", b"\x0a\0\0\1")
            ip = struct.pack(">BBHHHBBH", 0x45, 0, 40 + len(piece), number, 0, 64, 6, 0) + ends[0] + ends[1]
            out.write(struct.pack("<IIII", number, 0, 40 + len(piece), 40 + len(piece)) + ip + tcp + piece)


def dissected(pieces, protocol: str) -> list[list[str]]:
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "said.pcap"
        packets(pieces, path)
        answer = run("tshark", "-r", str(path), "-d", f"tcp.port==502,{protocol}", "-o", "mbrtu.crc_verification:TRUE", "-o", "tcp.check_checksum:FALSE",
                     "-T", "fields", "-E", "separator=|", "-e", "modbus.func_code", "-e", "_ws.malformed", "-e", "_ws.expert.message", "-e", "modbus.exception_code")
    return [line.split("|") for line in answer.stdout.splitlines()]


def judge(how: str, pieces, protocol: str) -> None:
    rows = dissected(pieces, protocol)
    same(f"{how}: packets", len(rows), len(pieces))
    functions = {int(row[0]) for row in rows if row[0]}
    same(f"{how}: functions seen", functions, {1, 3, 4, 15, 16})
    for (first, piece), row in zip(pieces, rows):
        check(f"{how}: {'question' if first else 'answer'} {piece.hex()}", row[0] != "" and row[1:] == ["", "", ""], row)
    spoilt = [(first, piece[:-1] + bytes([piece[-1] ^ 1]) if how == "RTU" else piece[:5] + bytes([piece[5] - 2]) + piece[6:])
              for first, piece in pieces]
    noticed = sum(row[1:3] != ["", ""] or row[0] == "" for row in dissected(spoilt, protocol))
    check(f"{how}: what is spoilt is noticed", noticed >= len(pieces) / 2, noticed)


def ask(link: str) -> None:
    answer = run(str(PROGRAMS / "modbus_station"), "ask", "triax-controller", link, *QUESTIONS)
    check(f"{link}: answers", answer.returncode == 0 and "mode = 2" in answer.stdout, answer.stdout)


with Station("modbus_station", "modbus-tcp://127.0.0.1:0/3") as station, socket.create_server(("127.0.0.1", 0)) as listener:
    port = int(station.links[0].split(":")[-1].split("/")[0])
    kept = []

    def relay():
        client, _ = listener.accept()
        server = socket.create_connection(("127.0.0.1", port))
        kept.extend([client, server, Relay([client.fileno(), server.fileno()])])

    threading.Thread(target=relay, daemon=True).start()
    ask(f"modbus-tcp://127.0.0.1:{listener.getsockname()[1]}/3")
    judge("TCP", kept[2].pieces, "mbtcp")

with SerialPair() as (ours, to_ours), SerialPair() as (theirs, to_theirs), Station("modbus_station", f"modbus-rtu://{ours}?unit=3") as station:
    ends = [os.open(end, os.O_RDWR | os.O_NOCTTY) for end in (to_theirs, to_ours)]
    relayed = Relay(ends)
    ask(f"modbus-rtu://{theirs}?unit=3")
    judge("RTU", relayed.pieces, "mbrtu")
verdict()
