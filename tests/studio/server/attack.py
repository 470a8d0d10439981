#!/usr/bin/env python3
"""Attacks a server of the studio, which it starts on a temporary folder, and checks after each attack that it still serves its page.
Prints a row for each attack: what was sent, what came back. Times are printed, but are never a failure.
Usage: attack.py BUILD"""

import contextlib
import hashlib
import http.client
import json
import os
import select
import socket
import subprocess
import sys
import tempfile
import time
import urllib.parse
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

BUILD = Path(sys.argv[1]).resolve()
PIECE = b"a" * 65536


class Server:
    def __init__(self, folder, page):
        request = {"folder": str(folder), "port": 0, "page": str(page), "page_data": {}, "browser": False,
                "engine": [str(BUILD / "bin/gsim"), "studio-answer", "--folder", str(folder)]}
        self.log = tempfile.TemporaryFile("w+")
        self.process = subprocess.Popen([BUILD / "bin/gsim-serve", json.dumps(request)], stdout=subprocess.PIPE, stderr=self.log, text=True)
        address = urllib.parse.urlparse(self.process.stdout.readline().strip())
        self.port, self.path = address.port, address.path
        self.token = self.path.strip("/")

    def connect(self, timeout_s=30):
        return socket.create_connection(("127.0.0.1", self.port), timeout=timeout_s)

    def head(self, method, path, headers=(), host=None):
        lines = [f"{method} {path} HTTP/1.1", f"Host: {host or f'127.0.0.1:{self.port}'}", *headers, "", ""]
        return "\r\n".join(lines).encode()

    def raw(self, *pieces, timeout_s=30):
        """Returns the first line and the end of the response, or "closed" if there is none."""
        with contextlib.closing(self.connect(timeout_s)) as connection:
            with contextlib.suppress(OSError):
                for piece in pieces:
                    connection.sendall(piece)
            answer = b""
            with contextlib.suppress(OSError):
                while got := connection.recv(65536):
                    answer += got
        return answer

    def get(self, path):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=30)
        try:
            connection.request("GET", self.path + path)
            answer = connection.getresponse()
            return answer.status, answer.read()
        finally:
            connection.close()

    def resident_kb(self):
        lines = Path(f"/proc/{self.process.pid}/status").read_text().splitlines()
        return int(next(line for line in lines if line.startswith("VmRSS")).split()[1])

    def descriptors(self):
        return len(os.listdir(f"/proc/{self.process.pid}/fd"))


def status(answer):
    return answer.split(b"\r\n", 1)[0].decode(errors="replace").removeprefix("HTTP/1.1 ") if answer else "closed"


def statuses(answers):
    return ", ".join(sorted({status(answer) for answer in answers}))


def strangers(server):
    """Requests that do not come from the page."""
    files = server.path + "files"
    yield "no token, another one, a part of it", "403", [
        server.raw(server.head("GET", path)) for path in ("/", "/files", "/" + "0" * 32 + "/files", server.path[:-2] + "/files")]
    yield "Host of another site (DNS rebinding), of another port, none, two", "403", [
        server.raw(server.head("GET", files, host=host)) for host in ("evil.example", f"evil.example:{server.port}", "127.0.0.1:1")] + [
        server.raw(f"GET {files} HTTP/1.1\r\n\r\n".encode()), server.raw(server.head("GET", files, ["Host: evil.example"]))]
    yield "Origin of another site, null, https", "403", [
        server.raw(server.head("POST", server.path + "ask", [f"Origin: {origin}", "Content-Length: 2"]), b"{}")
        for origin in ("http://evil.example", "null", f"https://127.0.0.1:{server.port}")]
    yield "a form and a script of another site (Sec-Fetch-Site)", "403", [
        server.raw(server.head("GET", files, [f"Sec-Fetch-Site: {site}"])) for site in ("cross-site", "same-site")]
    yield "DELETE, OPTIONS, TRACE, CONNECT, HEAD", "405", [
        server.raw(server.head(method, files)) for method in ("DELETE", "OPTIONS", "TRACE", "HEAD")]


