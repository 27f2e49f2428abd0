# SPDX-License-Identifier: GPL-3.0-or-later
"""Requests that take long to compute are limited in number, time and memory, and end with their client; all the while light requests are answered.
Records are read by processes of their own, which leave nothing behind."""
import io
import json
import os
import re
import signal
import sqlite3
import time
import zipfile

from opened import Opened, same, within

HEADINGS = ("time_s", "stage", "axial_strain_pct", "deviator_stress_kPa", "mean_effective_stress_kPa")
MAIN = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
RELATIONS = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
PACKAGE = "http://schemas.openxmlformats.org/package/2006"


def workbook(rows, blanks):
    """A workbook whose sheet has so many blanks between two rows: a hundredth of it when packed."""
    kind = "application/vnd.openxmlformats-officedocument.spreadsheetml"
    parts = {
        "[Content_Types].xml": f'<Types xmlns="{PACKAGE}/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.'
                               f'relationships+xml"/><Override PartName="/xl/workbook.xml" ContentType="{kind}.sheet.main+xml"/>'
                               f'<Override PartName="/xl/worksheets/sheet1.xml" ContentType="{kind}.worksheet+xml"/></Types>',
        "_rels/.rels": f'<Relationships xmlns="{PACKAGE}/relationships"><Relationship Id="rId1" Type="{RELATIONS}/officeDocument" Target="xl/workbook.xml"/></Relationships>',
        "xl/workbook.xml": f'<workbook xmlns="{MAIN}" xmlns:r="{RELATIONS}"><sheets><sheet name="S" sheetId="1" r:id="rId1"/></sheets></workbook>',
        "xl/_rels/workbook.xml.rels": f'<Relationships xmlns="{PACKAGE}/relationships"><Relationship Id="rId1" Type="{RELATIONS}/worksheet" Target="worksheets/sheet1.xml"/></Relationships>',
    }
    cells = [(f'<row r="1">' + "".join(f'<c r="{chr(65 + i)}1" t="inlineStr"><is><t>{heading}</t></is></c>' for i, heading in enumerate(HEADINGS)) + "</row>")]
    for row in range(2, rows + 2):
        values = (row, 1, row * 1e-5, row * 1e-4, 100)
        cells.append(f'<row r="{row}">' + "".join(f'<c r="{chr(65 + i)}{row}"><v>{value:g}</v></c>' for i, value in enumerate(values)) + "</row>" + " " * blanks)
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name, text in parts.items():
            archive.writestr(name, text)
        with archive.open("xl/worksheets/sheet1.xml", "w", force_zip64=True) as sheet:
            sheet.write(f'<worksheet xmlns="{MAIN}"><sheetData>'.encode())
            for start in range(0, len(cells), 1000):
                sheet.write("".join(cells[start:start + 1000]).encode())
            sheet.write(b"</sheetData></worksheet>")
    return packed.getvalue()


def readers(page):
    """Numbers of the processes that read records for the page."""
    found = []
    for number in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{number}/stat", encoding="ascii", errors="replace") as stat:
                if int(stat.read().rpartition(")")[2].split()[1]) == page.program.pid:
                    found.append(int(number))
        except (FileNotFoundError, ProcessLookupError):
            pass
    return found


def about(process, what):
    with open(f"/proc/{process}/{what}", encoding="ascii") as file:
        return file.read()


def wait_for(what, seconds, is_true):
    until = time.monotonic() + seconds
    while not is_true():
        if time.monotonic() > until:
            raise SystemExit(f"{what}: not within {seconds} s")
        time.sleep(0.02)


def send(page, target, body, kind="application/octet-stream"):
    """A connection on which a request was sent; the caller reads the response, or closes it."""
    one = page.socket()
    one.sendall(f"POST {target} HTTP/1.1\r\nHost: {page.host}\r\nOrigin: http://{page.host}\r\nCookie: {page.cookie}\r\nX-Triax: 1\r\n"
                f"Content-Type: {kind}\r\nContent-Length: {len(body)}\r\n\r\n".encode() + body)
    return one


def slowest_light(page, seconds):
    """The longest time of a light request within so many seconds."""
    slowest, until = 0, time.monotonic() + seconds
    while time.monotonic() < until:
        for target in ("/api/tests", "/api/materials", "/"):
            begun = time.monotonic()
            same(f"GET {target}", page.ask("GET", target)[0], 200)
            slowest = max(slowest, time.monotonic() - begun)
        time.sleep(0.1)
    return slowest


def nothing_stored(page):
    """No test, no reading, and no file but the database."""
    if os.path.exists(page.database):
        with sqlite3.connect(page.database) as database:
            for table in ("tests", "scans", "leases", "work_points"):
                same(f"rows of {table}", database.execute(f"SELECT count(*) FROM {table}").fetchone()[0], 0)
        database.close()
    same("files", [name for name in os.listdir(page.folder) if not name.startswith("tests.db") or "waiting" in name], [])


