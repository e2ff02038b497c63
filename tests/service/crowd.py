#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A crowd around the daemon: silent connections of one address, watchers of a running job from a second, readers that do
not read the picture of a finished one from a third. Health is asked all the while from a fourth, and must be answered.

    tests/service/crowd.py BOUGUER                             the short form: 400 connections, 100 watchers, 20 readers
    tests/service/crowd.py BOUGUER 10000 4000 200 4096x2048    the long form: connections, watchers, readers, picture

Prints what was answered, the latencies of /livez and the daemon's memory. Fails when /livez is once refused or takes over
a second, or when an address that does nothing wrong is not served. Raises its own limit of descriptors as far as it may."""
import http.client
import json
import pathlib
import resource
import signal
import socket
import subprocess
import sys
import tempfile
import time

BUDGET_MIB = 512 + 64  # HttpLimits: bodies and answers in memory, events


class Daemon:
    """On a free port, in a folder that goes with it."""

    def __init__(self, binary):
        self.folder = tempfile.TemporaryDirectory(prefix="bouguer-crowd.")
        data = pathlib.Path(self.folder.name) / "data"
        command = [binary, "serve", "--listen", "127.0.0.1:0", "--data", data, "--threads", "1",
                   "--max-connections-per-address", "5000"]
        self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        port_file = data / "port"
        while not (port_file.exists() and port_file.read_text().strip()):
            if self.process.poll() is not None:
                sys.exit("the daemon does not start")
            time.sleep(0.05)
        self.port = int(port_file.read_text())

    def connect(self, source, timeout=10):
        return socket.create_connection(("127.0.0.1", self.port), timeout, (source, 0))

    def begin(self, source, path):
        """Asks for `path` and reads nothing; the socket."""
        s = self.connect(source)
        s.sendall(f"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{self.port}\r\n\r\n".encode())
        return s

    def ask(self, method, path, body=None, source="127.0.0.5"):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, 30, (source, 0))
        connection.request(method, path, body, {"Content-Type": "application/json"} if body else {})
        answer = connection.getresponse()
        text = answer.read()
        connection.close()
        return answer.status, text

    def submit(self, job):
        status, text = self.ask("POST", "/v1/jobs", json.dumps(job))
        assert status == 202, text
        return json.loads(text)["id"]

    def memory_mib(self, field):
        for line in open(f"/proc/{self.process.pid}/status", encoding="ascii"):
            if line.startswith(field + ":"):
                return int(line.split()[1]) // 1024
        return 0


def job(width, height, samples):
    return {"format": "bouguer-job/1", "stop": {"samples": samples}, "scene": {
        "format": "bouguer-scene/1", "name": "floor",
        "camera": {"type": "perspective", "from": [0, 1, 5], "at": [0, 1, 0], "fov_deg": 40, "resolution": [width, height]},
        "materials": {"grey": {"type": "hall", "reflectance": 0.5, "k_sr": 1}},
        "objects": [{"name": "floor", "shape": {"type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}, "material": "grey"}],
        "lights": [{"type": "directional", "direction": [-1, -2, -1], "irradiance": "D65"}]}}


def wait_for_end(daemon, job_id):
    while json.loads(daemon.ask("GET", f"/v1/jobs/{job_id}")[1])["state"] in ("queued", "running"):
        time.sleep(0.2)


def gather(count, make):
    """As many of `count` sockets as there can be."""
    sockets = []
    try:
        for _ in range(count):
            sockets.append(make())
    except OSError as error:
        print(f"  after {len(sockets)}: {error}")
    return sockets


def ask_health(daemon, seconds):
    """Milliseconds of every answer, and the statuses that were not 200."""
    spent, bad = [], []
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        begin = time.monotonic()
        try:
            status = daemon.ask("GET", "/livez", source="127.0.0.4")[0]
        except OSError as error:
            status = type(error).__name__
        spent.append((time.monotonic() - begin) * 1000)
        if status != 200:
            bad.append(status)
        time.sleep(0.005)
    return sorted(spent), bad


def main():
    binary = str(pathlib.Path(sys.argv[1]).resolve())
    connections, watchers, readers = (int(n) for n in (sys.argv[2:5] if len(sys.argv) > 4 else (400, 100, 20)))
    width, height = (int(n) for n in (sys.argv[5] if len(sys.argv) > 5 else "1024x512").split("x"))
    hard = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
    resource.setrlimit(resource.RLIMIT_NOFILE, (hard, hard))
    signal.signal(signal.SIGPIPE, signal.SIG_IGN)

    daemon = Daemon(binary)
    faults = []
    try:
        finished = daemon.submit(job(width, height, 1))
        wait_for_end(daemon, finished)
        running = daemon.submit(job(64, 48, 1_000_000))
        before = daemon.memory_mib("VmRSS")
        crowd = gather(watchers, lambda: daemon.begin("127.0.0.2", f"/v1/jobs/{running}/events"))
        watching = len(crowd)
        crowd += gather(connections, lambda: daemon.connect("127.0.0.1"))
        crowd += gather(readers, lambda: daemon.begin("127.0.0.3", f"/v1/jobs/{finished}/image.exr"))
        spent, bad = ask_health(daemon, 10 if connections > 1000 else 3)
        listed = daemon.ask("GET", "/v1/jobs")[0]
        served = sum(s.recv(15).startswith(b"HTTP/1.1 200") for s in crowd[:watching])
        after, peak = daemon.memory_mib("VmRSS"), daemon.memory_mib("VmHWM")
        print(f"{len(crowd)} sockets, {served} of {watching} watchers served, others {listed}")
        print(f"/livez: {len(spent) - len(bad)} of {len(spent)}, p50 {spent[len(spent) // 2]:.1f} ms, "
              f"p99 {spent[len(spent) * 99 // 100]:.1f} ms, at most {spent[-1]:.1f} ms")
        print(f"memory: {before} MiB before, {after} with the crowd, {peak} at most (while it rendered)")
        if bad or spent[-1] > 1000:
            faults.append(f"/livez: {bad[:5]}, {spent[-1]:.0f} ms")
        if served < min(watching, 5000) or listed != 200:
            faults.append("an address that does nothing wrong is not served")
        if after - before > BUDGET_MIB:
            faults.append("more memory than the budgets allow")
        for s in crowd:
            s.close()
    finally:
        daemon.process.kill()
        daemon.process.wait()
    sys.exit("FAILED: " + "; ".join(faults) if faults else 0)


if __name__ == "__main__":
    main()