def traversals(server, secret):
    """Paths out of the folder, to read and to write."""
    up = secret.name
    names = {
        "dots": [f"../{up}", f"sub/../../{up}", f"./../{up}"],
        "dots, encoded once and otherwise": [f"%2e%2e/{up}", f"%2e%2e%2f{up}", f"..%2f{up}", f"%c0%ae%c0%ae/{up}"],
        "dots, encoded twice (a file of that strange name in the folder)": [f"%252e%252e%252f{up}"],
        "backslashes, NUL, line ends": [f"..\\{up}", f"..%5c{up}", f"part.nc%00/../../{up}", f"part.nc%0a../{up}"],
        "absolute names": [f"/{secret}", f"%2f{secret}", "/proc/self/environ", "%2fetc/passwd"],
        "links to a file and to a folder": ["link.nc", f"up/{up}"],
        "hidden files": [".hidden", "sub/.hidden"],
    }
    for what, each in names.items():
        answers = []
        for name in each:
            path = f"{server.path}file/{name}"
            answers.append(server.raw(server.head("GET", path)))
            for version in ("If-None-Match: *", 'If-Match: "1-2-3"'):
                answers.append(server.raw(server.head("PUT", path, [version, "Content-Length: 3"]), b"bad"))
        assert not any(b"TOPSECRET" in answer for answer in answers), what
        expected = "404 412 200" if "twice" in what else "403 404 400"
        yield f"{what}: `{'`, `'.join(each[:2])}`, ...".replace(str(secret.parent), "/..."), expected, answers


def programs_that_reach_out(server, secret):
    """Files that the engine reads by the names in a program, a machine, a cell."""
    files = {"a.lua": f"local f = io and io.open('{secret}') print(f and f:read('a')) return require 'gsim'"}
    cell = f'[cell]\nname = "c"\nmachine = "../{secret.name}"\n'
    requests = [{"do": "run", "program": name} for name in (f"../{secret.name}", str(secret), "link.nc", "a.lua", "/proc/self/environ")]
    requests += [{"do": "run", "program": "part.nc", "machine": str(secret)}, {"do": "run", "program": "part.nc", "cell": "c.toml"},
                 {"do": "run", "program": "part.nc", "module": str(secret)}]
    answers = []
    for request in requests:
        body = json.dumps({"request": request, "files": {**files, "c.toml": cell}}).encode()
        answers.append(server.raw(server.head("POST", server.path + "ask", [f"Content-Length: {len(body)}"]), body))
    assert not any(b"TOPSECRET" in answer for answer in answers)
    assert all(b'"is":"failed"' in answer or b'"is":"report"' in answer for answer in answers)
    yield "programs, machines, cells, modules that name files outside", "200", answers


def too_much(server):
    """Requests that are too large."""
    ask = server.path + "ask"
    put = server.path + "file/large.nc"
    yield "an address of 1 MB", "414 400 403 closed", [server.raw(server.head("GET", server.path + "a" * 1_000_000))]
    yield "a header of 10 MB, 100,000 headers", "400 403 closed", [
        server.raw(server.head("GET", ask)[:-2], b"X: ", PIECE * 160, b"\r\n\r\n"),
        server.raw(server.head("GET", ask)[:-2], b"X: y\r\n" * 100_000, b"\r\n")]
    yield "a body of 1 GiB, announced: 64 MB of it come", "413", [server.raw(server.head("POST", ask, ["Content-Length: 1073741824"]), *[PIECE] * 1024)]
    yield "files of 4 MB in vain: no condition, another version, a hidden name", "428 412 403", [
        server.raw(server.head("PUT", server.path + f"file/{name}", [*headers, f"Content-Length: {64 * len(PIECE)}"]), *[PIECE] * 64)
        for name, headers in (("part.nc", []), ("part.nc", ['If-Match: "1-2-3"']), (".hidden", ["If-None-Match: *"]))]
    yield "a body of 1 GiB, sent in pieces", "413 400 closed", [
        server.raw(server.head("POST", ask, ["Transfer-Encoding: chunked"]), *[b"10000\r\n" + PIECE + b"\r\n"] * 16384)]
    yield "a file of 1 GiB to save", "413 400 closed", [
        server.raw(server.head("PUT", put, ["If-None-Match: *", "Transfer-Encoding: chunked"]), *[b"10000\r\n" + PIECE + b"\r\n"] * 16384)]
    bomb = subprocess.run(["gzip", "-c"], input=b"0" * 800_000_000, capture_output=True, check=True).stdout
    yield "800 MB of zeros as 0.8 MB of gzip", "413 400 closed", [
        server.raw(server.head("POST", ask, ["Content-Encoding: gzip", f"Content-Length: {len(bomb)}"]), bomb)]


