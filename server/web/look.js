// SPDX-License-Identifier: Apache-2.0
// How a finished picture is shown: display, exposure and white, without rendering again.
import { ask } from "/daemon.js";
import { element, make } from "/job_view.js";

const fields = { display: element("look-display"), exposure: element("look-exposure"), white: element("look-white") };
let show = null;  // gets the query of the picture; null: there is nothing to show otherwise

function choices(names) {
  return names.map((name) => {
    const option = make("option", name);
    option.value = name;
    return option;
  });
}

async function fillChoices() {
  const { displays, spectra } = await ask("/v1/library");
  fields.display.append(...choices(displays.map(({ name }) => name)));
  fields.white.append(...choices(spectra.filter(({ kind }) => kind === "illuminant").map(({ name }) => name)));
}

/** The query of what is chosen; empty as the job has it. */
function query() {
  const chosen = Object.entries(fields).filter(([, field]) => field.value !== "").map(([name, field]) => [name, field.value]);
  return new URLSearchParams(chosen).toString();
}

element("look").addEventListener("submit", (event) => event.preventDefault());
element("look").addEventListener("change", () => {
  if (show && element("look").checkValidity()) show(query());
});

/** Offers the choices; `onChange` gets the query of the picture whenever they change. */
export function offerLook(onChange) {
  element("look").reset();
  element("look").hidden = false;
  show = onChange;
}

export function withdrawLook() {
  show = null;
  element("look").hidden = true;
}

fillChoices();
