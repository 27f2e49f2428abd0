# SPDX-License-Identifier: GPL-3.0-or-later
"""mbpoll (libmodbus) reads and writes our controllers over TCP and over a serial line."""
import re

from judging import SerialPair, Station, check, needs, run, same, verdict

needs("mbpoll", "socat")


def values(text: str) -> list[float]:
    return [float(value) for value in re.findall(r"^\[\d+\]:\s+(\S+)", text, re.M)]


def judge(how: str, where: list[str], station: Station) -> None:
    def mbpoll(*options: str, unit="3", write=()):
        return run("mbpoll", "-q", "-1", "-o", "1", "-a", unit, *where[0], *options, "--", where[1], *write)

    def read(what: str, wanted: list[float], *options: str, unit="3") -> None:
        answer = mbpoll(*options, unit=unit)
        same(f"{how}: {what}", values(answer.stdout), wanted)

    # Registers are counted from 1: pressure at 0 is register 1. -t 3: input, 4: holding, 0: coil, 1: discrete.
    read("three floats, high word first", [3, 4, 5], "-t", "3:float", "-B", "-r", "1", "-c", "3")
    read("the same as holding registers", [3, 4, 5], "-t", "4:float", "-B", "-r", "1", "-c", "3")
    read("of the other unit", [4, 5, 6], "-t", "3:float", "-B", "-r", "1", "-c", "3", unit="4")
    read("whole numbers", [6, 7], "-t", "3", "-r", "7", "-c", "2")
    read("scaled", [30, 0, 50], "-t", "3", "-r", "101", "-c", "3")

    mbpoll("-t", "4:float", "-B", "-r", "21", write=("250.5", "-5"))
    same(f"{how}: two floats in one frame", station.new_lines(), ["unit 3: target_kPa = 250.5", "unit 3: rate_kPa_per_min = -5"])
    read("what was written", [250.5, -5], "-t", "4:float", "-B", "-r", "21", "-c", "2")
    mbpoll("-t", "4", "-r", "29", write=("2",))
    same(f"{how}: one register (function 6)", station.new_lines(), ["unit 3: mode = 2"])
    mbpoll("-t", "4", "-r", "121", write=("1000", "65511"))
    same(f"{how}: scaled registers, 65511 is -25", station.new_lines(), ["unit 3: target_kPa = 100", "unit 3: rate_kPa_per_min = -2.5"])
    mbpoll("-t", "0", "-r", "1", write=("1",))
    same(f"{how}: a coil (function 5)", station.new_lines(), ["unit 3: valve_open = 1"])
    read("the coil", [1], "-t", "0", "-r", "1", "-c", "1")
    read("the coil as discrete input", [1], "-t", "1", "-r", "1", "-c", "1")

    def refused(what: str, words: str, *options: str, unit="3", write=()) -> None:
        answer = mbpoll(*options, unit=unit, write=write)
        check(f"{how}: {what}", words in answer.stderr + answer.stdout, answer.stderr + answer.stdout)

    refused("nothing there", "Illegal data address", "-t", "3", "-r", "51", "-c", "1")
    refused("only read", "Illegal data address", "-t", "4", "-r", "7", write=("1",))
    refused("half a float", "Illegal data value", "-t", "4", "-r", "21", write=("1",))
    refused("above the limit", "Illegal data value", "-t", "4:float", "-B", "-r", "21", write=("5000",))
    same(f"{how}: nothing of these was applied", station.new_lines(), [])
    if how == "TCP":
        refused("a wrong unit, as by a gateway", "Target device failed to respond", "-t", "3", "-r", "1", "-c", "1", unit="9")
    else:
        refused("a wrong unit is silent", "timed out", "-t", "3", "-r", "1", "-c", "1", unit="9")


with SerialPair() as (ours, theirs), Station("modbus_station", "modbus-tcp://127.0.0.1:0/3", f"modbus-rtu://{ours}?unit=3") as station:
    port = station.links[0].split(":")[-1].split("/")[0]
    judge("TCP", [["-m", "tcp", "-p", port], "127.0.0.1"], station)
    judge("RTU", [["-m", "rtu", "-b", "9600", "-P", "none"], theirs], station)
verdict()
