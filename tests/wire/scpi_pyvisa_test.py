# SPDX-License-Identifier: GPL-3.0-or-later
"""pyvisa-py's sockets ask our instruments with their default of CR LF, and take a timed scan."""
import sys
import time

from judging import SKIPPED, Served, expect

sys.path.append("/usr/lib/python3/dist-packages")
try:
    import pyvisa
    import pyvisa_py  # noqa: F401: the back end "@py"
except ImportError as missing:
    print(f"skipped: {missing} (tools/packages-test.txt)")
    sys.exit(SKIPPED)

with Served() as served:
    visa = pyvisa.ResourceManager("@py")

    def instrument(name):
        return visa.open_resource(f"TCPIP0::127.0.0.1::{served.ports[name]}::SOCKET", read_termination="\n",
                                  timeout=5000)

    meter, scanner, pad = instrument("34401A"), instrument("34970A"), instrument("pad")
    expect(meter.write_termination, "\r\n", "pyvisa's own terminator")
    expect(meter.query("*IDN?").split(",")[1], "34401A", "identity")
    expect(float(meter.query("READ?")), 1.25, "volts")
    expect(meter.query("*OPC?"), "1", "*OPC?")
    meter.write("NONE")
    expect(meter.query("SYST:ERR?"), "-113,\"Undefined header; 'NONE'\"", "an error, asked for later")
    expect(meter.query("SYST:ERR?"), '0,"No error"', "and only once")

    scanner.write("ROUT:SCAN (@101:120,201)")
    scanner.write("TRIG:SOUR TIM;TIM 0.1;COUN 5")
    scanner.write("FORM:READ:TIME ON;CHAN ON")
    scanner.write("INIT")
    began = time.monotonic()
    while int(scanner.query("DATA:POIN?")) < 105 and time.monotonic() < began + 5:
        time.sleep(0.02)
    cells = scanner.query("DATA:REM? 105").split(",")
    expect(len(cells), 315, "readings with time and channel")
    expect([float(cell) for cell in cells[0:63:3]], [i + 1.25 for i in range(21)], "values of a scan")
    expect(cells[2:63:3], [str(c) for c in [*range(101, 121), 201]], "its channels")
    times = [float(cell) for cell in cells[1::63]]
    expect(all(abs(t - 0.1 * i) < 0.05 for i, t in enumerate(times)), True, f"instants of the scans: {times}")

    lines = [pad.query("SS")] + [pad.read() for _ in range(7)]
    expect([int(line) for line in lines], [round(i + 1.25) for i in range(8)], "eight lines of counts")
    for one in (meter, scanner, pad):
        one.close()
