// The window of `fumon view`: reads what is shown, and starts the parts of the page.
import * as camera from "./camera.js";
import * as plots from "./plots.js";
import * as job from "./job.js";
import * as presets from "./presets.js";
import { get, postForJson } from "./server.js";
import * as settings from "./settings.js";
import * as stage from "./stage.js";
import { follow, settings as changed, state, tell } from "./state.js";
import * as take from "./take.js";
import * as terrain from "./terrain.js";

const at = (id) => document.getElementById(id);
const playing = "M4 3h3v10H4zM9 3h3v10H9z";
const paused = "M4 2.5 13 8l-9 5.5z";
let plays = null;
let atEnd = true;
let ended = false;        // the job of this program
let plotsLoaded = 0;      // when
let plotsPause = 3000;    // ms until the next time

const rounded = (number) => String(Number(number.toPrecision(6)));

function showTime() {
  const { moments, time_unit } = state.subject;
  const moment = moments[state.moment];
  const slider = at("moment");
  slider.max = moments.length - 1;
  slider.value = state.moment;
  slider.disabled = moments.length < 2;
  for (const id of ["first", "play", "last"]) at(id).disabled = moments.length < 2;
  const words = `step ${moment.step}${time_unit && time_unit !== "steps" ? `, ${rounded(moment.time)} ${time_unit}` : ""}`;
  slider.setAttribute("aria-valuetext", words);
  at("step").textContent = words;
}

function go(moment, what = "moment") {
  const last = state.subject.moments.length - 1;
  state.moment = Math.max(0, Math.min(last, moment));
  atEnd = state.moment === last;
  tell(what);
}

function stop() {
  clearInterval(plays);
  plays = null;
  at("play").querySelector("path").setAttribute("d", paused);
  at("play").setAttribute("aria-label", "play");
}

function play() {
  if (plays) return stop();
  if (state.moment === state.subject.moments.length - 1) go(0);
  at("play").querySelector("path").setAttribute("d", playing);
  at("play").setAttribute("aria-label", "pause");
  let shown = null;
  plays = setInterval(() => {  // the next when the present one is seen
    const now = String(state.subject.moments[state.moment].step);
    if (at("picture").dataset.step !== now && shown !== null) return;
    shown = now;
    if (state.moment >= state.subject.moments.length - 1) stop();
    else go(state.moment + 1);
  }, 150);
}

function showState({ state: word, step, target, cell_steps_per_second: speed, fault }) {
  let text = "";
  if (word === "computing") text = `computing step ${step} of ${target}${speed > 0 ? `, ${(speed / 1e6).toFixed(1)} million cell-steps/s` : ""}`;
  else if (word === "running") text = `running: step ${step} of ${target}`;
  else if (word === "interrupted" || word === "failed") text = `${word} at step ${step} of ${target}`;
  at("state").textContent = fault || text;
}

/** Measurements take the program time: less often where they take long. */
async function loadPlots() {
  const now = performance.now();
  if (now - plotsLoaded < plotsPause) return;
  plotsLoaded = Infinity;
  await plots.load();
  plotsLoaded = performance.now();
  plotsPause = Math.max(3000, 100 * (plotsLoaded - now));
}

const modelOf = () => [...state.changes].filter(([path]) => path.startsWith("model.")).map(String).sort().join();
let shownModel = "";

