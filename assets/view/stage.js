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
let drafting = false;
let whole = null;  // the timer
let wantsWhole = true;
let waits = null;  // for what is being computed
let camera = [];   // settings of the place that is shown

export const cameraSettings = () => (state.place ? camera : []);

export function complain(text) {
  message.textContent = text ?? "";
  message.hidden = !text;
}

async function show(response, kind) {
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

export async function drawWhole() {
  const of = version;
  stage.setAttribute("aria-busy", "true");
  try {
    const response = await post("picture", { ...pictureRequest(), ...wholeSize() });
    if (of !== version) return;
    if (response) await show(response, "whole");
    else later();
  } catch (refusal) {
    if (of === version) complain(refusal.message);
  } finally {
    if (of === version) stage.removeAttribute("aria-busy");
  }
}

function later() {
  clearTimeout(waits);
  waits = setTimeout(() => refresh(!wantsWhole), 400);
}

async function draft() {
  if (drafting) return;
  drafting = true;
  while (drawn !== version) {
    drawn = version;
    try {
      const response = await post("picture", { ...pictureRequest(), draft: true, width: 640, height: 360 });
      if (response) await show(response, "draft");
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
    resized = setTimeout(() => { if (!drafting && (wantsWhole || !state.live)) drawWhole(); }, 400);
  }).observe(stage);
  refresh(state.live);
}
