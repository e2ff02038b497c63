// SPDX-License-Identifier: Apache-2.0
// The curve error(t) as a small SVG: both axes logarithmic, so that noise falls along a straight line.

const svgNamespace = "http://www.w3.org/2000/svg";
const box = { left: 52, right: 340, top: 10, bottom: 150, width: 360, height: 180 };

function shape(name, attributes, text) {
  const element = document.createElementNS(svgNamespace, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  if (text !== undefined) element.textContent = text;
  return element;
}

/** Maps [low, high] to [from, to] by the logarithm; one decade at least is shown. */
function logScale(low, high, from, to) {
  const first = Math.floor(Math.log10(low));
  const last = Math.max(Math.ceil(Math.log10(high)), first + 1);
  const map = (x) => from + ((Math.log10(x) - first) / (last - first)) * (to - from);
  const ticks = Array.from({ length: last - first + 1 }, (_, i) => 10 ** (first + i));
  return { map, ticks };
}

const short = (x) => (x >= 0.001 && x < 10000 ? String(Number(x.toPrecision(3))) : x.toExponential(0));

function axes(xScale, yScale) {
  const parts = [];
  for (const tick of xScale.ticks) {
    const x = xScale.map(tick);
    parts.push(shape("line", { class: "axis", x1: x, x2: x, y1: box.top, y2: box.bottom }));
    parts.push(shape("text", { x, y: box.bottom + 14, "text-anchor": "middle" }, `${short(tick)} s`));
  }
  for (const tick of yScale.ticks) {
    const y = yScale.map(tick);
    parts.push(shape("line", { class: "axis", x1: box.left, x2: box.right, y1: y, y2: y }));
    parts.push(shape("text", { x: box.left - 6, y: y + 4, "text-anchor": "end" }, `${short(100 * tick)} %`));
  }
  return parts;
}

/** @param points of GET /v1/jobs/{id}/error.json; those without an estimate are left out. */
export function drawErrorPlot(element, points) {
  const known = points.filter((p) => p.seconds > 0 && p.relative_rmse?.value > 0)
    .map((p) => ({ t: p.seconds, value: p.relative_rmse.value,
                   low: Math.max(p.relative_rmse.low, p.relative_rmse.value / 10), high: p.relative_rmse.high }));
  if (known.length === 0) {
    element.textContent = "Not known yet: it takes two passes.";
    return;
  }
  const xScale = logScale(known[0].t, known.at(-1).t, box.left, box.right);
  const yScale = logScale(Math.min(...known.map((p) => p.low)), Math.max(...known.map((p) => p.high)), box.bottom, box.top);
  const at = (t, value) => `${xScale.map(t).toFixed(1)},${yScale.map(value).toFixed(1)}`;
  const upper = known.map((p) => at(p.t, p.high));
  const lower = known.map((p) => at(p.t, p.low)).reverse();
  const last = known.at(-1);
  const label = `relative RMSE ${(100 * last.value).toPrecision(3)} % after ${last.t.toPrecision(3)} s`;
  const svg = shape("svg", { viewBox: `0 0 ${box.width} ${box.height}`, role: "img", "aria-label": label });
  svg.append(...axes(xScale, yScale));
  svg.append(shape("polygon", { class: "band", points: [...upper, ...lower].join(" ") }));
  svg.append(shape("polyline", { class: "curve", points: known.map((p) => at(p.t, p.value)).join(" ") }));
  for (const p of known) svg.append(shape("circle", { class: "point", r: 2.2, cx: xScale.map(p.t), cy: yScale.map(p.value) }));
  svg.append(shape("text", { x: box.right, y: box.top + 10, "text-anchor": "end" }, label));
  element.replaceChildren(svg);
}
