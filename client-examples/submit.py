#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Submits a scene or a job to a Bouguer daemon, follows its events and saves what comes of it. Meshes and pictures that it
names by a path beside it are uploaded first, as far as the daemon lacks them.

    client-examples/submit.py client-examples/scenes/amber-ball.json --samples 64 --out amber

A daemon that restarts or is busy is waited for: everything is asked again until five minutes have passed without an
answer, and one submission stays one job. Standard library only. Exit code 1 when the job is refused or does not end well.
"""

import argparse
import hashlib
import http.client
import json
import pathlib
import random
import sys
import time
import urllib.error
import urllib.request
import uuid


JSON = {"Content-Type": "application/json"}
PATIENCE_S = 300  # without an answer
LONGEST_PAUSE_S = 5
ANSWER_TIMEOUT_S = 60  # that a connection may be silent
STREAM_TIMEOUT_S = 20  # likewise of events, where the daemon says something every 15 s at the least
TRY_AGAIN = {408, 429, 502, 503, 504, 507}  # statuses that pass; every other refusal is final
FINAL_STATES = {"done", "failed", "cancelled"}


class Failure(Exception):
    """Ends the program; its text is for the user."""


class Backoff:
    """The pauses between the attempts of one call: they double, are of random length so that not all clients come back
    at once, and end when PATIENCE_S are over."""

    def __init__(self):
        self.pause_s = 0.25
        self.end = time.monotonic() + PATIENCE_S
        self.said = False

    def wait(self, reason, retry_after=None):
        """Sleeps, for as long as the daemon asks if it does."""
        asked_s = int(retry_after) if (retry_after or "").isdigit() else 0
        pause_s = max(self.pause_s, asked_s) * random.uniform(1, 1.5)
        if time.monotonic() + pause_s > self.end:
            raise Failure(f"no answer within {PATIENCE_S} s: {reason}")
        if not self.said:
            print(f"\nno answer ({reason}); trying again for {PATIENCE_S} s", file=sys.stderr)
            self.said = True
        time.sleep(pause_s)
        self.pause_s = min(2 * self.pause_s, LONGEST_PAUSE_S)


def text_of(refusal):
    """Every problem of an answer that is an error [RFC 9457]."""
    try:
        problem = json.loads(refusal.read())
    except (OSError, http.client.HTTPException, ValueError):
        problem = {}  # of a proxy, say
    lines = [f"{refusal.code} {problem.get('title', refusal.reason)}: {problem.get('detail', '')}"]
    lines += [f"  {error.get('pointer') or '(document)'}: {error.get('detail')}" for error in problem.get("errors", [])]
    return "\n".join(lines)


def persist(attempt):
    """What `attempt` returns, tried again while nobody answers or the answer is that of a busy daemon or is torn. All
    that is asked here can be asked twice: a submission has its key."""
    backoff = Backoff()
    while True:
        try:
            return attempt()
        except urllib.error.HTTPError as refusal:
            if refusal.code not in TRY_AGAIN:
                raise Failure(text_of(refusal)) from refusal
            backoff.wait(f"{refusal.code} {refusal.reason}", refusal.headers.get("Retry-After"))
        except (OSError, http.client.HTTPException) as fault:  # URLError, ConnectionError, TimeoutError, IncompleteRead
            backoff.wait(getattr(fault, "reason", fault))


def call(url, body=None, headers=None, method=None):
    """The bytes of an answer."""
    def attempt():
        request = urllib.request.Request(url, data=body, headers=headers or {}, method=method)
        with urllib.request.urlopen(request, timeout=ANSWER_TIMEOUT_S) as response:
            return response.read()

    return persist(attempt)


def name_by_digest(scene, folder):
    """Names the files in `folder` that the scene names by a path by their digests instead; returns {digest: file}."""
    files = {}
    shapes = [thing["shape"] for thing in scene.get("objects", []) if thing.get("shape", {}).get("type") == "file"]
    images = [texture for texture in scene.get("textures", {}).values() if texture.get("type") == "image"]
    for thing in shapes + images:
        file = folder / thing.get("path", "")
        if file.is_file():
            thing["asset"] = "sha256-" + hashlib.sha256(file.read_bytes()).hexdigest()
            del thing["path"]
            files[thing["asset"]] = file
    return files


def upload(url, files):
    """Puts what the daemon does not have yet."""
    if not files:
        return
    question = json.dumps({"digests": list(files)}).encode()
    for digest in json.loads(call(f"{url}/v1/assets/missing", question, JSON))["missing"]:
        call(f"{url}/v1/assets/{digest}", files[digest].read_bytes(),
             {"Content-Type": "application/octet-stream"}, "PUT")
        print("uploaded", files[digest].name)


def submit(url, job):
    """The job's address. The key is one for all attempts: it makes them one submission."""
    key = {"Idempotency-Key": str(uuid.uuid4())}
    answer = json.loads(call(f"{url}/v1/jobs", json.dumps(job).encode(), JSON | key))
    print("job", answer["id"])
    for warning in answer["warnings"]:  # valid, and probably not meant
        print(f"warning: {warning['pointer']}: {warning['detail']}; {warning['advice']}", file=sys.stderr)
    return f"{url}/v1/jobs/{answer['id']}"


