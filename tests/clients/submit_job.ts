// SPDX-License-Identifier: Apache-2.0
// Submits a small job with a typed client, waits for its end, reads its report and its picture, and has a bad one refused.
import createClient from "openapi-fetch";
import type { components, paths } from "./openapi.js";

declare const process: { argv: string[] };

type Job = components["schemas"]["Job"];
type JobView = components["schemas"]["JobView"];

const job: Job = {
  format: "bouguer-job/1",
  scene: {
    format: "bouguer-scene/1",
    camera: { type: "perspective", from: [0, 1, 5], at: [0, 1, 0], resolution: [32, 24] },
    spectra: { amber: { wavelengths_nm: [400, 500, 600, 700], values: [0.2, 0.5, 0.93, 0.95] } },
    materials: {
      glass: { type: "hall", k_sr: 0.1, k_st: 0.9, ior: 1.3, absorption: { transmittance: "amber", thickness: 1 } },
      clay: { type: "phong", diffuse: { srgb: [0.8, 0.5, 0.4] }, k_d: 0.8 },
    },
    objects: [
      { name: "ball", shape: { type: "sphere", center: [0, 1, 0], radius: 1 }, material: "glass",
        transform: [{ translate: [0, 0.1, 0] }] },
      { name: "floor", shape: { type: "plane", point: [0, 0, 0], normal: [0, 1, 0] }, material: "clay" },
    ],
    lights: [{ type: "directional", direction: [-1, -1, -1], irradiance: { spectrum: "D65", scale: 2 } }],
  },
  integrator: { type: "hall", max_depth: 4 },
  stop: { samples: 4 },
  output: { display: "srgb", exposure: 1 },
};

// The types bind: the compiler fails if it would take these.
// @ts-expect-error: there is no such integrator
const unknownIntegrator: Job = { ...job, integrator: { type: "no such" } };
// @ts-expect-error: a job has a scene
const withoutScene: Job = { format: "bouguer-job/1" };

function check(holds: boolean, what: string): asserts holds {
  if (!holds) throw new Error(what);
}

const client = createClient<paths>({ baseUrl: process.argv[2] ?? "" });

async function ended(id: string): Promise<JobView> {
  while (true) {
    const { data, error } = await client.GET("/v1/jobs/{id}", { params: { path: { id }, header: { Prefer: "wait=20" } } });
    check(data !== undefined, error?.detail ?? "");
    if (data.state !== "queued" && data.state !== "running") return data;
  }
}

const { data: submitted, error } = await client.POST("/v1/jobs", {
  body: job,
  params: { header: { "Idempotency-Key": "typescript" } },
});
check(submitted !== undefined, `refused: ${JSON.stringify(error)}`);
check(submitted.warnings.length === 0, `warned: ${JSON.stringify(submitted.warnings)}`);
const view = await ended(submitted.id);
check(view.state === "done", `ended as ${view.state}`);
check(view.progress.samples === 4, "samples of the job");

const path = { id: view.id };
const { data: report } = await client.GET("/v1/jobs/{id}/report", { params: { path } });
check(report !== undefined, "a report");
const last = report.error.points.at(-1);
check(last?.samples === 4 && last.relative_rmse?.value !== undefined, "an error curve");
check(report.health.samples === 32 * 24 * 4 && report.health.rejected.total === 0, "health");
check(report.plan.items.some((item) => item.feature === "absorption" && item.needed), "a plan");

const { data: picture } = await client.GET("/v1/jobs/{id}/image.png", { params: { path, query: { exposure: 2 } }, parseAs: "blob" });
check(picture !== undefined && (picture as Blob).type === "image/png", "a picture");

for (const bad of [unknownIntegrator, withoutScene]) {
  const { error: problem, response } = await client.POST("/v1/jobs", { body: bad });
  check(response.status === 422, `status ${response.status}`);
  check(problem?.errors?.[0]?.pointer !== undefined, "the place of the problem");
}
