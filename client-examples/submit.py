#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Submits a scene or a job to a Bouguer daemon, follows its events and saves what comes of it. Meshes and pictures that it
names by a path beside it are uploaded first, as far as the daemon lacks them.

    client-examples/submit.py client-examples/scenes/amber-ball.json --samples 64 --out amber

Standard library only. Exit code 1 when the job is refused or does not end well.
"""

import argparse
import hashlib
import json
import pathlib
import sys
import time
import urllib.error
import urllib.request


JSON = {"Content-Type": "application/json"}


def call(url, body=None, headers=None, method=None):
    """The bytes of an answer; a refusal is shown with every problem and ends the program."""
    request = urllib.request.Request(url, data=body, headers=headers or {}, method=method)
    try:
        with urllib.request.urlopen(request, timeout=60) as response:
            return response.read()
    except urllib.error.HTTPError as refusal:
        problem = json.loads(refusal.read() or b"{}")
        print(f"{refusal.code} {problem.get('title', '')}: {problem.get('detail', '')}", file=sys.stderr)
        for error in problem.get("errors", []):
            print(f"  {error.get('pointer') or '(document)'}: {error.get('detail')}", file=sys.stderr)
        sys.exit(1)


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


def events(url):
    """Yields (type, data) of the server-sent events until the stream ends; takes up a broken stream again."""
    last_id = None
    while True:
        headers = {"Accept": "text/event-stream"}
        if last_id:
            headers["Last-Event-ID"] = last_id
        kind, data = "message", []
        try:
            with urllib.request.urlopen(urllib.request.Request(url, headers=headers), timeout=60) as stream:
                for raw in stream:
                    line = raw.decode().rstrip("\r\n")
                    field, _, value = line.partition(":")
                    value = value.removeprefix(" ")
                    if field == "event":
                        kind = value
                    elif field == "data":
                        data.append(value)
                    elif field == "id":
                        last_id = value
                    elif not line and data:
                        yield kind, json.loads("\n".join(data))
                        kind, data = "message", []
        except (TimeoutError, ConnectionError):
            pass
        time.sleep(1)


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
    answer = json.loads(call(f"{arguments.url}/v1/jobs", json.dumps(job).encode(), JSON))
    where = f"{arguments.url}/v1/jobs/{answer['id']}"
    print("job", answer["id"])

    state = None
    for kind, data in events(f"{where}/events"):
        show(data.get("progress", data))
        if kind == "done":
            state = json.loads(call(where))["state"]
            break
    print()
    if state != "done":
        print(f"the job ended as {state}", file=sys.stderr)
        return 1
    out = arguments.out or arguments.document.stem
    for name, path in (("image.png", f"{out}.png"), ("image.exr", f"{out}.exr"), ("report", f"{out}.report.json")):
        pathlib.Path(path).write_bytes(call(f"{where}/{name}"))
        print("saved", path)
    return 0


if __name__ == "__main__":
    sys.exit(main())