def events(stream):
    """Yields (type, data) of the server-sent events until the stream ends."""
    kind, data = "message", []
    for raw in stream:
        line = raw.decode(errors="replace").rstrip("\r\n")
        field, _, value = line.partition(":")
        value = value.removeprefix(" ")
        if field == "event":
            kind = value
        elif field == "data":
            data.append(value)
        elif not line and data:
            yield kind, json.loads("\n".join(data))
            kind, data = "message", []


def watch(where):
    """Shows the progress as long as the stream of events lasts."""
    request = urllib.request.Request(f"{where}/events", headers={"Accept": "text/event-stream"})
    try:
        with urllib.request.urlopen(request, timeout=STREAM_TIMEOUT_S) as stream:
            for kind, data in events(stream):
                show(data.get("progress", data))
                if kind == "done":
                    return
    except (OSError, http.client.HTTPException):
        pass  # the next question waits until it is answered, or says why not


def follow(where):
    """The state in which the job ends. A stream that ends may be broken, so the state is asked for."""
    while True:
        watch(where)
        state = json.loads(call(where))["state"]
        if state in FINAL_STATES:
            print()
            return state
        time.sleep(random.uniform(0.5, 1))


def show(progress):
    """One line: percent, samples, seconds, time left and the claimed error."""
    left = progress.get("seconds_left")
    error = progress.get("relative_rmse")
    if isinstance(error, dict):
        error = error.get("value")
    parts = [
        f"{100 * progress.get('fraction', 0):5.1f} %",
        f"{progress.get('samples', 0)} samples a pixel",
        f"{progress.get('seconds', 0):.1f} s",
        f"{left:.1f} s left" if left is not None else "",
        f"relative RMSE {error:.4f}" if error is not None else "",
    ]
    print("\r" + "  ".join(part for part in parts if part) + "\033[K", end="", flush=True)


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("document", type=pathlib.Path, help="a scene or a job in JSON")
    options.add_argument("--url", default="http://127.0.0.1:8080")
    options.add_argument("--samples", type=int, default=16, help="a pixel, for a bare scene")
    options.add_argument("--integrator", choices=["hall", "rgb"], default="hall", help="for a bare scene")
    options.add_argument("--out", help="beginning of the names of the files to write")
    arguments = options.parse_args()

    job = json.loads(arguments.document.read_text())
    if job.get("format") == "bouguer-scene/1":
        job = {"format": "bouguer-job/1", "scene": job,
               "integrator": {"type": arguments.integrator}, "stop": {"samples": arguments.samples}}
    upload(arguments.url, name_by_digest(job.get("scene", {}), arguments.document.parent))
    where = submit(arguments.url, job)
    state = follow(where)
    if state != "done":
        raise Failure(f"the job ended as {state}")
    out = arguments.out or arguments.document.stem
    for name, path in (("image.png", f"{out}.png"), ("image.exr", f"{out}.exr"), ("report", f"{out}.report.json")):
        pathlib.Path(path).write_bytes(call(f"{where}/{name}"))
        print("saved", path)


if __name__ == "__main__":
    try:
        main()
    except Failure as failure:
        sys.exit(str(failure))
