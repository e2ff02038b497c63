// SPDX-License-Identifier: Apache-2.0
// What the pages meet: a daemon that can be killed and started again, a proxy before it, a server of files, a browser.
import { spawn } from "node:child_process";
import { existsSync, readFileSync, rmSync } from "node:fs";
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join } from "node:path";
import { chromium } from "playwright-core";

export const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

/** The first thing that `look` gives which is not falsy, within a minute. */
export async function eventually(what, look) {
  for (const end = Date.now() + 60_000; Date.now() < end; await sleep(50)) {
    const seen = await look();
    if (seen) return seen;
  }
  throw new Error(`it took too long until ${what}`);
}

const numberIn = (file) => eventually(`${file} is there`, () => existsSync(file) && Number(readFileSync(file, "utf8")));

export class Daemon {
  #bouguer; #work; #process = null;
  port = 0;  // any, the first time

  constructor(bouguer, work) {
    this.#bouguer = bouguer;
    this.#work = work;
  }

  get url() { return `http://127.0.0.1:${this.port}`; }

  async start(origins = []) {
    const data = join(this.#work, "data");
    rmSync(join(data, "port"), { force: true });
    const options = ["serve", "--listen", `127.0.0.1:${this.port}`, "--data", data, "--threads", "2",
                     ...origins.flatMap((origin) => ["--cors-origin", origin])];
    this.#process = spawn(this.#bouguer, options, { stdio: "ignore" });
    this.port = await numberIn(join(data, "port"));
  }

  async kill() {
    if (this.#process === null || this.#process.exitCode !== null) return;
    const ended = new Promise((resolve) => this.#process.once("exit", resolve));
    this.#process.kill("SIGKILL");
    await ended;
    this.#process = null;
  }
}

/** A reverse proxy that answers 502 while the daemon is away; { url, close }. */
export async function startProxy(root, work, port) {
  const file = join(work, "proxy.port");
  const script = join(root, "tests/service/cutting_proxy.py");
  const proxy = spawn("python3", [script, String(port), file, join(work, "cuts"), "cuts nothing", "0"], { stdio: "ignore" });
  return { url: `http://127.0.0.1:${await numberIn(file)}`, close: () => proxy.kill() };
}

/** Serves the files of a folder; { url, close }. */
export async function serveFolder(folder) {
  const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css" };
  const server = createServer(async (request, response) => {
    try {
      const name = request.url === "/" ? "index.html" : request.url.slice(1);
      const bytes = await readFile(join(folder, name));
      response.writeHead(200, { "Content-Type": types[extname(name)] ?? "application/octet-stream" }).end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return { url: `http://127.0.0.1:${server.address().port}`, close: () => server.close() };
}

export function startBrowser(work) {
  return chromium.launchPersistentContext(join(work, "profile"), {
    executablePath: "/usr/bin/chromium",
    headless: true,
    args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
           "--disable-component-update", "--disable-sync"],
  });
}
