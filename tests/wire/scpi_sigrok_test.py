# SPDX-License-Identifier: GPL-3.0-or-later
"""sigrok-cli takes our 34401A for one and reads its volts."""
import subprocess

from judging import Served, expect, needs, output_of

needs("sigrok-cli")
with Served() as served:
    device = f"scpi-dmm:conn=tcp-raw/127.0.0.1/{served.ports['34401A']}"
    scan = output_of("sigrok-cli", "-d", device, "--scan")
    expect("34401A" in scan, True, "sigrok's scan names the model")
    # Its status is not looked at: Debian 12's ends in an assertion of its own after the last sample.
    samples = subprocess.run(["sigrok-cli", "-d", device, "--samples", "3", "-O", "analog"], capture_output=True,
                             text=True, timeout=30)
    values = [line.split()[1] for line in samples.stdout.splitlines() if line.startswith("P1:")]
    expect(len(values), 3, "three samples")
    expect({float(value) for value in values}, {1.25}, "volts of each")
