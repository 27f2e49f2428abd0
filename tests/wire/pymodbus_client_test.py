# SPDX-License-Identifier: GPL-3.0-or-later
"""pymodbus 3 as a client of our controllers, over TCP and over a serial line."""
import struct

from judging import SerialPair, Station, check, needs, same, verdict

needs("socat", modules=("pymodbus", "serial_asyncio"))
from pymodbus.client import ModbusSerialClient, ModbusTcpClient  # noqa: E402


def words(*numbers: float) -> list[int]:
    return list(struct.unpack(f">{2 * len(numbers)}H", struct.pack(f">{len(numbers)}f", *numbers)))


def judge(how: str, client, station: Station) -> None:
    check(f"{how}: connects", client.connect())
    same(f"{how}: function 4", client.read_input_registers(0, count=8, slave=3).registers, [*words(3, 4, 5), 6, 7])
    same(f"{how}: function 3", client.read_holding_registers(0, count=8, slave=4).registers, [*words(4, 5, 6), 7, 8])
    identity = client.read_input_registers(200, count=32, slave=3).registers
    same(f"{how}: identity", struct.pack(">32H", *identity).rstrip(b"\0"), b"triax,pressure controller,3,1.0")

    same(f"{how}: function 16", client.write_registers(20, [*words(1.5, -2, 0.25, 3), 2], slave=3).isError(), False)
    same(f"{how}: in the order of addresses", station.new_lines(),
         [f"unit 3: {said}" for said in ("target_kPa = 1.5", "rate_kPa_per_min = -2", "flow_mm3_per_s = 0.25", "watchdog_s = 3", "mode = 2")])
    same(f"{how}: function 6", client.write_register(28, 1, slave=3).isError(), False)
    same(f"{how}: function 5", client.write_coil(0, True, slave=3).isError(), False)
    same(f"{how}: function 1", client.read_coils(0, count=1, slave=3).bits[0], True)
    same(f"{how}: function 15", client.write_coils(0, [False], slave=3).isError(), False)
    same(f"{how}: function 2", client.read_discrete_inputs(0, count=1, slave=3).bits[0], False)
    same(f"{how}: told", station.new_lines(), ["unit 3: mode = 1", "unit 3: valve_open = 1", "unit 3: valve_open = 0"])

    same(f"{how}: exception 2", client.read_input_registers(60, count=1, slave=3).exception_code, 2)
    same(f"{how}: exception 3, a float that is none", client.write_registers(20, [0x7FC0, 0], slave=3).exception_code, 3)
    same(f"{how}: exception 3, above the limit", client.write_registers(20, words(4000), slave=3).exception_code, 3)
    same(f"{how}: nothing of these was applied", station.new_lines(), [])
    for i in range(300):  # values that change, one frame each
        client.write_registers(20, words(i / 8), slave=4)
        same(f"{how}: {i} there and back", client.read_holding_registers(20, count=2, slave=4).registers, words(i / 8))
    station.new_lines()
    client.close()


with SerialPair() as (ours, theirs), Station("modbus_station", "modbus-tcp://127.0.0.1:0/3", f"modbus-rtu://{ours}?unit=3") as station:
    port = int(station.links[0].split(":")[-1].split("/")[0])
    judge("TCP", ModbusTcpClient("127.0.0.1", port=port, timeout=2), station)
    judge("RTU", ModbusSerialClient(theirs, baudrate=9600, timeout=2), station)
verdict()
