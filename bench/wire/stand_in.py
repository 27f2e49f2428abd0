# SPDX-License-Identifier: GPL-3.0-or-later
"""The other yardstick of bench/wire/run.sh: an instrument as one writes it in Python's socketserver. Prints its port."""
import socketserver


class StandIn(socketserver.StreamRequestHandler):
    disable_nagle_algorithm = True

    def handle(self):
        for line in self.rfile:
            if line.strip().upper() == b"*IDN?":
                self.wfile.write(b"HEWLETT-PACKARD,34401A,0,10-5-2\n")


server = socketserver.ThreadingTCPServer(("127.0.0.1", 0), StandIn)
server.daemon_threads = True
print(server.server_address[1], flush=True)
server.serve_forever()
