# SPDX-License-Identifier: GPL-3.0-or-later
"""Who is let in: one browser a token, by our names only, and changes only from our own page."""
import re

from opened import Opened, same

with Opened() as page:
    same("no cookie", page.ask("GET", "/api/tests", cookie=None)[0], 401)
    same("no cookie, first page", page.ask("GET", "/", cookie=None)[0], 401)
    same("no cookie, a file of the page", page.ask("GET", "/web/app.js", cookie=None)[0], 401)
    same("another cookie", page.ask("GET", "/api/tests", cookie=f"triax_{page.port}=0123456789abcdef0123456789abcdef")[0], 401)
    same("an empty cookie", page.ask("GET", "/api/tests", cookie=f"triax_{page.port}=")[0], 401)
    same("a wrong token", page.ask("GET", "/?token=" + "0" * 32, cookie=None)[0], 401)
    same("an empty token", page.ask("GET", "/?token=", cookie=None)[0], 401)
    same("a token by POST", page.ask("POST", f"/?token={page.token}", cookie=None)[0], 401)
    same("a token with a foreign Host", page.ask("GET", f"/?token={page.token}", cookie=None, Host="evil.example")[0], 403)

    with page.socket() as one:  # another method uses up no token, and HEAD has no body
        one.sendall(f"HEAD /?token={page.token} HTTP/1.1\r\nHost: {page.host}\r\nConnection: close\r\n\r\n".encode())
        come = b""
        while part := one.recv(65536):
            come += part
        same("HEAD", (come[:12], come.endswith(b"\r\n\r\n")), (b"HTTP/1.1 405", True))

    status, _, fields = page.ask("GET", f"/?token={page.token}", cookie=None)
    same("the token", status, 303)
    cookie = fields["Set-Cookie"]
    same("the cookie", ("HttpOnly" in cookie, "SameSite=Strict" in cookie, "Domain" in cookie), (True, True, False))
    page.cookie = cookie.split(";")[0]
    same("the token once more", page.ask("GET", f"/?token={page.token}", cookie=None)[0], 401)
    same("with the cookie", page.ask("GET", "/api/tests")[0], 200)
    same("among other cookies", page.ask("GET", "/api/tests", cookie=f"a=b; {page.cookie}; c=d")[0], 200)
    same("as part of another name", page.ask("GET", "/api/tests", cookie=f"x{page.cookie}")[0], 401)

    # Whoever lost access gets a new address at the terminal: Enter prints it.
    page.program.stdin.write("\n")
    page.program.stdin.flush()
    token = page.program.stdout.readline().strip().rpartition("=")[2]
    same("another token", (len(token), token != page.token), (32, True))
    same("it lets a browser in", page.ask("GET", f"/?token={token}", cookie=None)[0], 303)
    told = page.ask("GET", "/api/tests", cookie=None)[1].decode()
    same("how to get access", ("12 hours" in told, "7 days" in told, "Enter" in told), (True, True, True))
    same("the end of access", int(re.search("Max-Age=(\\d+)", cookie).group(1)), 7 * 24 * 3600)

    # A name of elsewhere that was led to this machine (DNS rebinding), with all that a browser would send along.
    for host in ("evil.example", f"evil.example:{page.port}", "127.0.0.1", f"127.0.0.1:{page.port + 1}", f"127.0.0.1:{page.port}.evil.example",
                 f"localhost.evil.example:{page.port}", f"[::2]:{page.port}", ""):
        same(f"Host {host!r}", page.ask("GET", "/api/tests", Host=host)[0], 403)
    for host in (f"localhost:{page.port}", f"LocalHost:{page.port}", f"[::1]:{page.port}"):
        same(f"Host {host!r}", page.ask("GET", "/api/tests", Host=host)[0], 200)

    # A page of another site.
    ours = f"http://127.0.0.1:{page.port}"
    for origin in ("http://evil.example", "null", f"http://127.0.0.1:{page.port + 1}", f"https://127.0.0.1:{page.port}", f"{ours}.evil.example",
                   f"http://evil.example:{page.port}", ""):
        same(f"Origin {origin!r}", page.ask("GET", "/api/tests", Origin=origin)[0], 403)
        same(f"POST, Origin {origin!r}", page.ask("POST", "/api/browsers", b"{}", Origin=origin)[0], 403)
    forged = f"evil.example:{page.port}"
    same("Origin equal to a forged Host", page.ask("POST", "/api/browsers", b"{}", Host=forged, Origin=f"http://{forged}")[0], 403)
    same("our Origin", page.ask("POST", "/api/browsers", b"{}")[0], 200)
    same("no Origin", page.ask("POST", "/api/browsers", b"{}", Origin=None)[0], 403)
    same("no field of ours", page.ask("POST", "/api/browsers", b"{}", X_Triax=None)[0], 403)
    same("another field", page.ask("POST", "/api/browsers", b"{}", X_Triax="0")[0], 403)
    same("cross-site", page.ask("POST", "/api/browsers", b"{}", Sec_Fetch_Site="cross-site")[0], 403)
    same("same-site, another port", page.ask("POST", "/api/browsers", b"{}", Sec_Fetch_Site="same-site")[0], 403)
    for site in ("cross-site", "same-site"):
        same(f"GET, {site}", page.ask("GET", "/api/tests", Sec_Fetch_Site=site)[0], 403)
    for site in ("same-origin", "none"):
        same(f"GET, {site}", page.ask("GET", "/api/tests", Sec_Fetch_Site=site)[0], 200)
    same("a change by GET", page.ask("GET", "/api/browsers")[0], 405)
    for method in ("PUT", "DELETE", "OPTIONS", "TRACE", "HEAD"):
        same(method, page.ask(method, "/api/tests")[0], 405)

    # What every answer says, also one that refuses.
    for target in ("/", "/api/tests", "/api/nothing", "/web/nothing.js"):
        fields = page.ask("GET", target)[2]
        same(f"{target}: nosniff", fields["X-Content-Type-Options"], "nosniff")
        policy = fields["Content-Security-Policy"]
        same(f"{target}: policy", ("default-src 'self'" in policy, "frame-ancestors 'none'" in policy, "unsafe" in policy), (True, True, False))
        same(f"{target}: leave for others", "Access-Control-Allow-Origin" in fields, False)

    # Paths that lead elsewhere.
    for path in ("/../../etc/passwd", "/web/../../../etc/passwd", "/web/%2e%2e/%2e%2e/etc/passwd", "/web/..%2f..%2fetc%2fpasswd",
                 "/web/..%5c..%5cetc", "/web/%00index.html", "/web//etc/passwd", "/web/%252e%252e/passwd", "//evil.example/web/app.js",
                 "/web/index.html/../../x", "/%", "/%zz", "http://evil.example/api/tests", "/api/tests/../tests", "/web/%c0%ae%c0%ae/x"):
        status, content, _ = page.ask("GET", path)
        same(f"{path} is refused", status in (400, 404), True)
        same(f"{path} gives nothing", b"root:" in content, False)
    for number in ("0", "-1", "1e3", "99999999999999999999", "1;drop", "%27", "1%20or%201"):
        same(f"test {number}", page.ask("GET", f"/api/tests/{number}")[0], 404)
    for query in ("from=x", "from=-1", "pixels=0", "pixels=100000000", "columns=q_kPa;DROP", "columns=1", "to=1e9"):
        same(f"window?{query}", page.ask("GET", f"/api/tests/1/window?{query}")[0], 400)
print("entry: refused")
