# SPDX-License-Identifier: Apache-2.0
"""Submits a small job with a generated client, waits for its end, reads its report and its picture, and has a bad one
refused.    submit_job.py URL
"""
import sys

from bouguer_client import Client
from bouguer_client.api.jobs import get_job, submit_job
from bouguer_client.api.results import get_png, get_report
from bouguer_client.models.job import Job
from bouguer_client.models.job_state import JobState
from bouguer_client.models.job_view import JobView
from bouguer_client.models.problem import Problem
from bouguer_client.models.report import Report
from bouguer_client.models.submitted_job import SubmittedJob
from bouguer_client.types import File

JOB = {
    "format": "bouguer-job/1",
    "scene": {
        "format": "bouguer-scene/1",
        "camera": {"type": "perspective", "from": [0, 1, 5], "at": [0, 1, 0], "resolution": [32, 24]},
        "spectra": {"amber": {"wavelengths_nm": [400, 500, 600, 700], "values": [0.2, 0.5, 0.93, 0.95]}},
        "materials": {
            "glass": {"type": "hall", "k_sr": 0.1, "k_st": 0.9, "ior": 1.3,
                      "absorption": {"transmittance": "amber", "thickness": 1}},
            "clay": {"type": "phong", "diffuse": {"srgb": [0.8, 0.5, 0.4]}, "k_d": 0.8},
        },
        "objects": [
            {"name": "ball", "shape": {"type": "sphere", "center": [0, 1, 0], "radius": 1}, "material": "glass",
             "transform": [{"translate": [0, 0.1, 0]}]},
            {"name": "floor", "shape": {"type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}, "material": "clay"},
        ],
        "lights": [{"type": "directional", "direction": [-1, -1, -1], "irradiance": {"spectrum": "D65", "scale": 2}}],
    },
    "integrator": {"type": "hall", "max_depth": 4},
    "stop": {"samples": 4},
    "output": {"display": "srgb", "exposure": 1},
}


def ended(client: Client, id_: str) -> JobView:
    while True:
        view = get_job.sync(id_, client=client, prefer="wait=20")
        assert isinstance(view, JobView), view
        if view.state not in (JobState.QUEUED, JobState.RUNNING):
            return view


def main() -> None:
    client = Client(base_url=sys.argv[1])
    job = Job.from_dict(JOB)
    assert job.to_dict() == JOB, "the document goes through the types unchanged"
    submitted = submit_job.sync(client=client, body=job, idempotency_key="python")
    assert isinstance(submitted, SubmittedJob) and submitted.warnings == [], submitted
    view = ended(client, submitted.id)
    assert view.state == JobState.DONE, view.state
    assert view.progress.samples == 4

    report = get_report.sync(view.id, client=client)
    assert isinstance(report, Report), report
    last = report.error.points[-1]
    assert last.samples == 4 and last.relative_rmse is not None
    assert report.health.samples == 32 * 24 * 4 and report.health.rejected.total == 0
    assert any(item.feature == "absorption" and item.needed for item in report.plan.items)

    picture = get_png.sync(view.id, client=client, exposure=2.0)
    assert isinstance(picture, File) and picture.payload.read(4) == b"\x89PNG"

    job.seed = -1
    refused = submit_job.sync(client=client, body=job)
    assert isinstance(refused, Problem) and refused.status == 422, refused
    assert isinstance(refused.errors, list) and refused.errors[0].pointer == "/seed"


if __name__ == "__main__":
    main()
