// SPDX-License-Identifier: Apache-2.0
// Asks a Bouguer daemon from a web page, and lives through its restarts: what has no answer, a torn one or that of a busy
// daemon is asked again until `patienceMs` have passed. The daemon's own page uses this file too.

const patienceMs = 300_000;
const longestPauseMs = 5_000;
const answerTimeoutMs = 60_000;
const silenceMs = 20_000;  // of events, before their stream is opened anew
const tryAgain = new Set([408, 429, 502, 503, 504, 507]);  // statuses that pass; every other refusal is final
const finalStates = new Set(["done", "failed", "cancelled"]);

/** Resolves after `ms` and up to half as much again, so that not all clients come back at once. */
const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms * (1 + Math.random() / 2)));

/** The pauses between the attempts of one call: they double and end when the patience does. */
class Backoff {
  #pauseMs = 250;
  #end = performance.now() + patienceMs;

  /** Rejects when it is over; `askedS`: how long the daemon asks to be left alone. */
  async wait(reason, askedS = 0) {
    const ms = Math.max(this.#pauseMs, 1000 * askedS);
    if (performance.now() + ms > this.#end) throw { title: "There was no answer.", detail: `${reason}. It was asked for ${patienceMs / 1000} s.` };
    await pause(ms);
    this.#pauseMs = Math.min(2 * this.#pauseMs, longestPauseMs);
  }
}

/** The JSON of a text; of another, of a proxy for instance, a problem in its place [RFC 9457]. */
function parsed(text, title) {
  try {
    return JSON.parse(text);
  } catch {
    return { title, detail: "The answer is not JSON." };
  }
}

/**
 * The text of the answer; throws the problem document of a refusal. Everything that the API offers may be asked twice, a
 * submission if it has an Idempotency-Key. `onWait` is told why there is no answer yet, before every pause.
 */
export async function askText(url, options = {}, onWait = () => {}) {
  const backoff = new Backoff();
  while (true) {
    let reason = "The daemon does not answer", askedS = 0, refusal = null;
    try {
      const response = await fetch(url, { ...options, signal: AbortSignal.timeout(answerTimeoutMs) });
      const text = await response.text();
      if (response.ok) return text;
      const title = `${response.status} ${response.statusText}`;
      if (!tryAgain.has(response.status)) refusal = parsed(text, title);
      reason = `The daemon answers ${title}`;
      askedS = Number(response.headers.get("Retry-After")) || 0;
    } catch {
      // refused, reset, torn or too late
    }
    if (refusal) throw refusal;
    onWait(`${reason}; trying again.`);
    await backoff.wait(reason, askedS);
  }
}

/** Likewise, the JSON of the answer. */
export async function ask(url, options, onWait) {
  return JSON.parse(await askText(url, options, onWait));
}

/** A UUID of version 4. crypto.randomUUID() is for pages that came by HTTPS or from this machine. */
function newKey() {
  const bytes = crypto.getRandomValues(new Uint8Array(16));
  bytes[6] = 0x40 | (bytes[6] & 0x0f);
  bytes[8] = 0x80 | (bytes[8] & 0x3f);
  const hex = Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
  return hex.replace(/^(.{8})(.{4})(.{4})(.{4})/, "$1-$2-$3-$4-");
}

/** Posts a document of JSON text. The key is one for all attempts: it makes them one submission. */
export function post(url, text, onWait) {
  const headers = { "Content-Type": "application/json", "Idempotency-Key": newKey() };
  return ask(url, { method: "POST", headers, body: text }, onWait);
}

/**
 * Follows a job to its end: `on.snapshot(view)`, `on.progress(data)`, `on.preview(data, eventId)` as they come, `on.done(view)`
 * once, whatever the state it ended in; `on.waiting(reason)` while nobody answers, `on.failed(problem)` when that lasts too
 * long or the job is gone. `job` is its address. Returns a function that ends the following.
 */
export function follow(job, on) {
  const stopping = new AbortController();
  const told = (name, ...values) => { if (!stopping.signal.aborted) on[name]?.(...values); };
  followToTheEnd(job, told, stopping.signal).catch((problem) => told("failed", problem));
  return () => stopping.abort();
}

async function followToTheEnd(job, told, stop) {
  while (!stop.aborted) {
    let view = await readStream(job, told, stop);
    if (view === null && !stop.aborted) {  // broken: the end may have been missed
      await pause(500);
      view = await ask(job, {}, (reason) => told("waiting", reason));
      told("snapshot", view);
    }
    if (view !== null && finalStates.has(view.state)) return told("done", view);
  }
}

/**
 * The job as its last event has it; null when the stream broke or was silent. A stream is never left to the browser: after a
 * 502 or 503 of a proxy, EventSource would not open it again.
 */
function readStream(job, told, stop) {
  return new Promise((resolve) => {
    const stream = new EventSource(`${job}/events`);
    let silence = 0;
    const end = (view) => {
      clearTimeout(silence);
      stop.removeEventListener("abort", breakOff);
      stream.close();
      resolve(view);
    };
    const breakOff = () => end(null);
    const listen = () => {
      clearTimeout(silence);
      silence = setTimeout(breakOff, silenceMs);
    };
    listen();
    stop.addEventListener("abort", breakOff);
    stream.addEventListener("error", breakOff);
    stream.addEventListener("done", (event) => end(JSON.parse(event.data)));
    for (const type of ["snapshot", "progress", "preview"]) {
      stream.addEventListener(type, (event) => {
        listen();
        told(type, JSON.parse(event.data), event.lastEventId);
      });
    }
  });
}

/** Loads a picture; the element that has it. `isWanted` is asked before every attempt: null when it says no. */
export async function loadPicture(url, isWanted = () => true) {
  const backoff = new Backoff();
  while (isWanted()) {
    const picture = new Image();
    picture.src = url;
    try {
      await picture.decode();
      return picture;
    } catch {
      await askText(url, { method: "HEAD" });  // waits for the daemon; throws if it refuses the picture
      await backoff.wait("The picture cannot be loaded");
    }
  }
  return null;
}
