# SPDX-License-Identifier: GPL-3.0-or-later
"""lxi-tools ask our instruments: with a terminator, without one, and as fast as they can."""
import re

from judging import Served, expect, needs, output_of

needs("lxi")
IDENTITY = "HEWLETT-PACKARD,34970A,0,13-2-2"
with Served() as served:
    at = ["-r", "-a", "127.0.0.1", "-p", served.ports["34970A"]]
    expect(output_of("lxi", "scpi", *at, "*IDN?").strip(), IDENTITY, "lxi scpi -r")
    output_of("lxi", "scpi", *at, "ROUT:SCAN (@101:103)")
    expect(output_of("lxi", "scpi", *at, "ROUT:SCAN?").strip(), "#214(@101,102,103)", "a list of channels")
    values = output_of("lxi", "scpi", *at, "READ?").strip().split(",")
    expect([float(value) for value in values], [1.25, 2.25, 3.25], "a scan")
    interactive = output_of("lxi", "scpi", *at, "-i", input="*IDN?\nSYST:ERR?\n")
    expect(IDENTITY in interactive, True, "lxi scpi -r -i, which sends no terminator")
    expect('0,"No error"' in interactive, True, "and nothing was out of step")
    rate = output_of("lxi", "benchmark", *at, "-c", "200")
    found = re.findall(r"Result: ([0-9.]+) requests/second", rate)
    expect(len(found), 1, f"lxi benchmark -r: {rate.split(chr(13))[-1].strip()}")
