# SPDX-License-Identifier: GPL-3.0-or-later
"""Our serial port serves and asks over a pair of pseudo-terminals that socat makes."""
import os
import subprocess
import tempfile
import time

from judging import SCPI_STATION, Served, expect, needs, output_of

needs("socat")
with tempfile.TemporaryDirectory() as folder:
    ours, theirs = os.path.join(folder, "ours"), os.path.join(folder, "theirs")
    pair = subprocess.Popen(["socat", f"PTY,link={ours},rawer", f"PTY,link={theirs},rawer"])
    try:
        while not (os.path.exists(ours) and os.path.exists(theirs)):
            time.sleep(0.02)
        with Served("--serial", f"serial://{ours}?baud=19200&parity=even"):
            counts = [str(round(i + 1.25)) for i in range(8)]
            terminal = os.open(theirs, os.O_RDWR | os.O_NOCTTY)
            for request in (b"SS\r\n", b"SS\n", b"SS"):
                os.write(terminal, request)
                came = b""
                while came.count(b"\n") < 8:
                    came += os.read(terminal, 100)
                expect(came.decode().split(), counts, f"{request!r} over the pair")
            os.close(terminal)
            asked = output_of(SCPI_STATION, "--ask", f"serial://{theirs}?baud=19200", "SS")
            expect(asked.split(), counts[:1], "our line asks over the pair")
    finally:
        pair.terminate()
        pair.wait()
