// SPDX-License-Identifier: Apache-2.0
// Submits a scene to a Bouguer daemon, follows its events and shows the picture as it improves.
const element = (id) => document.getElementById(id);
const say = (text) => { element("status").textContent = text; };
let stream = null;

const example = {
  format: "bouguer-scene/1", name: "amber ball", units: "cm",
  camera: { type: "perspective", from: [0, 6, 22], at: [0, 3, 0], fov_deg: 35, resolution: [640, 480] },
  spectra: { amber: { wavelengths_nm: [400, 500, 600, 700], values: [0.2, 0.5, 0.93, 0.95] } },
  materials: {
    glass: { type: "hall", reflectance: 1, transmittance: 1, k_sr: 0.1, k_st: 0.9, n: 20, ior: 1.3,
             absorption: { transmittance: "amber", thickness: 1 } },
    floor: { type: "hall", reflectance: { srgb: [0.8, 0.75, 0.7] }, k_sr: 0.8, n: 1 },
  },
  objects: [
    { name: "ball", shape: { type: "sphere", center: [0, 3, 0], radius: 3 }, material: "glass" },
    { name: "floor", shape: { type: "plane", point: [0, 0, 0], normal: [0, 1, 0] }, material: "floor" },
  ],
  lights: [{ type: "point", position: [10, 20, 15], intensity: { spectrum: "D65", scale: 400 } }],
  ambient: { k_a: 0.3, weights: "hemisphere" },
};
element("document").value = JSON.stringify(example, null, 2);

element("file").addEventListener("change", async (event) => {
  const [file] = event.target.files;
  if (file) element("document").value = await file.text();
});

/** The answer's JSON; throws the problem document of a refusal. */
async function call(url, options) {
  const response = await fetch(url, options);
  const body = await response.json();
  if (!response.ok) throw body;
  return body;
}

/** What is wrong, one line a problem: RFC 9457 with JSON pointers. */
function showProblems(problem) {
  const errors = problem.errors ?? [{ pointer: "", detail: problem.detail ?? problem.message }];
  element("problems").replaceChildren(...errors.map((error) => {
    const item = document.createElement("li");
    item.textContent = `${error.pointer || "document"}: ${error.detail}`;
    return item;
  }));
  say(problem.title ?? "The daemon cannot be reached from this page (see README.md beside it).");
}

function showProgress(progress) {
  if (!progress) return;
  element("bar").value = progress.fraction;
  const left = progress.seconds_left == null ? "" : `, ${progress.seconds_left.toFixed(1)} s left`;
  const rmse = progress.relative_rmse?.value ?? progress.relative_rmse;
  const error = rmse == null ? "" : `, relative RMSE ${(100 * rmse).toFixed(2)} %`;
  say(`${(100 * progress.fraction).toFixed(0)} %, ${progress.samples} samples a pixel, ` +
      `${progress.seconds.toFixed(1)} s${left}${error}`);
}

/** Loads the newest picture; `version` keeps the browser from showing an old one. */
function showPicture(job, version) {
  const picture = element("picture");
  picture.src = `${job}/image.png?v=${version}`;
  picture.hidden = false;
}

function follow(job) {
  stream = new EventSource(`${job}/events`);
  const on = (type, action) => stream.addEventListener(type, (event) => action(JSON.parse(event.data), event));
  on("snapshot", (view) => showProgress(view.progress));
  on("progress", (data) => showProgress(data.progress ?? data));
  on("preview", (_, event) => showPicture(job, event.lastEventId));
  on("done", async () => {
    stop();
    const view = await call(job);
    if (view.state !== "done") return say(`The job ended as ${view.state}.`);
    element("bar").value = 1;
    showPicture(job, "done");
    for (const name of ["png", "exr"]) element(name).href = `${job}/image.${name}`;
    element("report").href = `${job}/report`;
    element("links").hidden = false;
  });
}

function stop() {
  stream?.close();
  stream = null;
  element("cancel").disabled = true;
  element("submit").disabled = false;
}

/** A bare scene becomes a job with the samples that the form says. */
function jobOf(text) {
  const parsed = JSON.parse(text);
  if (parsed.format === "bouguer-job/1") return parsed;
  return { format: "bouguer-job/1", scene: parsed, stop: { samples: Number(element("samples").value) } };
}

element("form").addEventListener("submit", async (event) => {
  event.preventDefault();
  stop();
  element("problems").replaceChildren();
  element("links").hidden = true;
  element("bar").value = 0;
  const root = element("url").value.replace(/\/+$/, "");
  try {
    const view = await call(`${root}/v1/jobs`, {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify(jobOf(element("document").value)),
    });
    const job = `${root}/v1/jobs/${view.id}`;
    element("submit").disabled = true;
    element("cancel").disabled = false;
    element("cancel").onclick = () => fetch(`${job}/cancel`, { method: "POST" });
    follow(job);
  } catch (problem) {
    showProblems(problem);
  }
});
