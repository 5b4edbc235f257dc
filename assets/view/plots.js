// Measurements over time beside the picture, with the values of the shown step.
import { postForJson } from "./server.js";
import { follow, settings, state } from "./state.js";

const svg = "http://www.w3.org/2000/svg";
const chosen = [];
let columns = [];

const column = (name) => columns.find((one) => one.name === name);
const text = (number) => (number === null || number === undefined ? "–" : String(Number(number.toPrecision(4))));

/** By more than rounding. */
function varies(values) {
  const known = values.filter((one) => one !== null);
  const high = Math.max(...known);
  const low = Math.min(...known);
  return high - low > 1e-6 * Math.max(Math.abs(high), Math.abs(low));
}

function part(name, attributes) {
  const element = document.createElementNS(svg, name);
  for (const [key, one] of Object.entries(attributes)) element.setAttribute(key, one);
  return element;
}

function drawn(name) {
  const { values, unit } = column(name);
  const steps = column("step")?.values ?? values.map((_, i) => i);
  const known = values.filter((one) => one !== null);
  const low = Math.min(...known);
  const high = Math.max(...known);
  const last = Math.max(1, steps.at(-1));
  const x = (step) => 4 + (192 * step) / last;
  const y = (one) => (varies(known) ? 96 - (88 * (one - low)) / (high - low) : 50);
  const now = state.subject.moments[state.moment]?.step ?? 0;
  const plot = part("svg", { viewBox: "0 0 200 100", preserveAspectRatio: "none", role: "img", "aria-label": `${name} by step` });
  let path = "";
  let pen = "M";
  values.forEach((one, i) => {
    if (one === null) { pen = "M"; return; }
    path += `${pen}${x(steps[i]).toFixed(2)} ${y(one).toFixed(2)}`;
    pen = "L";
  });
  plot.append(part("line", { class: "now", x1: x(now), x2: x(now), y1: 0, y2: 100 }), part("path", { class: "curve", d: path }));
  let nearest = -1;
  steps.forEach((step, i) => { if (step <= now && values[i] !== null) nearest = i; });
  const figure = document.createElement("figure");
  const caption = document.createElement("figcaption");
  const value = document.createElement("output");
  value.textContent = nearest < 0 ? "–" : `${text(values[nearest])} ${unit}`;
  const away = document.createElement("button");
  Object.assign(away, { type: "button", textContent: "×" });
  away.setAttribute("aria-label", `remove the plot of ${name}`);
  away.addEventListener("click", () => { chosen.splice(chosen.indexOf(name), 1); show(); });
  caption.append(name.replaceAll("_", " "), value, away);
  const ends = document.createElement("div");
  ends.className = "ends";
  const range = document.createElement("span");
  range.textContent = known.length ? `${text(low)} to ${text(high)} ${unit}` : "no values";
  const end = document.createElement("span");
  end.textContent = `to step ${last}`;
  ends.append(range, end);
  figure.append(caption, plot, ends);
  return figure;
}

function show() {
  const place = document.getElementById("drawn");
  if (columns.length === 0) {
    place.textContent = "There are no measurements.";
    return;
  }
  place.replaceChildren(...chosen.filter(column).map(drawn));
}

export async function load() {
  columns = await postForJson("measurements", { settings: settings() }).catch(() => columns);
  const others = columns.filter((one) => one.name !== "step" && one.name !== "time");
  const list = document.getElementById("column");
  if (list.options.length !== others.length) {
    list.replaceChildren(...others.map((one) => new Option(one.name.replaceAll("_", " "), one.name)));
  }
  if (chosen.length === 0) {
    const moving = others.filter((one) => varies(one.values));
    chosen.push(...(moving.length ? moving : others).slice(0, 4).map((one) => one.name));
  }
  show();
}

export function start() {
  document.getElementById("add-plot").addEventListener("click", () => {
    const name = document.getElementById("column").value;
    if (name && !chosen.includes(name)) chosen.unshift(name);
    show();
  });
  follow((what) => (what === "moment" || what === "newest") && show());
  load();
}