with Opened() as page:
    page.enter()
    bomb = workbook(30_000, 25_000)

    # Four at once, a fifth is refused, and the page answers.
    clients = [send(page, "/api/records?name=b.xlsx", bomb) for _ in range(4)]
    wait_for("four processes", 10, lambda: len(readers(page)) == 4)
    reader = readers(page)[0]
    filtered = os.uname().machine in ("x86_64", "aarch64")
    wait_for("a confined process", 10, lambda: not filtered or "Seccomp:\t2" in about(reader, "status"))
    limits = about(reader, "limits")
    for limit in ("Max cpu time", "Max file size", "Max address space", "Max core file size"):
        same(f"{limit} is unlimited", re.search(f"{limit} +(\\S+)", limits).group(1) == "unlimited", False)
    refused, _, fields = page.ask("POST", "/api/records?name=b.xlsx", b"x")
    same("a fifth record", (refused, fields.get("Retry-After")), (503, "5"))
    within("seconds of a light request beside four workbooks", slowest_light(page, 2), 0, 1)
    within("memory of the page, kB", page.memory_kB(), 0, 200_000)
    for client in clients:
        client.close()
    begun = time.monotonic()
    wait_for("processes of clients that left end", 3, lambda: not readers(page))
    within("seconds until they ended", time.monotonic() - begun, 0, 1)
    nothing_stored(page)

    # One whose readings are in the database already.
    rows = b"".join(b"%d,%f,%f,100\n" % (i, i * 1e-5, i * 1e-4) for i in range(1_000_000))
    long_record = b"time_s,axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa\n" + rows
    client = send(page, "/api/records?name=long.csv", long_record)
    wait_for("the test runs", 20, lambda: page.json("/api/tests")["running"])
    client.close()
    wait_for("its process ends", 1, lambda: not readers(page))
    wait_for("the test goes", 5, lambda: not page.json("/api/tests")["tests"])
    nothing_stored(page)

    # One whose process is killed from outside.
    client = send(page, "/api/records?name=long.csv", long_record)
    wait_for("the test runs again", 20, lambda: page.json("/api/tests")["running"])
    os.kill(readers(page)[0], signal.SIGKILL)
    same("a killed process is reported", client.recv(12), b"HTTP/1.1 413")
    client.close()
    nothing_stored(page)

    # Heavy records of other forms: each ends with a response, and with its process.
    forms = {"line.csv": b"1," * (16 << 20), "quotes.csv": b'"' * (8 << 20), "heading.csv": (b"a" * 200 + b",") * 20_000 + b"\n1\n",
             "deep.xlsx": workbook(1, 0).replace(b"PK\x05\x06", b"PK\x05\x07"), "groups.ags": b'"GROUP","X"\r\n' * 200_000,
             "many.ags": b'"GROUP","TREG"\r\n"HEADING","LOCA_ID"\r\n' + b'"DATA","' + b"x" * 1_000_000 + b'"\r\n', "zeros.dat": b"\0" * (8 << 20)}
    for name, body in forms.items():
        client = send(page, f"/api/records?name={name}", body)
        client.settimeout(35)
        same(f"{name} is answered", client.recv(9), b"HTTP/1.1 ")
        client.close()
    wait_for("their processes end", 3, lambda: not readers(page))

    # Studies end with their client, and the next is computed.
    domain = json.dumps({"material": "cam_clay/check", "void_ratio": 0.8, "columns": 200, "rows": 200, "directions": 720, "p_from_kPa": 10, "p_to_kPa": 500,
                         "q_from_kPa": 0, "q_to_kPa": 500}).encode()
    states = {"material": "inl2/S28-general", "void_ratio": 1.086, "p_kPa": 70, "eta": [0.006 * i for i in range(100)]}
    same("360,000 directions", page.post("/api/probe", states | {"step_deg": 0.1})[0], 400)
    probe = json.dumps(states).encode()
    clients = [send(page, "/api/domain", domain, "application/json")] + [send(page, "/api/probe", probe, "application/json") for _ in range(20)]
    time.sleep(0.1)
    refused, _, fields = page.ask("POST", "/api/domain", domain)
    same("a second domain", (refused, fields.get("Retry-After")), (503, "5"))
    within("seconds of a light request beside studies", slowest_light(page, 2), 0, 1)
    for client in clients:
        client.close()
    small = {"material": "inl2/S28-general", "void_ratio": 1.086, "columns": 2, "rows": 2, "directions": 36}
    wait_for("a domain after that", 5, lambda: page.post("/api/domain", small)[0] == 200)

# A page that is killed takes its readers with it.
with Opened() as page:
    page.enter()
    client = send(page, "/api/records?name=b.xlsx", bomb)
    wait_for("a process", 10, lambda: readers(page))
    reader = readers(page)[0]
    page.program.kill()
    wait_for("the process ends", 2, lambda: not os.path.exists(f"/proc/{reader}/fd/0"))
    page.program.wait()
    page.program.terminate = lambda: None
    page.program.wait = lambda _: 0
print("heavy: limited")
