// The window of `fumon view`: reads what is shown, and starts the parts of the page.
import * as camera from "./camera.js";
import * as plots from "./plots.js";
import { get } from "./server.js";
import * as settings from "./settings.js";
import * as stage from "./stage.js";
import { follow, state, tell } from "./state.js";
import * as take from "./take.js";

const at = (id) => document.getElementById(id);
const playing = "M4 3h3v10H4zM9 3h3v10H9z";
const paused = "M4 2.5 13 8l-9 5.5z";
let plays = null;
let atEnd = true;

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

function go(moment) {
  const last = state.subject.moments.length - 1;
  state.moment = Math.max(0, Math.min(last, moment));
  atEnd = state.moment === last;
  tell("moment");
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

async function watch() {
  const changing = ["computing", "computed", "running", "interrupted", "unknown"];
  if (!changing.includes(state.subject.state)) return;
  try {
    const progress = await get("progress");
    const was = state.subject.moments;
    const more = progress.moments.length !== was.length || progress.moments.some((one, i) => one.ready !== was[i].ready);
    const step = was[state.moment].step;
    state.subject.moments = progress.moments;
    state.moment = Math.max(0, progress.moments.findIndex((one) => one.step === step));
    state.subject.state = progress.state;
    showState(progress);
    if (more) {
      if (progress.moments.length > was.length && atEnd && !plays) go(progress.moments.length - 1);
      showTime();
    }
    if (more || progress.state === "running") plots.load();
    setTimeout(watch, progress.state === "computed" ? 700 : 1000);
  } catch (refusal) {
    stage.complain(refusal.message);
    setTimeout(watch, 3000);
  }
}

function tabs() {
  const all = [...document.querySelectorAll("[role=tab]")];
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
  follow((what) => what === "moment" && showTime());
}

async function start() {
  const subject = await get("subject");
  state.subject = subject;
  for (const key of subject.keys) state.keys.set(key.key, key);
  state.moment = ["complete", "running", "interrupted", "failed"].includes(subject.state) ? subject.moments.length - 1 : 0;
  const { nx, ny, dx, unit } = subject.grid;
  at("title").textContent = subject.title || subject.name;
  at("facts").textContent = `${subject.model}, ${nx} × ${ny} cells${unit === "m" ? ` of ${rounded(dx)} m` : ""}`;
  document.title = `${subject.title || subject.name} – fumon view`;
  tabs();
  times();
  showTime();
  settings.start();
  take.start();
  plots.start();
  camera.start();
  stage.start();
  watch();
  if (window.parent !== window) window.parent.postMessage("fumon view", "*");  // a notebook's page, which then shows it
}

start().catch((refusal) => stage.complain(refusal.message));
