#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Posts jobs to a daemon that is disturbed meanwhile, and writes down what the daemon acknowledged.

    submitters.py --port-file FILE --jobs FOLDER --ledger FILE [--seed N] [--threads N]

FOLDER has the job documents, KIND.json. Every job has an Idempotency-Key and is posted until it is acknowledged; some
are posted again, cancelled or deleted. Runs until SIGTERM, then ends what it began. The ledger has one JSON object a
job: kind, key, id, and what was acknowledged last: "submit", "cancel" (with the state that was answered) or "delete".
Exit code 1 when the daemon said what it must not: a refusal without Retry-After, a 500, another job for the same key.
"""
import argparse
import collections
import json
import pathlib
import random
import signal
import sys
import threading
import time

from daemon_client import DaemonClient

OUTSTANDING = 3  # jobs of one submitter that have not ended yet
FINAL = ("done", "failed", "cancelled")


def detail_of(answer):
    """Of a problem document [RFC 9457]; what names the request would make each one new."""
    try:
        return answer.json()["detail"]
    except (ValueError, KeyError):
        return answer.body[:200].decode(errors="replace")


class Ledger:
    """What was acknowledged, and what was said that must not be. Thread-safe."""

    def __init__(self, file):
        self.lock = threading.Lock()
        self.file = open(file, "w", encoding="utf-8")
        self.complaints = []
        self.answers = collections.Counter()

    def add(self, entry):
        with self.lock:
            self.file.write(json.dumps(entry) + "\n")
            self.file.flush()

    def complain(self, text):
        with self.lock:
            if text not in self.complaints:
                self.complaints.append(text)
                print("submitters:", text, file=sys.stderr, flush=True)

    def judge(self, answer):
        """Every refusal for a while is a 429, 503 or 507 and says when to come again; nothing is a 500."""
        with self.lock:
            self.answers["none" if answer is None else answer.status] += 1
        if answer is None:
            return
        if answer.status < 500 and answer.status != 429:
            return
        if answer.status not in (429, 503, 507):
            self.complain(f"answered {answer.status}: {detail_of(answer)}")
        elif not answer.fields.get("retry-after", "").isdigit():
            self.complain(f"{answer.status} without Retry-After: {detail_of(answer)}")


class Submitter(threading.Thread):
    def __init__(self, number, arguments, documents, ledger, stop):
        super().__init__(name=f"submitter-{number}")
        self.number, self.seed = number, arguments.seed
        self.random = random.Random(arguments.seed * 1000 + number)
        self.client = DaemonClient(arguments.port_file)
        self.documents, self.ledger, self.stop = documents, ledger, stop
        self.outstanding = []

    def insist(self, method, path, body=None, fields=None):
        return self.client.insist(method, path, body, fields, note=self.ledger.judge)

    def run(self):
        try:
            count = 0
            while not self.stop.is_set():
                count += 1
                self.one_job(f"{self.seed}-{self.number}-{count}")
                self.wait_for_room()
        except Exception as e:  # a thread that dies must not go unseen
            self.ledger.complain(f"{self.name}: {e!r}")

    def submit(self, kind, key):
        fields = {"Content-Type": "application/json", "Idempotency-Key": key}
        answer = self.insist("POST", "/v1/jobs", self.documents[kind], fields)
        if answer.status != 202:
            self.ledger.complain(f"a good job of kind {kind} was refused: {answer.status} {answer.body[:300]!r}")
            return None
        return answer.json()["id"]

    def one_job(self, key):
        # The names sorted: the same choice for the same seed.
        kind = self.random.choice(sorted(self.documents))
        what = self.random.choices(["leave", "again", "cancel", "delete"], [65, 10, 15, 10])[0]
        pause_s = self.random.choice([0, 0, 0.05, 0.3])
        job = self.submit(kind, key)
        if job is None:
            return
        entry = {"kind": kind, "key": key, "id": job, "acknowledged": "submit"}
        self.ledger.add(entry)
        if what == "again" and (other := self.submit(kind, key)) != job:
            self.ledger.complain(f"key {key} gave job {job}, then {other}")
        time.sleep(pause_s)
        if what == "cancel":
            answer = self.insist("POST", f"/v1/jobs/{job}/cancel")
            self.ledger.add({**entry, "acknowledged": "cancel", "state": answer.json().get("state")})
        elif what == "delete":
            # 404: an answer before this one was lost.
            answer = self.insist("DELETE", f"/v1/jobs/{job}")
            if answer.status not in (204, 404):
                self.ledger.complain(f"DELETE answered {answer.status}")
            self.ledger.add({**entry, "acknowledged": "delete"})
        else:
            self.outstanding.append(job)

    def wait_for_room(self):
        while len(self.outstanding) >= OUTSTANDING and not self.stop.is_set():
            answer = self.client.ask("GET", f"/v1/jobs/{self.outstanding[0]}")
            if answer is None or answer.status >= 500:
                time.sleep(0.1)
            elif answer.status == 404 or answer.json()["state"] in FINAL:
                self.outstanding.pop(0)  # what is lost or failed is found at the end
            else:
                time.sleep(0.05)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--port-file", required=True)
    parser.add_argument("--jobs", required=True, type=pathlib.Path)
    parser.add_argument("--ledger", required=True)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--threads", type=int, default=3)
    arguments = parser.parse_args()
    stop = threading.Event()
    signal.signal(signal.SIGTERM, lambda *_: stop.set())
    documents = {file.stem: file.read_bytes() for file in arguments.jobs.glob("*.json")}
    ledger = Ledger(arguments.ledger)
    submitters = [Submitter(i, arguments, documents, ledger, stop) for i in range(arguments.threads)]
    for submitter in submitters:
        submitter.start()
    for submitter in submitters:
        submitter.join()
    print("answers:", ", ".join(f"{status} x {n}" for status, n in sorted(ledger.answers.items(), key=str)))
    return 1 if ledger.complaints else 0


if __name__ == "__main__":
    sys.exit(main())
