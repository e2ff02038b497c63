#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tiny jobs a second: how much of a job is not rendering.

    tests/bench/tiny_jobs.py BOUGUER [--jobs 1000] [--threads 2] [--submitters 4]

Starts a daemon on a folder of its own, submits jobs of 16 x 16 pixels and one sample from several connections, and
waits until all have ended. The last line has the jobs a second, from the first submit to the last end."""
import argparse
import http.client
import json
import os
import subprocess
import tempfile
import threading
import time

JOB = json.dumps({
    "format": "bouguer-job/1", "stop": {"samples": 1},
    "scene": {"format": "bouguer-scene/1", "name": "ball",
              "camera": {"type": "perspective", "from": [0, 1, 5], "at": [0, 1, 0], "up": [0, 1, 0], "fov_deg": 40,
                         "resolution": [16, 16]},
              "materials": {"grey": {"type": "hall", "reflectance": 0.5, "k_sr": 1, "n": 1}},
              "objects": [{"name": "ball", "shape": {"type": "sphere", "center": [0, 1, 0], "radius": 1},
                           "material": "grey"}],
              "lights": [{"type": "directional", "direction": [-1, -2, -1], "irradiance": "D65"}]}})


class Client:
    """One connection that is kept, and opened again when it was closed."""

    def __init__(self, port):
        self.port = port
        self.connection = None

    def ask(self, method, path, body=None):
        if self.connection is None:
            self.connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        try:
            self.connection.request(method, path, body, {"Content-Type": "application/json"} if body else {})
            answer = self.connection.getresponse()
            return answer.status, answer.read()
        except (http.client.HTTPException, ConnectionError):
            self.connection = None
            raise


def submit(port, count):
    client = Client(port)
    while count > 0:
        status, answer = client.ask("POST", "/v1/jobs", JOB)
        if status == 202:
            count -= 1
        elif status in (503, 507):
            time.sleep(0.02)
        else:
            raise SystemExit(f"status {status}: {answer.decode()}")


def wait_for_end(port):
    client = Client(port)
    for state in ("queued", "running"):
        while json.loads(client.ask("GET", f"/v1/jobs?state={state}&limit=1")[1])["jobs"]:
            time.sleep(0.02)
    return json.loads(client.ask("GET", "/v1/jobs?limit=100")[1])["jobs"]


def start(bouguer, folder, threads):
    data = os.path.join(folder, "data")
    daemon = subprocess.Popen([bouguer, "serve", "--listen", "127.0.0.1:0", "--data", data, "--threads", str(threads),
                               "--queue", "100000"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    for _ in range(200):
        try:
            with open(os.path.join(data, "port"), encoding="ascii") as file:
                return daemon, int(file.read())
        except (FileNotFoundError, ValueError):
            time.sleep(0.05)
    raise SystemExit("the daemon does not start")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bouguer")
    parser.add_argument("--jobs", type=int, default=1000)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--submitters", type=int, default=4)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="bouguer-bench.") as folder:
        daemon, port = start(options.bouguer, folder, options.threads)
        try:
            begin = time.monotonic()
            each = options.jobs // options.submitters
            threads = [threading.Thread(target=submit, args=(port, each)) for _ in range(options.submitters)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
            submitted = time.monotonic() - begin
            last = wait_for_end(port)
            seconds = time.monotonic() - begin
        except (http.client.HTTPException, ConnectionError) as error:
            raise SystemExit(f"the daemon is gone ({daemon.poll()}): {error!r}") from error
        finally:
            daemon.terminate()
            daemon.wait()
        states = {job["state"] for job in last}
        if states != {"done"}:
            raise SystemExit(f"jobs ended as {states}")
        count = each * options.submitters
        print(f"{count} jobs, {options.threads} render threads, {options.submitters} submitters: "
              f"{count / submitted:.0f} submits/s, {count / seconds:.0f} jobs/s")


if __name__ == "__main__":
    main()
