# SPDX-License-Identifier: GPL-3.0-or-later
"""Proposals, previews and dialects of an import: hostile files and choices are refused in words, and write nothing outside of their folder."""
import json
import os
import urllib.parse

from opened import Opened, same, within

MB = 1 << 20
TABLE = b"time (s),axial strain (%),q (kPa),u (kPa)\n" + b"".join(b"%d,%f,%f,%f\n" % (i, i * 0.1, i * 2, 200 + i) for i in range(60))
COLUMNS = [{"quantity": name, "position": i + 1, "unit": unit} for i, (name, unit) in
           enumerate((("time", "s"), ("axial_strain", "%"), ("deviator_stress", "kPa"), ("pore_pressure", "kPa")))]


def sent(page, task, body, **query):
    status, content, _ = page.ask("POST", f"/api/records{task}?{urllib.parse.urlencode({'name': 'x.csv'} | query, doseq=True)}", body)
    return status, json.loads(content)


def left(page):
    return sorted(name for name in os.listdir(page.folder) if not name.startswith("tests.db"))


with Opened() as page:
    # Who has no cookie, or comes from another page, gets nothing.
    for path in ("/api/records/proposal?name=x", "/api/records/preview?name=x", "/api/dialects"):
        same(f"{path} without a cookie", page.ask("POST", path, b"{}", cookie=None)[0], 401)
    page.enter()
    for path in ("/api/records/proposal?name=x", "/api/records/preview?name=x", "/api/dialects"):
        same(f"{path} from another page", page.ask("POST", path, b"{}", Origin="http://elsewhere.example")[0], 403)
        same(f"{path} without the field of ours", page.ask("POST", path, b"{}", X_Triax=None)[0], 403)
        same(f"GET {path}", page.ask("GET", path)[0], 405)

    before = page.memory_kB()
    wide = b",".join(b"<b>\xff%d" % i * 20 for i in range(1000)) + b"\n" + b"\n".join([b"1," * 999 + b"1"] * 30)
    for what, body in (("nothing", b""), ("zeros", b"\0" * (16 * MB)), ("one line", b"1," * (8 * MB)), ("open quote", b'a,b\n"1,2\n' + b"3,4\n" * 100000),
                       ("wide", wide), ("archive", b"PK\x03\x04" + b"\0" * 1000), ("heading", b"h" * (MB - 10) + b",b\n1,2\n2,3\n3,4\n")):
        for task in ("/proposal", "/preview"):
            status, answer = sent(page, task, body)
            same(f"{what} {task}", status, 200)
            within(f"{what} {task}, bytes", len(json.dumps(answer)), 2, 500_000)
    # A result longer than a pipe holds waits until it is read.
    same("wide, again", {sent(page, "/proposal", wide)[0] for _ in range(15)}, {200})
    within("memory all that took, kB", page.memory_kB() - before, 0, 120_000)

    # A dialect of the browser is a text: it names no file, and what is wrong in it is said.
    for line in ("extends = \"../../etc/passwd\"", "name = \"x\\u0000\"", "[columns", "x" * 5000, "name = \"x\"", "/etc/passwd", page.database):
        status, answer = sent(page, "/preview", TABLE, dialect=[line])
        same(f"dialect {line[:20]!r}", (status, bool(answer["error"]), "root:" in answer["error"]), (200, True, False))
    status, _ = page.ask("POST", "/api/records/preview?name=x&dialect=a%0ab", TABLE)[:2]
    same("a line end in a dialect", status, 400)

    for wrong in ({}, [], 1, {"columns": "all"}, {"columns": COLUMNS + COLUMNS}, {"columns": [{"quantity": "time\n[test]\nname", "position": 1}]},
                  {"columns": COLUMNS, "key": "../../../../tmp/x"}, {"columns": COLUMNS, "key": "0" * 31 + "/"}, {"columns": COLUMNS, "values": {"a\nb": 1}},
                  {"columns": COLUMNS, "values": {"cell_pressure": "1\n[test]"}}, {"columns": COLUMNS, "block": 1e300},
                  *({"columns": [COLUMNS[0] | {"factor": factor}]} for factor in (0, -1, "2", [2], "1 }\n[test]")), {"columns": COLUMNS, "programme": 1}):
        status, answer = page.post("/api/dialects", wrong)
        same(f"choices {str(wrong)[:40]}", (status, bool(answer["error"])), (400, True))
    same("files left", left(page), [])

    status, answer = page.post("/api/dialects", {"columns": [COLUMNS[0], {"quantity": "axial_force", "position": 2, "unit": "N", "factor": 2.5}], "programme": "UU\"\n[test]\n"})
    same("a factor", (status, "factor = 2.5" in answer["dialect"], [line for line in answer["dialect"].splitlines() if line.startswith("[")]),
         (200, True, ["[table]", "[columns]", "[defaults]"]))

    # Texts of a file stay texts in the dialect that is stored.
    evil = "\"\n[specimen]\nheight_mm = \"x\"\n[columns]\n# "
    status, answer = page.post("/api/dialects", {"name": evil, "worksheet": evil, "columns": COLUMNS, "key": "a" * 32})
    same("a hostile name", (status, answer["file"]), (200, page.database + ".dialects/" + "a" * 32 + ".toml"))
    same("no table came of it", [line for line in answer["dialect"].splitlines() if line.startswith("[")], ["[table]", "[columns]"])

    # The choices read the file; what is remembered reads the next one.
    key = sent(page, "/proposal", TABLE)[1]["key"]
    status, answer = page.post("/api/dialects", {"name": "a", "columns": COLUMNS, "values": {"cell_pressure": 500}, "key": key})
    lines = answer["dialect"].splitlines()
    same("preview", sent(page, "/preview", TABLE, dialect=lines)[1]["readings"], 60)
    same("read", sent(page, "", TABLE, dialect=lines)[1]["test"], 1)
    rows = TABLE.split(b"\n", 1)[1]
    several = sent(page, "/preview", TABLE + rows + rows, dialect=lines)[1]
    same("preview of several tests", (several["tests"], several["shown"], several["readings"]), (3, 1, 60))
    several = sent(page, "", TABLE + rows, dialect=lines)[1]
    same("several tests", (several["test"], several["tests"], several["error"]), (2, [2, 3], None))
    long = b"".join(b"%d,%f,%f,%f\n" % (i, i * 0.01, i * 0.2, 200 + i * 0.01) for i in range(1500))
    head = TABLE.split(b"\n", 1)[0] + b"\n"
    several = sent(page, "/preview", head + long + long, dialect=lines)[1]
    same("preview of tests beyond the sample", (several["tests"], several["shown"], several["readings"]), (2, 1, 1500))
    several = sent(page, "", head + long + long, dialect=lines)[1]
    same("tests beyond the sample", (several["tests"], several["error"]), ([4, 5], None))
    answer = sent(page, "", TABLE, set="test.cell_pressure_kPa=400")[1]
    same("remembered", (answer["test"], answer["recognised"]["dialect"]), (6, "a"))
    same("files left", left(page), [])
print("import: refused")
