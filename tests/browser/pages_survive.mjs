// SPDX-License-Identifier: Apache-2.0
// The daemon's own page, behind a proxy that answers 502 meanwhile, and the page of client-examples live through a kill -9
// of the daemon in the middle of a render and some seconds without it: both show the finished picture. A stream of events
// that a page leaves open is not asked for again once it has told the end.
//
//   node pages_survive.mjs BOUGUER ROOT WORK SECONDS PAGE [SCREENSHOTS]
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { Daemon, eventually, serveFolder, sleep, startBrowser, startProxy } from "./stage.mjs";

const [bouguer, root, work, seconds, pageFolder, screenshots] = process.argv.slice(2);

const job = {
  format: "bouguer-job/1", stop: { samples: 128 }, seed: 1,
  scene: {
    format: "bouguer-scene/1", name: "ball",
    camera: { type: "perspective", from: [0, 1, 5], at: [0, 1, 0], fov_deg: 40, resolution: [160, 120] },
    materials: {
      glass: { type: "hall", k_sr: 0.1, k_st: 0.9, n: 20, ior: 1.3 },
      grey: { type: "hall", reflectance: { srgb: [0.8, 0.6, 0.4] }, k_sr: 1 },
    },
    objects: [
      { name: "ball", shape: { type: "sphere", center: [0, 1, 0], radius: 1 }, material: "glass" },
      { name: "floor", shape: { type: "plane", point: [0, 0, 0], normal: [0, 1, 0] }, material: "grey" },
    ],
    lights: [{ type: "directional", direction: [-1, -2, -1], irradiance: "D65" }],
  },
};

/** The bytes of the picture in an undisturbed run. */
function reference() {
  const [document, picture] = [join(work, "job.json"), join(work, "reference.png")];
  writeFileSync(document, JSON.stringify(job));
  execFileSync(bouguer, ["render", document, "-o", picture], { stdio: ["ignore", "ignore", "inherit"] });
  return readFileSync(picture);
}

const statusOf = (page) => page.locator("#status").textContent();

async function submit(page, text) {
  await page.locator("#document").fill(text);
  await page.locator("#submit").click();
  await eventually("the page shows progress", async () => (await statusOf(page)).includes("samples a pixel"));
}

/** Waits for the end and compares what the page shows with the undisturbed picture. */
async function expectPicture(page, name, expected, faults) {
  try {
    await page.locator("#links").waitFor({ state: "visible", timeout: 60_000 });
    const source = await eventually("the final picture is loaded", () => page.locator("#picture").evaluate((picture) =>
      picture.complete && picture.naturalWidth === 160 && /v=(done|.*-end)$/.test(picture.src) && picture.src));
    const shown = Buffer.from(await (await fetch(source)).arrayBuffer());
    if (!shown.equals(expected)) throw new Error("it shows another picture");
    console.log(`${name}: shows the finished picture`);
  } catch (fault) {
    faults.push(`${name}: ${fault.message}; its status is "${await statusOf(page)}"`);
  }
}

/** What a browser gets that opens the events of an ended job and does not close them, until it stops by itself. */
function answersToAnOpenStream(page, url) {
  const answers = [];
  page.on("response", (response) => { if (response.url() === url) answers.push(response.status()); });
  return page.evaluate((address) => new Promise((resolve) => {
    const stream = new EventSource(address);
    const watch = setInterval(() => { if (stream.readyState === EventSource.CLOSED) { clearInterval(watch); resolve(); } }, 50);
    setTimeout(resolve, 10_000);
  }), url).then(() => answers);
}

async function play(daemon, proxy, folder, browser) {
  const faults = [];
  const expected = reference();
  const own = await browser.newPage();
  const example = await browser.newPage();
  await own.goto(proxy.url);
  await example.goto(folder.url);
  await example.locator("#url").fill(daemon.url);
  const text = JSON.stringify(job);
  await Promise.all([submit(own, text), submit(example, text)]);

  await daemon.kill();
  const says = (page) => eventually("the page says that it waits", async () => (await statusOf(page)).includes("trying again"));
  const said = Promise.all([says(own), says(example)]).catch((fault) => faults.push(fault.message));
  await sleep(1000 * seconds);  // the outage itself
  await daemon.start([proxy.url, folder.url]);
  await said;

  await expectPicture(own, "own page", expected, faults);
  await expectPicture(example, "example page", expected, faults);
  if (screenshots) {
    await own.screenshot({ path: join(screenshots, "own-page.png"), fullPage: true });
    await example.screenshot({ path: join(screenshots, "example-page.png"), fullPage: true });
  }

  const { jobs } = await (await fetch(`${daemon.url}/v1/jobs`)).json();
  if (jobs.length !== 2) faults.push(`two submissions became ${jobs.length} jobs`);
  const answers = await answersToAnOpenStream(own, `${proxy.url}/v1/jobs/${jobs[0].id}/events`);
  if (answers.join() !== "200,204") faults.push(`an open stream of an ended job got ${answers.join()}, not 200,204`);
  return faults;
}

const daemon = new Daemon(bouguer, work);
const open = [];  // to be closed at the end
let faults;
try {
  await daemon.start();  // finds a free port
  await daemon.kill();
  const proxy = await startProxy(root, work, daemon.port);
  open.unshift(proxy);
  const folder = await serveFolder(pageFolder);
  open.unshift(folder);
  const browser = await startBrowser(work);
  open.unshift(browser);
  await daemon.start([proxy.url, folder.url]);
  faults = await play(daemon, proxy, folder, browser);
} finally {
  await daemon.kill();
  for (const thing of open) await thing.close();
}
for (const fault of faults) console.error(fault);
process.exit(faults.length > 0 ? 1 : 0);
