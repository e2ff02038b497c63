// SPDX-License-Identifier: Apache-2.0
// Submits a scene to a Bouguer daemon, follows its events and shows the picture as it improves.
import { ask, follow, loadPicture, post } from "./daemon.js";

const element = (id) => document.getElementById(id);
const say = (text) => { element("status").textContent = text; };
let stopFollowing = () => {};
let newestPicture = "";

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

/** What is wrong, one line a problem: RFC 9457 with JSON pointers. */
function showProblems(problem) {
  const errors = problem.errors ?? [{ pointer: "", detail: problem.detail ?? problem.message }];
  element("problems").replaceChildren(...errors.map((error) => {
    const item = document.createElement("li");
    item.textContent = `${error.pointer || "document"}: ${error.detail}`;
    return item;
  }));
  say(problem.title ?? "The document cannot be read.");
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
async function showPicture(job, version) {
  const url = newestPicture = `${job}/image.png?v=${version}`;
  const picture = await loadPicture(url, () => url === newestPicture);
  if (url !== newestPicture) return;
  element("picture").src = picture.src;
  element("picture").hidden = false;
}

async function showEnd(job, view) {
  stop();
  if (view.state !== "done") return say(`The job ended as ${view.state}.`);
  showProgress(view.progress);
  await showPicture(job, "done");
  for (const name of ["png", "exr"]) element(name).href = `${job}/image.${name}`;
  element("report").href = `${job}/report`;
  element("links").hidden = false;
}

function watch(job) {
  stopFollowing = follow(job, {
    snapshot: (view) => showProgress(view.progress),
    progress: (data) => showProgress(data.progress),
    preview: (_, id) => showPicture(job, id).catch(showProblems),
    done: (view) => showEnd(job, view).catch(showProblems),
    waiting: say,
    failed: showProblems,
  });
}

function stop() {
  stopFollowing();
  newestPicture = "";
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
  element("submit").disabled = true;
  try {
    const text = JSON.stringify(jobOf(element("document").value));
    const unreached = "If it does run, it does not allow this page: see README.md beside it.";
    const view = await post(`${root}/v1/jobs`, text, (reason) => say(`${reason} ${unreached}`));
    const job = `${root}/v1/jobs/${view.id}`;
    element("cancel").disabled = false;
    element("cancel").onclick = () => ask(`${job}/cancel`, { method: "POST" }, say).catch(showProblems);
    watch(job);
  } catch (problem) {
    element("submit").disabled = false;
    showProblems(problem);
  }
});