def broken(server):
    """Malformed requests."""
    ask = server.path + "ask"
    chunked = server.head("POST", ask, ["Transfer-Encoding: chunked"])
    yield "broken chunks: no size, a negative one, one beyond 64 bits, none of the end", "400 closed", [
        server.raw(chunked, piece) for piece in (b"zz\r\n{}\r\n", b"-1\r\n{}\r\n", b"ffffffffffffffffff\r\n{}", b"2\r\n{}\r\n3\r\n")]
    yield "two lengths, a negative one, one that is no number", "400 413 closed 200", [
        server.raw(server.head("POST", ask, headers), b"{}") for headers in (["Content-Length: 2", "Content-Length: 9"], ["Content-Length: -5"], ["Content-Length: many"])]
    yield "JSON that is none, a million brackets, numbers beyond all bounds", "400 200", [
        server.raw(server.head("POST", ask, [f"Content-Length: {len(body)}"]), body)
        for body in (b"{", b"\xff\xfe", b"[" * 1_000_000, b'{"request":{"do":"run","blocks":1e999}}', b'{"request":7}', b'{"files":{"a":1}}')]
    yield "TLS, HTTP/2, WebSocket, noise", "400 403 closed", [
        server.raw(b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03" + bytes(200)), server.raw(b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n"),
        server.raw(server.head("GET", "/socket", ["Connection: Upgrade", "Upgrade: websocket"])), server.raw(os.urandom(4096) + b"\r\n\r\n")]
    yield "ranges without an end, two thousand of them", "200", [
        server.raw(server.head("GET", server.path + "file/part.nc", ["Range: bytes=" + ",".join(["0-0"] * 2000)]))]


def dripped_head(server):
    """Sends a head of one byte each 0.2 s. Measures how long the server listens to it."""
    began = time.monotonic()
    with server.connect() as drip, contextlib.suppress(OSError):
        for byte in server.head("GET", server.path + "files") * 100:
            drip.sendall(bytes([byte]))
            time.sleep(0.2)
    return time.monotonic() - began


def dripped_body(server):
    """Sends a body that is rejected, and continues with one byte each 0.2 s. Returns the response, and how long the server listens."""
    with server.connect() as drip:
        drip.sendall(server.head("PUT", server.path + "file/a.nc", ["Content-Length: 1073741824"]))
        answer = drip.recv(65536)
        began = time.monotonic()
        with contextlib.suppress(OSError):
            for _ in range(1000):
                drip.sendall(b"a")
                time.sleep(0.2)
    return answer, time.monotonic() - began


def stopped_body(server):
    """Sends a body that stops. Returns the response, and how long the server waits for the remainder."""
    began = time.monotonic()
    answer = server.raw(server.head("POST", server.path + "ask", ["Content-Length: 100"]), b"{", timeout_s=60)
    return answer, time.monotonic() - began


def slow(server):
    """Slow requests, and many requests at once."""
    began = time.monotonic()
    idle = [server.connect() for _ in range(1000)]
    opened = time.monotonic()
    assert server.get("files")[0] == 200
    answered = time.monotonic()
    yield f"1,000 connections that ask for nothing (opened in {opened - began:.1f} s); then the page asks: answered in {answered - opened:.2f} s", "closed", [b""]
    for connection in idle:
        connection.close()
    with ThreadPoolExecutor() as pool:
        head, body, stopped = (pool.submit(one, server) for one in (dripped_head, dripped_body, stopped_body))
        yield f"a head of one byte each 0.2 s: ended after {head.result():.1f} s", "closed", [b""]
        answer, listened_s = body.result()
        yield f"a body that is refused, and goes on by one byte each 0.2 s: ended after {listened_s:.1f} s", "413", [answer]
        answer, waited_s = stopped.result()
        yield f"a body that stops: ended after {waited_s:.1f} s", "400 closed", [answer]
    yield from many_at_once(server)


