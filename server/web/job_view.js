// SPDX-License-Identifier: Apache-2.0
// Shows one job: progress, picture, error curve, health, plan.
import { ask, loadPicture } from "/daemon.js";
import { drawErrorPlot } from "/error_plot.js";

export const element = (id) => document.getElementById(id);
export const percent = (x, digits = 2) => `${(100 * x).toPrecision(digits)} %`;

let newestPicture = "";

/** The answer's JSON, or null when there is nothing yet. */
const optional = (url) => ask(url).catch(() => null);

function make(name, text, className) {
  const made = document.createElement(name);
  made.textContent = text;
  if (className) made.className = className;
  return made;
}
export { make };

export function showProgress(progress) {
  if (!progress) return;
  element("bar").value = progress.fraction;
  const parts = [`${(100 * progress.fraction).toFixed(0)} %`, `${progress.samples} samples a pixel`, `${progress.seconds.toFixed(1)} s`];
  if (progress.seconds_left != null) parts.push(`${progress.seconds_left.toFixed(1)} s left`);
  if (progress.relative_rmse) parts.push(`error ${percent(progress.relative_rmse.value, 3)}`);
  element("status").textContent = parts.join(" · ");
}

/** `query` chooses display, exposure and white; `v=...` tells the browser that the picture is another one. */
export async function showPicture(job, query) {
  const url = newestPicture = `${job}/image.png?${query}`;
  const picture = await loadPicture(url, () => url === newestPicture).catch(() => null);
  if (picture === null || url !== newestPicture) return;
  element("picture").src = picture.src;
  element("picture").hidden = false;
}

const healthRows = [
  ["samples", (h) => h.samples],
  ["rejected: not a number", (h) => h.rejected.nan, true],
  ["rejected: infinite", (h) => h.rejected.infinite, true],
  ["rejected: negative", (h) => h.rejected.negative, true],
  ["rays cut by depth", (h) => h.rays_cut_by_depth],
  ["rays cut by threshold", (h) => h.rays_cut_by_threshold],
  ["shadow rays cut", (h) => h.shadow_rays_cut, true],
  ["samples blackened by cuts", (h) => h.blackened_samples, true],
  ["unmatched exits", (h) => h.unmatched_exits, true],
  ["triangles dropped", (h) => h.dropped_triangles, true],
  ["pixels without a sample", (h) => h.unfinished_pass?.without_sample, true],
  ["total reflections", (h) => h.total_reflections],
];

/** What is valid and probably not meant: one line a warning, each with its JSON pointer. */
export function showWarnings(warnings) {
  element("warnings").replaceChildren(...(warnings ?? []).map(({ pointer, code, detail, advice }) => {
    const item = make("li", "");
    const link = make("a", code);
    link.href = `/docs/warnings#${code}`;
    if (pointer) item.append(make("code", pointer), " ");
    item.append(`${detail}; ${advice} (`, link, ")");
    return item;
  }));
}

/** A row an object that rays lost track of. */
const unmatchedRows = (health) =>
  (health.unmatched_objects ?? []).map(({ object, count }) => [`unmatched: ${object}`, () => count, true]);

function showHealth(health) {
  element("health").replaceChildren(...[...healthRows, ...unmatchedRows(health)].flatMap(([name, value, isBad]) => {
    const n = value(health) ?? 0;
    return [make("dt", name), make("dd", n.toLocaleString("en"), isBad && n > 0 ? "bad" : "")];
  }));
}

function showPlan(plan) {
  element("kernel").textContent =
    `${plan.kernel} · ${plan.values_per_path} values a path (${plan.basis}) · ${plan.triangles.toLocaleString("en")} triangles`;
  element("plan").tBodies[0].replaceChildren(...plan.items.map((item) => {
    const row = make("tr", "", item.needed ? "" : "off");
    row.append(make("td", item.needed ? "needed" : "left out"), make("td", item.feature), make("td", item.reason));
    return row;
  }));
}

/** Error curve, health and plan as they stand. */
export async function showReport(job) {
  const [error, health, plan] = await Promise.all(["error.json", "health", "plan"].map((name) => optional(`${job}/${name}`)));
  if (error) drawErrorPlot(element("plot"), error.points);
  if (health) showHealth(health);
  if (plan) showPlan(plan);
}

/** Of document and picture, once there is a report. */
export async function showReportedWarnings(job) {
  const report = await optional(`${job}/report`);
  if (report) showWarnings(report.warnings);
}

export function showLinks(job) {
  for (const [id, path] of [["png", "image.png"], ["exr", "image.exr"], ["report", "report"], ["csv", "error.csv"]]) {
    element(id).href = `${job}/${path}`;
  }
  element("links").hidden = false;
}

export function clearJob() {
  newestPicture = "";
  element("bar").value = 0;
  element("links").hidden = true;
  element("picture").hidden = true;
  for (const id of ["plot", "health", "kernel"]) element(id).replaceChildren();
  element("plan").tBodies[0].replaceChildren();
}
