# SPDX-License-Identifier: GPL-3.0-or-later
"""`triax open` with clients that take its streams as browsers do."""
import http.client
import json
import re
import socket
import subprocess
import sys
import time
import urllib.parse


def held(bounds):
    """What is asked, of WHAT: WHETHER it holds. Ends with 1 where one does not."""
    print(f"    asked: {', '.join(bounds)}")
    broken = [what for what, holds in bounds.items() if not holds]
    if broken:
        print(f"NOT held: {', '.join(broken)}", file=sys.stderr)
        sys.exit(1)


def share(values, part):
    values = sorted(values)
    return values[round(part * (len(values) - 1))]


class Page:
    """`triax open`, entered once."""

    def __init__(self, triax, database):
        self.database = database
        begun = time.monotonic()
        self.program = subprocess.Popen([triax, "open", "--db", database], stdout=subprocess.PIPE, text=True)
        self.address = self.program.stdout.readline().strip()
        self.started_s = time.monotonic() - begun
        self.kB = self.memory()
        parts = urllib.parse.urlparse(self.address)
        self.host = parts.netloc
        connection = http.client.HTTPConnection(self.host)
        connection.request("GET", "/?" + parts.query)
        answer = connection.getresponse()
        answer.read()
        self.cookie = answer.getheader("Set-Cookie").split(";")[0]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.program.terminate()
        self.program.wait()

    def memory(self, what="VmRSS"):
        with open(f"/proc/{self.program.pid}/status", encoding="ascii") as status:
            return int(re.search(rf"{what}:\s+(\d+)", status.read()).group(1))

    def get(self, target):
        connection = http.client.HTTPConnection(self.host)
        connection.request("GET", target, headers={"Cookie": self.cookie})
        answer = connection.getresponse()
        content = answer.read()
        if answer.status != 200:
            sys.exit(f"{target}: {answer.status} {content[:200]!r}")
        return content

    def post(self, target, value):
        connection = http.client.HTTPConnection(self.host)
        connection.request("POST", target, body=json.dumps(value),
                           headers={"Cookie": self.cookie, "Origin": f"http://{self.host}", "X-Triax": "1"})
        answer = connection.getresponse()
        content = json.loads(answer.read())
        if answer.status != 200:
            sys.exit(f"{target}: {content}")
        return content

    def run(self, readings_per_s):
        """A test that rests as long as it is let, two seconds between readings."""
        return self.post("/api/runs", {"programme": "csu_26", "speed": 2 * readings_per_s,
                                       "set": {"stages.4.end.1.above": 90000, "stages.4.time_limit_min": 100000}})["test"]


class Stream:
    """The events of a test, as a browser takes them."""

    def __init__(self, page, test, after=None):
        self.socket = socket.create_connection(("127.0.0.1", int(page.host.split(":")[1])))
        self.socket.settimeout(30)
        back = f"Last-Event-ID: {after}\r\n" if after else ""
        self.socket.sendall(f"GET /api/tests/{test}/live HTTP/1.1\r\nHost: {page.host}\r\nCookie: {page.cookie}\r\n{back}\r\n".encode())
        self.rest = b""
        self.head = False

    def events(self):
        """id, kind, data, as they come; ends with the connection."""
        while True:
            part = self.socket.recv(65536)
            if not part:
                return
            self.rest += part
            if not self.head:
                if b"\r\n\r\n" not in self.rest:
                    continue
                self.rest = self.rest.split(b"\r\n\r\n", 1)[1]
                self.head = True
            while b"\n\n" in self.rest:
                frame, self.rest = self.rest.split(b"\n\n", 1)
                fields = dict(line.split(": ", 1) for line in frame.decode().split("\n") if ": " in line and not line.startswith(":"))
                if "event" in fields:
                    yield fields.get("id"), fields["event"], json.loads(fields["data"])

    def close(self):
        self.socket.close()
