# SPDX-License-Identifier: GPL-3.0-or-later
"""`triax open` in a folder of its own, with a client that says just what it is told to say."""
import http.client
import json
import os
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import urllib.parse

TRIAX = os.environ.get("TRIAX", "build/release/triax")


class Opened:
    def __init__(self, *arguments):
        self.folder = tempfile.mkdtemp()
        self.database = os.path.join(self.folder, "tests.db")
        self.program = subprocess.Popen([os.path.abspath(TRIAX), "open", "--db", self.database, *arguments],
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.address = self.program.stdout.readline().strip()
        parts = urllib.parse.urlparse(self.address)
        self.host, self.port = parts.netloc, parts.port
        self.token = urllib.parse.parse_qs(parts.query)["token"][0]
        self.cookie = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.program.terminate()
        status = self.program.wait(20)
        shutil.rmtree(self.folder)
        assert status == 0, f"triax open ended with status {status}"

    def enter(self):
        status, _, fields = self.ask("GET", f"/?token={self.token}", cookie=None)
        assert status == 303, status
        self.cookie = fields["Set-Cookie"].split(";")[0]
        return self

    def ask(self, method, target, body=None, cookie="ours", **fields):
        """Status, body, fields. Fields replace those that a browser of ours would send; None leaves one out."""
        sent = {"Host": self.host, "Cookie": self.cookie if cookie == "ours" else cookie}
        if method == "POST":
            sent |= {"Origin": f"http://{self.host}", "X-Triax": "1", "Content-Length": str(len(body or b""))}
        sent |= {name.replace("_", "-"): value for name, value in fields.items()}
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        connection.putrequest(method, target, skip_host=True, skip_accept_encoding=True)
        for name, value in sent.items():
            if value is not None:
                connection.putheader(name, value)
        connection.endheaders()
        if body:
            connection.send(body)
        answer = connection.getresponse()
        content = answer.read()
        connection.close()
        return answer.status, content, dict(answer.getheaders())

    def json(self, target):
        status, content, _ = self.ask("GET", target)
        assert status == 200, (status, content[:300])
        return json.loads(content)

    def post(self, target, value):
        status, content, _ = self.ask("POST", target, json.dumps(value).encode())
        return status, json.loads(content)

    def socket(self):
        return socket.create_connection(("127.0.0.1", self.port), timeout=60)

    def memory_kB(self, what="VmHWM"):
        with open(f"/proc/{self.program.pid}/status", encoding="ascii") as status:
            return int(re.search(rf"{what}:\s+(\d+) kB", status.read()).group(1))


def same(what, found, wanted):
    if found != wanted:
        sys.exit(f"{what}: {found!r}, expected {wanted!r}")


def within(what, found, least, most):
    if not least <= found <= most:
        sys.exit(f"{what}: {found}, expected from {least} to {most}")
