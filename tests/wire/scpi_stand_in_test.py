# SPDX-License-Identifier: GPL-3.0-or-later
"""Our line asks an instrument that is written in Python with its own socket server."""
import socketserver
import threading
import time

from judging import SCPI_STATION, expect, output_of


class StandIn(socketserver.StreamRequestHandler):
    def handle(self):
        self.target = 0.0
        for line in self.rfile:
            word, *rest = line.decode().split()
            if word == "*IDN?":
                self.say("stand-in,1,2,3\n")
            elif word == "TARG":
                self.target = float(rest[0])
            elif word == "TARG?":
                for piece in f"{self.target}\r\n":
                    self.say(piece)
                    time.sleep(0.002)
            elif word == "BYE?":
                return

    def say(self, text):
        self.wfile.write(text.encode())


server = socketserver.ThreadingTCPServer(("127.0.0.1", 0), StandIn)
server.daemon_threads = True
threading.Thread(target=server.serve_forever, daemon=True).start()
link = f"tcp://127.0.0.1:{server.server_address[1]}"
said = output_of(SCPI_STATION, "--ask", link, "*IDN?", "TARG 12.5", "TARG?", "*IDN?")
expect(said.split(), ["stand-in,1,2,3", "12.5", "stand-in,1,2,3"], "answers, one in pieces, in their order")
try:
    output_of(SCPI_STATION, "--ask", link, "*IDN?", "BYE?", "TARG?")
except SystemExit as ended:
    expect(str(ended).splitlines()[1:], ["stand-in,1,2,3"] + 2 * ["closed by the other side"], "a server that goes")
else:
    raise SystemExit("a server that goes was not noticed")
