# SPDX-License-Identifier: GPL-3.0-or-later
"""answers.py REQUESTS ROUNDS IDLE NAME=PORT...: lxi benchmark against each server in turn, ROUNDS times; then ours with
IDLE clients beside it. Prints the best rate of each and ours over the others."""
import re
import socket
import subprocess
import sys

requests, rounds, idle, *named = sys.argv[1:]
ports = dict(name.split("=") for name in named)


def rate(port):
    said = subprocess.run(["lxi", "benchmark", "-r", "-a", "127.0.0.1", "-p", port, "-c", requests],
                          capture_output=True, text=True, check=True).stdout
    return float(re.findall(r"Result: ([0-9.]+) requests/second", said)[-1])


best = dict.fromkeys(ports, 0.0)
for _ in range(int(rounds)):
    for name, port in ports.items():
        best[name] = max(best[name], rate(port))
beside = [socket.create_connection(("127.0.0.1", int(ports["ours"]))) for _ in range(int(idle))]
crowded = max(rate(ports["ours"]) for _ in range(int(rounds)))
for name, value in best.items():
    print(f"{name:12} {value:9.0f} questions/s" + (f"   ours/{name} {best['ours'] / value:.2f}" if name != "ours" else ""))
print(f"with {len(beside)} idle clients {crowded:.0f} questions/s: {crowded / best['ours']:.2f} of ours alone")
sys.exit(best["ours"] < 0.9 * best["asio-echo"] or best["ours"] < 2 * best["python"])
