#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A reverse proxy that loses answers, to try clients with. The first request of every kind of client (User-Agent) whose
request line matches PATTERN reaches the daemon, but of the answer only the first BYTES come through. The proxy then writes a
line into CUTS and holds the connection until a file CUTS.over exists. All other requests are passed on; while the daemon is
away they get 502, as from any proxy.

    cutting_proxy.py DAEMON_PORT PORT_FILE CUTS PATTERN BYTES      listens on a free port, which it writes into PORT_FILE
"""
import os
import pathlib
import re
import socket
import socketserver
import sys
import threading
import time

BAD_GATEWAY = b"HTTP/1.1 502 Bad Gateway\r\nContent-Type: text/html\r\nContent-Length: 4\r\nConnection: close\r\n\r\n502\n"


def read_request(client, host):
    """The lines of the head of the one request that a connection may have, and the request as it is passed on: to `host`, and
    with the wish that the connection be closed."""
    data = b""
    while b"\r\n\r\n" not in data:
        piece = client.recv(65536)
        if not piece:
            return None, None
        data += piece
    head, _, body = data.partition(b"\r\n\r\n")
    length = re.search(rb"\r\ncontent-length: *(\d+)", head, re.I)
    while length and len(body) < int(length[1]):
        body += client.recv(65536)
    lines = [line for line in head.split(b"\r\n") if not line.lower().startswith((b"connection:", b"host:"))]
    return lines, b"\r\n".join([*lines, b"Host: " + host, b"Connection: close\r\n\r\n"]) + body


class Proxy(socketserver.ThreadingTCPServer):
    daemon_threads = True
    allow_reuse_address = True

    def __init__(self, upstream_port, cuts, pattern, limit):
        super().__init__(("127.0.0.1", 0), Connection)
        self.upstream = ("127.0.0.1", upstream_port)
        self.cuts, self.pattern, self.limit = pathlib.Path(cuts), re.compile(pattern.encode()), limit
        self.lock = threading.Lock()
        self.agents = set()  # whose answer was cut; guarded by lock

    def handle_error(self, request, client_address):
        pass  # clients and daemon go away in the middle: that is what this is for

    def is_to_be_cut(self, lines):
        if not self.pattern.match(lines[0]):
            return False
        agent = next((line.split(b"/")[0] for line in lines if line.lower().startswith(b"user-agent:")), b"")
        with self.lock:
            is_first = agent not in self.agents
            self.agents.add(agent)
        return is_first

    def cut(self):
        with self.lock, self.cuts.open("a") as file:
            file.write("cut\n")
        while not os.path.exists(f"{self.cuts}.over"):
            time.sleep(0.02)


class Connection(socketserver.BaseRequestHandler):
    def handle(self):
        lines, request = read_request(self.request, b"%s:%d" % (self.server.upstream[0].encode(), self.server.upstream[1]))
        if lines is None:
            return
        is_cut = self.server.is_to_be_cut(lines)
        try:
            upstream = socket.create_connection(self.server.upstream)
        except OSError:
            self.request.sendall(BAD_GATEWAY)
            return
        with upstream:
            upstream.sendall(request)
            sent = 0
            while answer := upstream.recv(65536):
                if is_cut and sent + len(answer) > self.server.limit:
                    self.request.sendall(answer[:self.server.limit - sent])
                    self.server.cut()
                    return
                self.request.sendall(answer)
                sent += len(answer)


def main():
    upstream_port, port_file, cuts, pattern, limit = sys.argv[1:]
    with Proxy(int(upstream_port), cuts, pattern, int(limit)) as proxy:
        pathlib.Path(port_file).write_text(str(proxy.server_address[1]))
        proxy.serve_forever()


if __name__ == "__main__":
    main()