async function watch() {
  const changing = ["computing", "computed", "running", "interrupted", "unknown"];
  if (ended || !changing.includes(state.subject.state)) return;
  try {
    const model = modelOf();
    const progress = await postForJson("progress", { settings: changed() });
    if (ended) return;
    const was = state.subject.moments;
    const more = progress.moments.length !== was.length || progress.moments.some((one, i) => one.ready !== was[i].ready || one.step !== was[i].step);
    const step = was[state.moment].step;
    state.subject.moments = progress.moments;
    state.moment = Math.max(0, progress.moments.findLastIndex((one) => one.step <= step));
    state.subject.state = progress.state;
    showState(progress);
    if (more) {
      if (progress.moments.at(-1).step > step && atEnd && !plays && progress.follow) go(progress.moments.length - 1, state.live ? "newest" : "moment");
      showTime();
    }
    if (more && !state.live) plots.load();
    else if (more || progress.state === "running") loadPlots();
    if (model !== shownModel) {  // other values of the model: another run
      shownModel = model;
      plots.load();
    }
    if (ended) return;
    setTimeout(watch, progress.state === "computed" ? 700 : 1000);
  } catch (refusal) {
    if (ended) return;
    stage.complain(refusal.message);
    setTimeout(watch, 3000);
  }
}

function tabs() {
  const all = [...document.querySelectorAll("[role=tab]")].filter((tab) => !tab.hidden);
  const choose = (tab) => {
    for (const one of all) {
      one.setAttribute("aria-selected", String(one === tab));
      one.tabIndex = one === tab ? 0 : -1;
      at(one.getAttribute("aria-controls")).hidden = one !== tab;
    }
  };
  all.forEach((tab, i) => {
    tab.addEventListener("click", () => choose(tab));
    tab.addEventListener("keydown", (event) => {
      const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (!by) return;
      const next = all[(i + by + all.length) % all.length];
      choose(next);
      next.focus();
    });
  });
}

function times() {
  at("moment").addEventListener("input", () => { stop(); go(Number(at("moment").value)); });
  at("first").addEventListener("click", () => { stop(); go(0); });
  at("last").addEventListener("click", () => { stop(); go(Infinity); });
  at("play").addEventListener("click", play);
  at("stage").addEventListener("keydown", (event) => {
    const acts = { " ": play, Home: () => go(0), End: () => go(Infinity), "[": () => go(state.moment - 1), "]": () => go(state.moment + 1) };
    if (!acts[event.key]) return;
    event.preventDefault();
    acts[event.key]();
  });
  follow((what) => (what === "moment" || what === "newest") && showTime());
}

function watchJob() {
  at("tab-job").hidden = false;
  state.live = true;
  job.start(at("job"), async ({ outcome, stages }) => {
    if (!outcome || ended) return;
    ended = true;
    at("state").textContent = outcome;
    state.live = false;
    if (stages.length === 0) return;  // the program is gone already
    const { moments } = await postForJson("progress", { settings: changed() });
    await plots.load();
    state.subject.moments = moments;
    if (atEnd) go(Infinity, "newest");
    await stage.drawLast();
  });
}

async function start() {
  const subject = await get("subject");
  state.subject = subject;
  for (const key of subject.keys) state.keys.set(key.key, key);
  state.moment = ["complete", "running", "interrupted", "failed"].includes(subject.state) ? subject.moments.length - 1 : 0;
  const { nx, ny, dx, unit } = subject.grid;
  at("title").textContent = subject.title || subject.name;
  at("facts").textContent = `${subject.model}, ${nx} × ${ny} cells${unit === "m" ? ` of ${rounded(dx)} m` : ""}`;
  if (subject.title && subject.title !== subject.name) at("facts").textContent = `${subject.name}: ${at("facts").textContent}`;
  if (/\/run\/\d+\/$/.test(location.pathname)) at("facts").append(" ", Object.assign(document.createElement("a"), { href: "../../", textContent: "all runs" }));
  document.title = `${subject.title || subject.name} – fumon view`;
  if (subject.job) watchJob();
  tabs();
  times();
  showTime();
  settings.start();
  presets.start();
  terrain.start();
  take.start();
  plots.start();
  camera.start();
  stage.start();
  watch();
  if (subject.job) at("tab-job").click();
  if (window.parent !== window) window.parent.postMessage("fumon view", "*");  // a notebook's page, which then shows it
}

start().catch((refusal) => stage.complain(refusal.message));
