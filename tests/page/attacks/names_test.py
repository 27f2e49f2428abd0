# SPDX-License-Identifier: GPL-3.0-or-later
"""Names with HTML and scripts in every field that a record, a programme or a person can fill: text everywhere."""
import json
import re
import time

from opened import Opened, same

EVIL = "<script>alert(1)</script><img src=x onerror=alert(2)>\"'&"


def record():
    quoted = json.dumps(EVIL)
    head = f"""[test]
name = {quoted}
programme = {quoted}
[specimen]
height_mm = 140.0
diameter_mm = 70.0
material = {quoted}
[[stages]]
number = 1
name = {quoted}
role = "shear"
"""
    rows = "".join(f"{i},{i * 0.02:.3f},{i * 0.004:.4f},600,{500 + i * 0.1:.2f},0\n" for i in range(400))
    return ("".join(f"# {line}\n" for line in head.splitlines())
            + "time_s,axial_displacement_mm,axial_force_kN,cell_pressure_kPa,pore_pressure_kPa,back_volume_mm3\n" + rows).encode()


with Opened() as page:
    page.enter()
    name = "%3Cscript%3Ealert(3)%3C%2Fscript%3E.csv"
    status, content, fields = page.ask("POST", f"/api/records?name={name}", record())
    answer = json.loads(content)
    same("the record is taken", (status, answer["error"], answer["test"]), (200, None, 1))
    for target in ("/api/tests", "/api/tests/1", "/api/tests/1/window", "/api/tests/1/outline", "/api/tests/1/export?format=json"):
        status, content, fields = page.ask("GET", target)
        same(f"{target} is JSON", (status, fields["Content-Type"], fields["X-Content-Type-Options"]), (200, "application/json", "nosniff"))
        json.loads(content)
    same("the name is the name", page.json("/api/tests/1")["test"]["name"], EVIL)

    for target in ("/api/tests/1/sheet", "/api/tests/1/export?format=html"):
        status, content, fields = page.ask("GET", target)
        text = content.decode()
        same(f"{target} holds the name", (status, "&lt;script&gt;alert(1)" in text), (200, True))
        same(f"{target}: scripts", re.findall(r"<script|<img|onerror=(?!alert\(2\)&gt;)", text), [])
        same(f"{target} runs nothing", fields["Content-Security-Policy"].startswith("sandbox;"), True)
    fields = page.ask("GET", "/api/tests/1/export?format=csv")[2]
    same("the file's name", re.fullmatch(r'attachment; filename="[A-Za-z0-9._-]+"', fields["Content-Disposition"]) is not None, True)

    # Errors repeat what was asked for.
    for target in (f"/api/tests/1/export?format={name}", f"/api/tests/1/window?columns={name}", f"/{name}"):
        status, content, fields = page.ask("GET", target)
        same(f"{target} is told as JSON", (status in (400, 404), fields["Content-Type"]), (True, "application/json"))

    status, answer = page.post("/api/runs", {"programme": "icu_6", "speed": 60, "set": {"test.name": EVIL}})
    same("a run", status, 200)
    run = answer["test"]
    same("held", page.post(f"/api/runs/{run}/hold", {"who": EVIL}), (200, {"accepted": True}))
    for who in ("", "two\nlines", "x" * 101, 1, None):
        same(f"who {who!r}", page.post(f"/api/runs/{run}/stop", {"who": who})[0], 400)
    time.sleep(1)
    same("stopped", page.post(f"/api/runs/{run}/stop", {"who": EVIL})[0], 200)
    for _ in range(100):
        test = page.json(f"/api/tests/{run}")
        if test["test"]["status"] == "complete":
            break
        time.sleep(0.1)
    told = [event["detail"] for event in test["events"] if event["kind"] in ("held", "aborted")]
    same("who and when stand in the record", [detail.startswith(f"by {EVIL} on the page, 20") for detail in told], [True, True])
    same("of the other's test", page.post("/api/runs/1/stop", {"who": "x"})[0], 409)
print("names: text")
