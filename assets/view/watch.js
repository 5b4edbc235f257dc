// The window of a job without a ground of its own, and of a sweep: the grid of its runs.
import * as job from "./job.js";
import { ask, get } from "./server.js";

const at = (id) => document.getElementById(id);
const { made } = job;

let sweep = null;
let ended = false;   // the job
let closed = false;  // and the program that serves the page soon
const chosen = { rows: -1, columns: -1 };
const others = new Map();  // axis → value that is shown
const pictures = new Map();  // run → its element

const pause = (ms) => new Promise((done) => setTimeout(done, ms));
const wanted = [];  // pictures to be drawn
let drawing = false;

/** One picture after the other; while the sweep goes on, as it has time for them. */
async function drawNext() {
  if (drawing) return;
  drawing = true;
  while (wanted.length > 0 && !closed) {
    const { run, image } = wanted[0];
    const response = await ask(`picture?run=${run}`).catch(() => null);
    if (!response) break;
    if (response.status === 202) {
      await pause(3000);
      continue;
    }
    wanted.shift();
    if (!response.ok) continue;
    image.src = URL.createObjectURL(await response.blob());
    image.hidden = false;
  }
  drawing = false;
}

const named = (axis) => `${axis.label}${axis.unit ? ` (${axis.unit})` : ""}`;
const withUnit = (axis, value) => `${value}${axis.unit ? ` ${axis.unit}` : ""}`;

function cell(run) {
  const words = `run ${run.number}: ${run.at.map((value, i) => `${sweep.axes[i].label} ${withUnit(sweep.axes[i], sweep.axes[i].values[value])}`).join(", ")}`;
  const content = made("span", { className: `run ${run.status}` });
  if (run.status === "done" && run.stored) {
    if (!pictures.has(run.number)) {
      const image = made("img", { alt: "", hidden: true });
      pictures.set(run.number, image);
      wanted.push({ run: run.number, image });
      drawNext();
    }
    content.append(pictures.get(run.number));
  } else {
    content.append(made("span", { className: "none", textContent: run.status === "done" ? "no bed stored" : run.status }));
  }
  if (run.message) content.append(made("span", { className: "why", textContent: run.message }));
  if (run.status !== "done" || !run.stored) {
    content.setAttribute("role", "img");
    content.setAttribute("aria-label", `${words}, ${run.status}${run.message ? `: ${run.message}` : ""}`);
    return content;
  }
  const link = made("a", { href: `run/${run.number}/`, title: words }, content);
  link.setAttribute("aria-label", `open ${words}`);
  return link;
}

function chooser(name, label, axes, value, change) {
  const list = made("select", { id: name });
  list.append(...axes);
  list.value = String(value);
  list.addEventListener("change", () => { change(Number(list.value)); show(true); });
  return made("label", {}, label, list);
}

/** Which axis goes along which side, and which value of every further one is shown. */
function choosers() {
  const place = at("axes");
  place.replaceChildren();
  if (sweep.axes.length < 3) return;
  const all = () => sweep.axes.map((axis, i) => new Option(axis.label, i));
  const swap = (side, other) => (value) => {
    if (chosen[other] === value) chosen[other] = chosen[side];
    chosen[side] = value;
  };
  place.append(chooser("rows", "rows", all(), chosen.rows, swap("rows", "columns")),
               chooser("columns", "columns", all(), chosen.columns, swap("columns", "rows")));
  sweep.axes.forEach((axis, i) => {
    if (i === chosen.rows || i === chosen.columns) return;
    place.append(chooser(`axis-${i}`, named(axis), axis.values.map((value, n) => new Option(value, n)), others.get(i) ?? 0, (value) => others.set(i, value)));
  });
}

function show(anew = false) {
  if (anew) choosers();
  const { rows, columns } = chosen;
  const one = { label: "", unit: "", values: [""] };
  const down = sweep.axes[rows] ?? one;
  const across = sweep.axes[columns] ?? one;
  const table = made("table");
  table.style.setProperty("--columns", across.values.length);
  if (sweep.axes[rows] || sweep.axes[columns]) {
    table.append(made("caption", { textContent: [sweep.axes[rows] && `down: ${named(down)}`, sweep.axes[columns] && `across: ${named(across)}`].filter(Boolean).join("; ") }));
  }
  if (sweep.axes[columns]) {
    table.append(made("thead", {}, made("tr", {}, made("td"), ...across.values.map((value) => made("th", { scope: "col", textContent: withUnit(across, value) })))));
  }
  const body = made("tbody");
  down.values.forEach((value, i) => {
    const row = made("tr", {}, made("th", { scope: "row", textContent: sweep.axes[rows] ? withUnit(down, value) : "" }));
    across.values.forEach((_, j) => {
      const fits = (run) => run.at.every((place, axis) => place === (axis === rows ? i : axis === columns ? j : others.get(axis) ?? 0));
      row.append(made("td", {}, ...sweep.runs.filter(fits).map(cell)));
    });
    body.append(row);
  });
  table.append(body);
  at("grids").replaceChildren(table);
  const count = (status) => sweep.runs.filter((run) => run.status === status).length;
  at("facts").textContent = `${sweep.runs.length} runs`;
  const failed = count("failed");
  at("state").textContent = `${count("done")} done${failed ? `, ${failed} failed` : ""}`;
}

async function load() {
  const fresh = await get("sweep");
  const anew = sweep === null;
  if (!anew && JSON.stringify(fresh) === JSON.stringify(sweep)) return;
  sweep = fresh;
  if (anew) {
    const seed = (i) => Number(sweep.axes[i].label === "seed");
    const [first, second] = sweep.axes.map((_, i) => i).sort((a, b) => seed(a) - seed(b) || a - b);
    chosen.rows = second === undefined ? -1 : first;
    chosen.columns = second ?? first;
  }
  show(anew);
}

async function follow() {
  if (ended) return;
  try {
    await load();
  } catch (refusal) {
    if (ended) return;
    at("state").textContent = refusal.message;
  }
  if (!ended && sweep?.runs.some((run) => run.status !== "done")) setTimeout(follow, 2000);
}

async function start() {
  const about = await get("about");
  at("title").textContent = about.title;
  document.title = `${about.title} – fumon view`;
  if (about.job) {
    at("job").hidden = false;
    job.start(at("job"), async ({ outcome, stages }) => {
      if (!about.sweep) at("state").textContent = outcome || stages.map(({ name, done, all }) => `${name} ${done} of ${all}`).join(", ");
      if (!outcome || ended) return;
      ended = true;
      if (!about.sweep || stages.length === 0) return;  // without stages the program is gone already
      await pause(1200);  // it looks at its folder once a second
      await load();
      for (let i = 0; i < 20 && drawing; ++i) await pause(100);
      closed = true;
    });
  }
  if (about.sweep) {
    at("sweep").hidden = false;
    follow();
  }
}

start().catch((refusal) => { at("state").textContent = refusal.message; });
