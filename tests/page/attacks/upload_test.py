# SPDX-License-Identifier: GPL-3.0-or-later
"""Records that are none take little memory, and of the disk at most four times the 512 MB that one may have, while they come; they are told in words."""
import json
import os
import time

from opened import Opened, same, within

MB = 1 << 20


def left_by(page):
    """Files in the folder, and those that have no name any more but are held open by the program."""
    held = []
    for number in os.listdir(f"/proc/{page.program.pid}/fd"):
        try:
            to = os.readlink(f"/proc/{page.program.pid}/fd/{number}")
        except FileNotFoundError:
            continue
        if to.startswith(page.folder) and "(deleted)" in to:
            held.append(to)
    return sorted(name for name in os.listdir(page.folder) if not name.startswith("tests.db")) + held


def nothing_left(page):
    until = time.monotonic() + 5
    while left_by(page) and time.monotonic() < until:  # the last part of a body may be under way
        time.sleep(0.05)
    same("files left", left_by(page), [])


def slow_record(page):
    """A record of which only the beginning comes; what is answered is read by the caller."""
    one = page.socket()
    one.sendall(f"POST /api/records?name=slow.csv HTTP/1.1\r\nHost: {page.host}\r\nOrigin: http://{page.host}\r\nCookie: {page.cookie}\r\n"
                "X-Triax: 1\r\nContent-Length: 1000000\r\n\r\ntime_s".encode())
    return one


def chunked(page, megabytes):
    """A record of zeros whose length is not said; how much was taken."""
    part = b"%x\r\n" % MB + b"\0" * MB + b"\r\n"
    with page.socket() as one:
        one.sendall(f"POST /api/records?name=zeros.csv HTTP/1.1\r\nHost: {page.host}\r\nOrigin: http://{page.host}\r\nCookie: {page.cookie}\r\n"
                    "X-Triax: 1\r\nTransfer-Encoding: chunked\r\n\r\n".encode())
        sent = 0
        try:
            for _ in range(megabytes):
                one.sendall(part)
                sent += 1
        except ConnectionError:
            pass
        return sent


with Opened() as page:
    page.enter()
    before = page.memory_kB()
    begun = time.monotonic()
    status, content, _ = page.ask("POST", "/api/records?name=zeros.csv", b"\0" * MB, Content_Length=str(2 << 30))
    same("2 GB of zeros", (status, b"512 MB" in content), (413, True))
    within("seconds", time.monotonic() - begun, 0, 5)
    within("MB taken of 2 GB whose length is not said", chunked(page, 2048), 512, 600)

    answer = json.loads(page.ask("POST", "/api/records?name=zeros.csv", b"\0" * (64 * MB))[1])
    same("64 MB of zeros", (answer["test"], "NUL" in answer["error"]), (None, True))
    answer = json.loads(page.ask("POST", "/api/records?name=line.csv", b"1," * (32 * MB))[1])
    same("a line of 64 MB", (answer["test"], bool(answer["error"])), (None, True))
    answer = json.loads(page.ask("POST", "/api/records?name=nothing.csv", b"")[1])
    same("nothing", (answer["test"], bool(answer["error"])), (None, True))
    within("memory all that took, kB", page.memory_kB() - before, 0, 120_000)
    nothing_left(page)

    # Four records that come slowly: they are seen in the program, and a fifth is refused.
    slow = [slow_record(page) for _ in range(4)]
    until = time.monotonic() + 5
    while len(left_by(page)) < 4 and time.monotonic() < until:
        time.sleep(0.05)
    same("records that come", len(left_by(page)), 4)
    with slow_record(page) as fifth:
        same("a fifth record", fifth.recv(12), b"HTTP/1.1 503")
    for one in slow:
        one.close()
    nothing_left(page)

    record = b"time_s,axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa\n" + b"".join(
        b"%d,%f,%f,100\n" % (i, i * 0.01, i * 0.5) for i in range(200))
    for name in ("../../../etc/cron.d/x", "/etc/passwd", "..\\..\\x.csv", "x" * 201, "a%0d%0aSet-Cookie:%20x"):
        status, content, fields = page.ask("POST", f"/api/records?name={name}", record)
        same(f"name {name[:30]!r}", status in (200, 400), True)
        same("no field of theirs", "Set-Cookie" in fields, False)
    for key in ("test.origin=simulated", "nothing=1", "specimen.height_mm=", "=", "specimen.height_mm=nan"):
        status, content, _ = page.ask("POST", f"/api/records?name=x.csv&set={key.replace('=', '%3D')}", record)
        same(f"set {key}", status == 400 or bool(json.loads(content)["error"]), True)
    nothing_left(page)

    # Programmes must name nothing of this machine.
    programme = '[test]\nname = "x"\ntype = "ICU"\nseed = 1\nscan_interval_s = 1.0\n[specimen]\nmaterial = "umat/x"\nmaterial_file = "/etc/passwd"\n'
    status, answer = page.post("/api/runs", {"programme": programme})
    same("a file of this machine", (status, "root" in str(answer)), (400, False))
    # The answer does not depend on the path: it says nothing about the files of this machine.
    grains = programme.replace('material = "umat/x"\nmaterial_file = "/etc/passwd"', 'grains = "%s"')
    for path in ("/etc/passwd", "/nonexistent", "/tmp", "/dev/zero", "../../../etc/passwd", "~/.ssh/id_rsa", page.database, ""):
        for asked in ({"programme": grains % path}, {"programme": "icu_6", "set": {"specimen.material_file": path}},
                      {"programme": "icu_6", "set": {"specimen.grains": path}}):
            status, answer = page.post("/api/runs", asked)
            same(f"the file {path!r}", (status, "cannot use files of this computer" in str(answer)), (400, True))
    for name in ("../../etc/passwd", "/etc/passwd", "nothing", ""):
        same(f"programme {name!r}", page.post("/api/runs", {"programme": name})[0], 400)
    for wrong in ({}, [], {"programme": 1}, {"programme": "icu_6", "speed": -1}, {"programme": "icu_6", "speed": "fast"}, {"programme": "icu_6", "seed": 0.5},
                  {"programme": "icu_6", "set": {"specimen.void_ratio": []}}, {"programme": "icu_6", "rig": True, "speed": 1}, {"programme": "icu_6", "rig": "yes"}):
        same(f"run {wrong}", page.post("/api/runs", wrong)[0] in (400, 409), True)
print("upload: refused")
