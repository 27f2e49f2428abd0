# SPDX-License-Identifier: GPL-3.0-or-later
"""Requests that are not valid HTTP/1.1 (RFC 9110, RFC 9112), or that ask for what the server does not support, get a status of their own, and the
connection ends: nothing of their body is taken for another request."""
import re

from opened import Opened, same


def answered(page, head, body=b"", method="POST", target="/api/probe", version="HTTP/1.1", host=True):
    """Statuses of all responses to one request of a browser that has access, with these header lines."""
    lines = [f"{method} {target} {version}"] + ([f"Host: {page.host}"] if host else [])
    lines += [f"Origin: http://{page.host}", f"Cookie: {page.cookie}", "X-Triax: 1", *head]
    with page.socket() as one:
        one.sendall("\r\n".join(lines).encode() + b"\r\n\r\n" + body)
        one.settimeout(10)
        come = b""
        try:
            while part := one.recv(65536):
                come += part
        except ConnectionError:
            pass
    return [int(status) for status in re.findall(rb"HTTP/1\.1 (\d{3}) ", come)]


with Opened() as page:
    page.enter()
    smuggled = f"GET /api/tests HTTP/1.1\r\nHost: {page.host}\r\nCookie: {page.cookie}\r\nConnection: close\r\n\r\n".encode()

    for coding in ("gzip", "identity", "gzip, chunked", "chunked, gzip", "chunked, chunked", "xchunked", "chunked;q=1", "\"chunked\""):
        for target in ("/api/probe", "/api/records?name=x.csv"):
            same(f"Transfer-Encoding: {coding}", answered(page, [f"Transfer-Encoding: {coding}"], smuggled, target=target), [501])
    same("Transfer-Encoding: gzip of a GET", answered(page, ["Transfer-Encoding: gzip"], smuggled, method="GET", target="/api/tests"), [501])
    for codings in (["gzip", "chunked"], ["chunked", "gzip"], ["chunked", "chunked"]):
        found = answered(page, [f"Transfer-Encoding: {coding}" for coding in codings], b"0\r\n\r\n" + smuggled)
        same(f"two Transfer-Encodings {codings}", found in ([400], [501]), True)
    for both in (["Content-Length: 5", "Transfer-Encoding: chunked"], ["Transfer-Encoding: chunked", "Content-Length: 5"],
                 ["Content-Length: 5", "Transfer-Encoding: gzip"]):
        same(f"{both}", answered(page, both, b"0\r\n\r\n" + smuggled), [400])
    same("Transfer-Encoding in HTTP/1.0", answered(page, ["Transfer-Encoding: chunked"], b"0\r\n\r\n" + smuggled, version="HTTP/1.0"), [400])

    for lengths in (["5", "5"], ["5", "6"], ["5, 5"], ["+5"], ["-5"], ["0x5"], ["5 5"], [""], ["5a"], ["99999999999999999999"]):
        same(f"Content-Length {lengths}", answered(page, [f"Content-Length: {length}" for length in lengths], b"{}   " + smuggled), [400])
    for chunks in (b"zz\r\n{}\r\n0\r\n\r\n", b"-2\r\n{}\r\n0\r\n\r\n", b"2\r\n{}xx0\r\n\r\n", b"fffffffffffffffff\r\n{}\r\n0\r\n\r\n", b"2 2\r\n{}\r\n0\r\n\r\n"):
        for target in ("/api/probe", "/api/records?name=x.csv"):
            same(f"chunks {chunks}", answered(page, ["Transfer-Encoding: chunked"], chunks + smuggled, target=target), [400])
    same("chunks that are right", answered(page, ["Transfer-Encoding: chunked", "Connection: close"], b"1;a=b\r\n{\r\n1\r\n}\r\n0\r\nX-After: 1\r\n\r\n"), [400])
    same("the same as a record", answered(page, ["Transfer-Encoding: Chunked", "Connection: close"], b"3\r\na,b\r\n0\r\n\r\n", target="/api/records?name=x.csv"), [200])

    same("Expect: 100-continue", answered(page, ["Expect: 100-Continue", "Content-Length: 2", "Connection: close"], b"[]"), [100, 400])
    same("Expect of something else", answered(page, ["Expect: 200-ok", "Content-Length: 2"], b"{}" + smuggled), [417])
    same("Expect of a stranger", answered(page, ["Expect: 100-continue", "Content-Length: 2", "Cookie: a=b", "Sec-Fetch-Site: cross-site"]), [403])

    for method in ("BREW", "get", "G@T"):
        same(f"method {method}", answered(page, [], method=method, target="/api/tests") in ([501], [400]), True)
    same("PUT", answered(page, ["Connection: close"], method="PUT"), [405])
    for version, status in (("HTTP/2.0", [505]), ("HTTP/1.2", [505]), ("HTTP/0.9", [505]), ("HTTP/1.", [505]), ("ICY/1.1", [505])):
        found = answered(page, [], method="GET", target="/api/tests", version=version)
        same(f"version {version}", found, status)
    same("no Host", answered(page, [], method="GET", target="/api/tests", host=False), [400])
    same("two Hosts", answered(page, [f"Host: {page.host}"], method="GET", target="/api/tests"), [400])

    for line in ("Name : value", "Na me: value", ": value", "no colon", "Name: a\0b"):
        same(f"field {line!r}", answered(page, [line, "Connection: close"], method="GET", target="/api/tests"), [400])
    same("a field of 20,000 bytes", answered(page, ["X-Long: " + "a" * 20_000], method="GET", target="/api/tests"), [431])
    same("a target of 20,000 bytes", answered(page, [], method="GET", target="/" + "a" * 20_000) in ([431], [414]), True)
    same("1,000 fields", answered(page, [f"X-{i}: {i:020}" for i in range(1000)], method="GET", target="/api/tests"), [431])
    same("who may is answered", page.ask("GET", "/api/tests")[0], 200)
print("http: refused")
