#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Clients that hold back: some ask for a picture and do not read it, some send a body byte by byte, some half a head.

    slow_clients.py --port-file FILE --job ID [--each N] [--seconds S] [--livez]

N of each kind for S seconds. With --livez, /livez must go on answering 200 meanwhile: exit code 1 when it does not.
"""
import argparse
import socket
import sys
import time

from daemon_client import DaemonClient

LONGEST_S = 10  # without an answer of /livez: no measure of speed, only of hanging


def connect(port):
    client = socket.socket()
    client.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    client.settimeout(1)
    client.connect(("127.0.0.1", port))
    return client


def unread(port, job):
    client = connect(port)
    client.sendall(f"GET /v1/jobs/{job}/image.exr HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n\r\n".encode())
    return client


def slow_body(port, _):
    client = connect(port)
    client.sendall(f"POST /v1/jobs HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nContent-Type: application/json\r\n"
                   "Content-Length: 2000000\r\n\r\n".encode())
    return client


def half_head(port, _):
    client = connect(port)
    client.sendall(f"GET /v1/jobs HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n".encode())
    return client


def open_all(port, job, each):
    """Clients by kind; those that the daemon does not want are fewer."""
    clients = {kind: [] for kind in (unread, slow_body, half_head)}
    for _ in range(each):
        for kind, opened in clients.items():
            try:
                opened.append(kind(port, job))
            except OSError:
                pass
    return clients


def drip(clients):
    for client in clients[slow_body]:
        try:
            client.send(b" ")
        except OSError:
            pass  # cut off, as it should be in the end


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--port-file", required=True)
    parser.add_argument("--job", required=True)
    parser.add_argument("--each", type=int, default=12)
    parser.add_argument("--seconds", type=float, default=2)
    parser.add_argument("--livez", action="store_true")
    arguments = parser.parse_args()
    with open(arguments.port_file, encoding="ascii") as file:
        port = int(file.read())
    daemon = DaemonClient(arguments.port_file)
    clients = open_all(port, arguments.job, arguments.each)
    end = time.monotonic() + arguments.seconds
    while time.monotonic() < end:
        drip(clients)
        if arguments.livez:
            answer = daemon.ask("GET", "/livez", timeout_s=LONGEST_S)
            if answer is None or answer.status != 200:
                print("slow clients: /livez says", "nothing" if answer is None else answer.status, file=sys.stderr)
                return 1
        time.sleep(0.1)
    return 0


if __name__ == "__main__":
    sys.exit(main())
