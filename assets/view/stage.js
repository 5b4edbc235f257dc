// The picture: a draft while something moves, one at a time, then the whole.
import { post } from "./server.js";
import { follow, state, value, pictureRequest } from "./state.js";

const stage = document.getElementById("stage");
const picture = document.getElementById("picture");
const size = document.getElementById("size");
const message = document.getElementById("message");
const rest = 280;  // ms without a change, before the whole picture is drawn

let version = 0;   // of what is wanted
let drawn = 0;     // of the last draft
let shown = 0;     // of the picture that is seen
let drafting = false;
let over = false;  // the program ends: nothing is asked for any more but by the user
let whole = null;  // the timer
let wantsWhole = true;
let waits = null;  // for what is being computed
let camera = [];   // settings of the place that is shown

export const cameraSettings = () => (state.place ? camera : []);

export function complain(text) {
  message.textContent = text ?? "";
  message.hidden = !text;
}

async function show(response, kind, of) {
  if (of < shown) return;
  shown = of;
  const old = picture.src;
  picture.src = URL.createObjectURL(await response.blob());
  await picture.decode().catch(() => {});
  if (old) URL.revokeObjectURL(old);
  const step = response.headers.get("X-Fumon-Step");
  const seconds = Number(response.headers.get("X-Fumon-Seconds"));
  const place = response.headers.get("X-Fumon-Camera");
  camera = place ? JSON.parse(place) : [];
  picture.alt = `${state.subject.title || state.subject.name}, step ${step}`;
  picture.dataset.kind = kind;
  picture.dataset.step = step;
  size.textContent = `${picture.naturalWidth} × ${picture.naturalHeight}${kind === "draft" ? ", draft" : ""}, drawn in ${seconds.toFixed(2)} s`;
  complain(null);
}

/** Pixels of the picture that fit the stage, of the scene's shape, at most the scene's. */
function wholeSize() {
  const width = Number(value("image.width") ?? state.subject.image.width);
  const height = Number(value("image.height") ?? state.subject.image.height);
  const dots = window.devicePixelRatio || 1;
  const factor = Math.min(1, Math.max(0.05, Math.min((stage.clientWidth * dots) / width, (stage.clientHeight * dots) / height)));
  return { width: Math.max(16, Math.round(width * factor)), height: Math.max(16, Math.round(height * factor)) };
}

/** Whether it is shown then. */
async function drawWhole() {
  const of = version;
  stage.setAttribute("aria-busy", "true");
  try {
    const response = await post("picture", { ...pictureRequest(), ...wholeSize() });
    if (of !== version) return false;
    if (response) await show(response, "whole", of);
    else later();
    return Boolean(response);
  } catch (refusal) {
    if (of === version) complain(refusal.message);
    return false;
  } finally {
    if (of === version) stage.removeAttribute("aria-busy");
  }
}

/** Draws the present whole, as the last picture before the program ends. */
export async function drawLast() {
  over = true;
  wantsWhole = false;
  clearTimeout(whole);
  clearTimeout(waits);
  drawn = ++version;
  const of = version;
  for (let tries = 0; tries < 10 && of === version && !(await drawWhole()); ++tries) await pause(200);
  while (drafting && of === version) await pause(20);
}

const pause = (milliseconds) => new Promise((done) => { setTimeout(done, milliseconds); });

function later() {
  if (over) return;
  clearTimeout(waits);
  waits = setTimeout(() => refresh(!wantsWhole), 400);
}

async function draft() {
  if (drafting) return;
  drafting = true;
  while (drawn !== version) {
    drawn = version;
    const of = version;
    try {
      const response = await post("picture", { ...pictureRequest(), draft: true, width: 640, height: 360 });
      if (response) await show(response, "draft", of);
      else later();
    } catch (refusal) {
      complain(refusal.message);
      break;
    }
  }
  drafting = false;
  clearTimeout(whole);
  if (wantsWhole) whole = setTimeout(drawWhole, rest);
}

/** Something is to be seen otherwise. `onlyDraft`: the whole picture would hold up what is computed. */
export function refresh(onlyDraft = false) {
  ++version;
  wantsWhole = !onlyDraft;
  clearTimeout(whole);
  draft();
}

export function start() {
  follow((what) => what !== "progress" && refresh(what === "newest"));
  let resized = null;
  new ResizeObserver(() => {
    clearTimeout(resized);
    resized = setTimeout(() => { if (!over && !drafting && (wantsWhole || !state.live)) drawWhole(); }, 400);
  }).observe(stage);
  refresh(state.live);
}
