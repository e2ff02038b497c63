#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares every acknowledged job with an undisturbed run, on a daemon that is left alone by now.

    check_jobs.py --port-file FILE --ledger FILE --jobs FOLDER --kept FILE [--rest-within SECONDS]

Waits until all jobs are at rest. FOLDER has KIND.exr and KIND.png of the undisturbed run. Writes the ids of the jobs that
are there to --kept. The last line counts; exit code 1 when any count but that of the jobs is not zero:
  lost        acknowledged, and not there
  stuck       not at rest within the time
  wrong bits  done, with another picture than that of the undisturbed run, or with none
  wrong end   failed; cancelled without a wish; a cancel or delete that was acknowledged and did not last
  doubled     there, and not acknowledged to anybody under any key
"""
import argparse
import json
import pathlib
import sys
import time

from daemon_client import DaemonClient

FINAL = ("done", "failed", "cancelled")


def read_ledger(file):
    """id -> the last thing that was acknowledged of it."""
    entries = {}
    for line in open(file, encoding="utf-8"):
        entry = json.loads(line)
        entries[entry["id"]] = entry
    return entries


def all_jobs(client):
    """id -> job, of all pages."""
    jobs = {}
    path = "/v1/jobs?limit=100"
    while path:
        answer = client.insist("GET", path)
        page = answer.json()
        for job in page["jobs"]:
            jobs[job["id"]] = job
        link = answer.fields.get("link", "")
        path = link[1:link.index(">")] if 'rel="next"' in link else None
    return jobs


def jobs_at_rest(client, within_s):
    """All jobs, once every one has ended or nothing has ended for `within_s`."""
    moving, end = None, time.monotonic() + within_s
    while True:
        jobs = all_jobs(client)
        unfinished = {id for id, job in jobs.items() if job["state"] not in FINAL}
        if unfinished != moving:
            moving, end = unfinished, time.monotonic() + within_s
        if not unfinished or time.monotonic() > end:
            return jobs
        time.sleep(0.2)


def picture_is_right(client, id, kind, folder):
    return all(
        client.insist("GET", f"/v1/jobs/{id}/image.{form}", note=stop_at_damage).body ==
        (folder / f"{kind}.{form}").read_bytes() for form in ("exr", "png"))


def stop_at_damage(answer):
    """Damage does not go away by asking again."""
    if answer is not None and answer.status == 500:
        raise ValueError(answer.body[:300].decode(errors="replace"))


def judge(client, entry, job, folder):
    """One of the counts, with what was seen; or None."""
    if entry["acknowledged"] == "delete":
        return ("wrong end", "deleted, and there") if job else None
    if job is None:
        return "lost", "not there"
    state = job["state"]
    if state not in FINAL:
        return "stuck", f"stays {state}"
    expected = entry.get("state", "done") if entry["acknowledged"] == "cancel" else "done"
    if state != expected:
        return "wrong end", f"{state}, not {expected}: {job.get('failure')}"
    if state != "done":
        return None
    try:
        return None if picture_is_right(client, entry["id"], entry["kind"], folder) else ("wrong bits", "differs")
    except ValueError as e:
        return "wrong bits", str(e)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--port-file", required=True)
    parser.add_argument("--ledger", required=True)
    parser.add_argument("--jobs", required=True, type=pathlib.Path)
    parser.add_argument("--kept", required=True)
    parser.add_argument("--rest-within", type=float, default=60)
    arguments = parser.parse_args()
    client = DaemonClient(arguments.port_file)
    ledger = read_ledger(arguments.ledger)
    jobs = jobs_at_rest(client, arguments.rest_within)
    counts = dict.fromkeys(("lost", "stuck", "wrong bits", "wrong end", "doubled"), 0)

    def count(what, id, detail):
        counts[what] += 1
        print(f"  {what}: {id} {detail}")

    for id, entry in ledger.items():
        verdict = judge(client, entry, jobs.get(id), arguments.jobs)
        if verdict:
            count(verdict[0], id, f"({entry['kind']}, {entry['acknowledged']}) {verdict[1]}")
    for id in jobs.keys() - ledger.keys():
        count("doubled", id, f"is {jobs[id]['state']}")
    pathlib.Path(arguments.kept).write_text("".join(id + "\n" for id in jobs), encoding="ascii")
    print(", ".join(f"{what} {n}" for what, n in counts.items()), "of", len(ledger), "acknowledged jobs")
    return 1 if any(counts.values()) or not ledger else 0


if __name__ == "__main__":
    sys.exit(main())