def many_at_once(server):
    refused = [server.connect() for _ in range(200)]
    for connection in refused:
        connection.sendall(server.head("PUT", server.path + "file/a.nc", ["Content-Length: 1073741824"]) + PIECE)
    began = time.monotonic()
    assert server.get("files")[0] == 200
    yield f"200 bodies of 1 GiB that do not end; then the page asks: answered in {time.monotonic() - began:.2f} s", "413", [refused[-1].recv(65536)]
    for connection in refused:
        connection.close()
    endless = {"request": {"do": "run", "program": "e.lua", "steps": 1e15}, "files": {"e.lua": "while true do end"}}
    body = json.dumps(endless).encode()
    asks = [server.connect() for _ in range(40)]
    for connection in asks:
        connection.sendall(server.head("POST", server.path + "ask", [f"Content-Length: {len(body)}"]) + body)
    # A rejected connection has a response to read.
    select.select(asks, [], [], 20)
    wait_for(lambda: engines(server) > 0)
    assert server.get("files")[0] == 200
    running = engines(server)
    assert running <= 8, running
    for connection in asks:
        connection.close()
    wait_for(lambda: engines(server) == 0)
    yield f"40 endless programs at once: {running} ran, and ended when those who asked had gone", "503", [b"HTTP/1.1 503 Service Unavailable\r\n"]


def engines(server):
    return len(subprocess.run(["pgrep", "-P", str(server.process.pid)], capture_output=True, text=True).stdout.split())


def wait_for(done, longest_s=20):
    end = time.monotonic() + longest_s
    while not done():
        assert time.monotonic() < end, "it does not come to rest"
        time.sleep(0.1)


def digest(paths):
    """Returns a digest of the files at these paths; links are not followed."""
    sum_ = hashlib.sha256()
    for path in sorted(paths):
        sum_.update(os.fsencode(path))
        if path.is_file() and not path.is_symlink():
            sum_.update(path.read_bytes())
    return sum_.hexdigest()


def main():
    with tempfile.TemporaryDirectory() as around:
        around = Path(around)
        folder = around / "served"
        (folder / "sub").mkdir(parents=True)
        secret = around / "secret.txt"
        secret.write_text("TOPSECRET")
        page = around / "page.html"
        page.write_text("<p><!-- server --></p>")
        (folder / "part.nc").write_text("G1 X10 F1000\nM30\n")
        (folder / ".hidden").write_text("TOPSECRET")
        (folder / "link.nc").symlink_to(secret)
        (folder / "up").symlink_to(around)
        (folder / "sub/deep.nc").write_text("G0\n")
        kept = [path for path in around.rglob("*") if "served" not in path.parts[-1:]]
        before = digest(kept)
        server = Server(folder, page)
        baseline = server.descriptors()
        [passed, failed] = [0, 0]
        print("| sent | came back |\n| --- | --- |")
        attacks = [strangers(server), traversals(server, secret), programs_that_reach_out(server, secret), broken(server), too_much(server), slow(server)]
        for what, expected, answers in (row for attack in attacks for row in attack):
            good = all(status(answer).split()[0] in expected for answer in answers) and server.get("files")[0] == 200
            print(f"| {what} | {statuses(answers)}{'' if good else ' **FAILED**'} |", flush=True)
            passed, failed = passed + good, failed + (not good)
        wait_for(lambda: server.descriptors() <= baseline)
        assert digest(kept) == before, "something was written"
        outside = {path.name for path in around.iterdir()}
        assert outside == {"served", "secret.txt", "page.html"}, outside
        print(f"\nresident memory at the end: {server.resident_kb() // 1024} MB")
        server.process.terminate()
        assert server.process.wait(20) == 0
        server.log.seek(0)
        assert server.token not in server.log.read(), "the log has the token"
    print(f"{passed} passed, {failed} failed")
    return 0 if failed == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
