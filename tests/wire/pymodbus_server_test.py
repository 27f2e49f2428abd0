# SPDX-License-Identifier: GPL-3.0-or-later
"""Our questions against pymodbus' servers, over TCP and over a serial line."""
import multiprocessing
import struct
import time

from judging import PROGRAMS, SerialPair, check, free_port, needs, run, same, verdict

needs("socat", modules=("pymodbus", "serial_asyncio"))
from pymodbus.datastore import ModbusSequentialDataBlock, ModbusServerContext, ModbusSlaveContext  # noqa: E402
from pymodbus.server import StartSerialServer, StartTcpServer  # noqa: E402
try:
    from pymodbus.framer import FramerType  # noqa: E402: version 3.8 of Debian 13
    RTU_FRAMER = FramerType.RTU
except ImportError:
    from pymodbus.transaction import ModbusRtuFramer as RTU_FRAMER  # noqa: E402: version 3.0 of Debian 12


def instrument() -> ModbusServerContext:
    """A controller that stands still: its values, and registers that keep what is written."""
    words = [0] * 300
    words[0:8] = [*struct.unpack(">6H", struct.pack(">3f", 101.5, -2000, 102)), 1, 0]
    words[200:232] = struct.unpack(">32H", b"triax,pressure controller,py,1.0".ljust(64, b"\0"))
    block = ModbusSequentialDataBlock(1, words)  # pymodbus numbers from 1: address 0 of a request is number 1
    bits = ModbusSequentialDataBlock(1, [0] * 8)
    return ModbusServerContext(slaves={3: ModbusSlaveContext(di=bits, co=bits, ir=block, hr=block)}, single=False)


def serve_tcp(port: int) -> None:
    StartTcpServer(context=instrument(), address=("127.0.0.1", port))


def serve_serial(end: str) -> None:
    StartSerialServer(context=instrument(), framer=RTU_FRAMER, port=end, baudrate=9600, timeout=0.005)


def judge(how: str, link: str, wrong_unit: str) -> None:
    def ask(where: str, *wishes: str):
        return run(str(PROGRAMS / "modbus_station"), "ask", "triax-controller", where, *wishes)

    for _ in range(50):  # until it is there
        answer = ask(link, "pressure_kPa")
        if answer.returncode == 0:
            break
        time.sleep(0.1)
    same(f"{how}: identity and a value", answer.stdout.splitlines(),
         ["identity: triax,pressure controller,py,1.0", "pressure_kPa = 101.5"])
    answer = ask(link, "target_kPa=250.5", "rate_kPa_per_min=-5", "mode=2", "valve_open=1",
                 "target_kPa", "rate_kPa_per_min", "mode", "valve_open", "volume_mm3", "set_point_kPa", "piston", "watchdog")
    same(f"{how}: set and read", sorted(answer.stdout.splitlines()[1:]),
         sorted(["target_kPa = 250.5", "rate_kPa_per_min = -5", "mode = 2", "valve_open = 1", "volume_mm3 = -2000",
                 "set_point_kPa = 102", "piston = 1", "watchdog = 0"]))
    answer = ask(wrong_unit, "pressure_kPa")
    check(f"{how}: a wrong unit is no answer", "no answer" in answer.stdout and answer.returncode == 1, answer.stdout)


if __name__ == "__main__":
    with SerialPair() as (ours, theirs):
        port = free_port()
        servers = [multiprocessing.Process(target=serve_tcp, args=(port,)), multiprocessing.Process(target=serve_serial, args=(theirs,))]
        for server in servers:
            server.start()
        try:
            judge("TCP", f"modbus-tcp://127.0.0.1:{port}/3", f"modbus-tcp://127.0.0.1:{port}/4")
            judge("RTU", f"modbus-rtu://{ours}?unit=3", f"modbus-rtu://{ours}?unit=4")
        finally:
            for server in servers:
                server.terminate()
                server.join()
    verdict()
