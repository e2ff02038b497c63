// SPDX-License-Identifier: Apache-2.0
// The daemon's page: submit a scene, follow its events, look at what comes.
import { ask, askText, follow, post } from "/daemon.js";
import { clearJob, element, make, percent, showLinks, showPicture, showProgress, showReport, showReportedWarnings, showWarnings } from "/job_view.js";
import { offerLook, withdrawLook } from "/look.js";

let stopFollowing = () => {};

const say = (text) => { element("status").textContent = text; };

/** RFC 9457: one line a problem, each with its JSON pointer. */
function showProblems(problem) {
  const errors = problem.errors ?? [{ detail: problem.detail ?? problem.message ?? String(problem) }];
  element("problems").replaceChildren(...errors.map((error) => {
    const item = make("li", "");
    if (error.pointer !== undefined) item.append(make("code", error.pointer || "/"), " ");
    item.append([error.detail, error.allowed && `allowed: ${error.allowed}`].filter(Boolean).join("; "));
    return item;
  }));
}

/** The text of the editor as a job: a bare scene gets the stop rule of the form. */
function jobText() {
  const text = element("document").value;
  const parsed = JSON.parse(text);
  if (parsed.format !== "bouguer-scene/1") return text;
  const stop = { samples: Number(element("samples").value) };
  if (element("error").value) stop.error = Number(element("error").value) / 100;
  return JSON.stringify({ format: "bouguer-job/1", scene: parsed, stop });
}

async function showEnd(job, view) {
  element("cancel").disabled = true;
  showProgress(view.progress);
  if (view.state === "done") element("bar").value = 1;
  else say(`The job ended as ${view.state}${view.failure ? `: ${view.failure}` : "."}`);
  if (view.images.length > 0) {
    showPicture(job, `v=${view.revision}-end`);
    offerLook((query) => {
      showPicture(job, query);
      element("png").href = `${job}/image.png?${query}`;
    });
    showLinks(job);
  }
  await showReport(job);
  await showReportedWarnings(job);
  await showJobs();
}

/** Shows a job from now until it ends. */
function watch(id, name) {
  stopFollowing();
  clearJob();
  withdrawLook();
  const job = `/v1/jobs/${id}`;
  history.replaceState(null, "", `#${id}`);
  element("title").textContent = name || "Picture";
  element("cancel").disabled = false;
  element("cancel").onclick = () => ask(`${job}/cancel`, { method: "POST" }, say).catch(showProblems);
  stopFollowing = follow(job, {
    snapshot: (view) => {
      element("title").textContent = view.name || "Picture";
      showProgress(view.progress);
      if (view.images.length > 0) showPicture(job, `v=${view.revision}-${view.progress.pass}`);
      showReport(job);
    },
    progress: (data) => showProgress(data.progress),
    preview: (data, eventId) => {
      showProgress(data.progress);
      showPicture(job, `v=${eventId}`);
      showReport(job);
    },
    done: (view) => showEnd(job, view).catch(showProblems),
    waiting: say,
    failed: showProblems,
  });
}

function jobRow(view) {
  const row = make("tr", "");
  const error = view.progress.relative_rmse;
  const open = make("button", "Show");
  open.type = "button";
  open.addEventListener("click", () => watch(view.id, view.name));
  const action = make("td", "");
  action.append(open);
  row.append(make("td", view.name || "unnamed"), make("td", view.state, `state-${view.state}`), make("td", view.progress.samples || ""),
             make("td", error ? percent(error.value, 3) : ""), make("td", new Date(view.created).toLocaleString()), action);
  return row;
}

async function showJobs() {
  const page = await ask("/v1/jobs?limit=10");
  element("jobs").tBodies[0].replaceChildren(...page.jobs.map(jobRow));
}

async function showReadiness() {
  const badge = element("ready");
  try {
    const response = await fetch("/readyz");
    const { status, queued } = await response.json();
    badge.textContent = queued > 0 ? `${status}, ${queued} waiting` : status;
    badge.className = `badge ${response.ok ? "good" : "bad"}`;
  } catch {
    badge.textContent = "cannot be reached";
    badge.className = "badge bad";
  }
}

async function showExample() {
  element("document").value = await askText(`/examples/${element("example").value}.json`);
}

/** Runs an action of the form, one at a time; what it throws is shown. */
async function attempt(action) {
  const buttons = [element("submit"), element("validate")];
  element("problems").replaceChildren();
  showWarnings([]);
  for (const button of buttons) button.disabled = true;
  try {
    await action();
  } catch (problem) {
    showProblems(problem);
  }
  for (const button of buttons) button.disabled = false;
}

element("form").addEventListener("submit", (event) => {
  event.preventDefault();
  attempt(async () => {
    const view = await post("/v1/jobs", jobText(), say);
    watch(view.id, view.name);
    showWarnings(view.warnings);
    await showJobs();
  });
});
element("validate").addEventListener("click", () => attempt(async () => {
  const answer = await post("/v1/scenes/validate", jobText(), say);
  const kernel = answer.plan ? ` It would run ${answer.plan.kernel}.` : "";
  showWarnings(answer.warnings);
  element("problems").replaceChildren(make("li", `The document is accepted.${kernel}`, "good"));
}));
element("file").addEventListener("change", async (event) => {
  const [file] = event.target.files;
  if (file) element("document").value = await file.text();
});
element("example").addEventListener("change", showExample);

showExample();
showReadiness();
setInterval(showReadiness, 5000);
showJobs().catch(showProblems);
if (location.hash) watch(location.hash.slice(1), "");  // a link to a job
