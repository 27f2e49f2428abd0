# SPDX-License-Identifier: GPL-3.0-or-later
"""Whoever sends too much or too slowly is cut off, takes little memory, and keeps nobody else from an answer."""
import os
import socket
import threading
import time

from opened import Opened, same, within


def rest(connection):
    """What comes until the server ends the connection."""
    come = b""
    try:
        while part := connection.recv(65536):
            come += part
    except (ConnectionError, socket.timeout):
        pass
    return come


def answered_in(page):
    begun = time.monotonic()
    same("who may is answered", page.ask("GET", "/api/tests")[0], 200)
    return time.monotonic() - begun


with Opened() as page:
    page.enter()
    before = page.memory_kB()

    # 10 MB of headers: in one field, and in many.
    for lines in ([b"X-Long: " + b"a" * 10_000_000], [b"X-%d: " % i + b"b" * 990 for i in range(10_000)]):
        with page.socket() as one:
            try:
                one.sendall(b"GET /api/tests HTTP/1.1\r\nHost: %s\r\n" % page.host.encode() + b"\r\n".join(lines) + b"\r\n\r\n")
            except ConnectionError:
                pass
            same("10 MB of headers", rest(one)[:13] in (b"HTTP/1.1 431 ", b""), True)

    # A body of JSON that never ends, and one that says that it is long.
    with page.socket() as one:
        one.sendall(f"POST /api/runs HTTP/1.1\r\nHost: {page.host}\r\nOrigin: http://{page.host}\r\nCookie: {page.cookie}\r\nX-Triax: 1\r\n"
                    "Transfer-Encoding: chunked\r\n\r\n".encode())
        sent = 0
        try:
            while sent < 1 << 30:
                one.sendall(b"10000\r\n" + b" " * 0x10000 + b"\r\n")
                sent += 0x10000
        except ConnectionError:
            pass
        within("bytes of an endless body until it was cut off", sent, 1 << 20, 80 << 20)
    same("a body of 2 GB", page.ask("POST", "/api/runs", b"{", Content_Length=str(2 << 30))[0], 413)
    same("a body of a stranger", page.ask("POST", "/api/runs", b"{", cookie=None, Content_Length=str(2 << 30))[0], 401)
    deep = b"[" * 500_000
    same("JSON half a million deep", page.ask("POST", "/api/runs", b'{"set":' + deep)[0], 400)
    for length in ("-1", "abc", "99999999999999999999999"):
        same(f"Content-Length {length}", page.ask("POST", "/api/runs", b"{", Content_Length=length)[0], 400)
    with page.socket() as one:  # two lengths, as smugglers send them
        one.sendall(f"POST /api/runs HTTP/1.1\r\nHost: {page.host}\r\nContent-Length: 4\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n".encode())
        same("two lengths", rest(one)[:12] in (b"HTTP/1.1 400", b"HTTP/1.1 401", b"HTTP/1.1 403"), True)
    with page.socket() as one:
        one.sendall(b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03" + bytes(range(256)) * 4 + b"\r\n\r\n")
        same("what is no HTTP", rest(one)[:12], b"HTTP/1.1 400")

    # A thousand connections that say nothing, beside a test that runs and is looked at.
    run = page.post("/api/runs", {"programme": "icu_6", "speed": 10})[1]["test"]
    live = page.socket()
    live.sendall(f"GET /api/tests/{run}/live HTTP/1.1\r\nHost: {page.host}\r\nCookie: {page.cookie}\r\n\r\n".encode())
    same("the stream", live.recv(12), b"HTTP/1.1 200")
    crowd = []
    for _ in range(1000):
        crowd.append(page.socket())
    within("seconds to an answer beside 1,000 connections", answered_in(page), 0, 1)
    within("files that are open", len(os.listdir(f"/proc/{page.program.pid}/fd")), 1, 300)

    streamed = b""
    live.settimeout(2)
    begun = time.monotonic()
    while time.monotonic() - begun < 1.5:
        streamed += live.recv(65536)
    within("readings in 1.5 s of a stream beside them", streamed.count(b"event: reading"), 5, 1000)
    for one in (live, *crowd):
        one.close()

    # Heads that come a byte a second.
    begun = time.monotonic()
    slow = [page.socket() for _ in range(200)]
    ended = []

    def drip(connection):
        text = f"GET /api/tests HTTP/1.1\r\nHost: {page.host}\r\n".encode()
        try:
            for byte in text:
                connection.sendall(bytes([byte]))
                connection.settimeout(1)
                try:
                    if not connection.recv(1):
                        break
                except socket.timeout:
                    pass
        except ConnectionError:
            pass
        ended.append(time.monotonic() - begun)

    threads = [threading.Thread(target=drip, args=[one]) for one in slow]
    for thread in threads:
        thread.start()
    within("seconds to an answer beside 200 slow heads", answered_in(page), 0, 1)
    for thread in threads:
        thread.join()
    within("seconds until the last slow head was cut off", max(ended), 5, 16)
    within("memory it took, kB", page.memory_kB() - before, 0, 40_000)
print("flood: cut off")
