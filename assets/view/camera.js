// Turning, moving and flying with mouse, fingers and keys. Around the block by its three keys, as long as nothing
// moves the camera aside; from then on by its place.
import { post } from "./server.js";
import { remember, set, state, tell, value, pictureRequest } from "./state.js";

const stage = document.getElementById("stage");
let facts = null;
let known = "";

async function learn() {
  const now = JSON.stringify(pictureRequest());
  if (known === now) return true;
  const response = await post("camera", pictureRequest()).catch(() => null);
  if (!response) return false;
  facts = await response.json();
  known = now;
  return true;
}

const projection = () => value("camera.projection").replaceAll('"', "");
const fixed = () => state.subject.flat || projection() === "map";

function byKeys() {
  if (projection() !== "perspective") return true;
  return !state.place && value("camera.at") === "[]" && value("camera.look_at") === "[]" && value("camera.framing") === '"block"';
}

function free() {
  if (!state.place) state.place = { eye: [...facts.eye], target: [...facts.target] };
  return state.place;
}

const minus = (a, b) => a.map((x, i) => x - b[i]);
const plus = (a, b, k = 1) => a.map((x, i) => x + k * b[i]);
const length = (a) => Math.hypot(...a);
const number = (x) => String(Number(x.toPrecision(6)));

function axes({ eye, target }) {
  const way = minus(target, eye);
  const ahead = way.map((x) => x / length(way));
  const level = Math.hypot(ahead[0], ahead[1]) || 1e-9;
  const right = [ahead[1] / level, -ahead[0] / level, 0];
  const up = [right[1] * ahead[2], -right[0] * ahead[2], right[0] * ahead[1] - right[1] * ahead[0]];
  return { ahead, right, up, distance: length(way) };
}

function place(eye, target) {
  state.place = { eye, target };
}

function turn(right, up) {
  if (byKeys()) {
    facts.azimuth = ((((facts.azimuth + right) % 360) + 540) % 360) - 180;
    facts.elevation = Math.min(89.9, Math.max(1, facts.elevation + up));
    set({ "camera.azimuth": number((facts.azimuth + 360) % 360), "camera.elevation": number(facts.elevation) });
    return;
  }
  const { eye, target } = free();
  const from = minus(eye, target);
  const distance = length(from);
  const azimuth = Math.atan2(from[0], from[1]) + (right * Math.PI) / 180;
  const elevation = Math.min(1.55, Math.max(-0.5, Math.asin(from[2] / distance) + (up * Math.PI) / 180));
  const level = distance * Math.cos(elevation);
  place([target[0] + level * Math.sin(azimuth), target[1] + level * Math.cos(azimuth), target[2] + distance * Math.sin(elevation)], target);
}

/** In heights of the picture. */
function pan(right, up) {
  if (projection() !== "perspective") return;
  const at = free();
  const seen = axes(at);
  const scale = 2 * facts.tangent * seen.distance;
  const by = plus(seen.right.map((x) => x * right * scale), seen.up, up * scale);
  place(plus(at.eye, by), plus(at.target, by));
}

function dolly(factor) {
  if (byKeys()) {
    facts.distance = Math.min(100, Math.max(0.05, facts.distance * factor));
    set({ "camera.distance": number(facts.distance) });
    return;
  }
  const { eye, target } = free();
  place(plus(target, minus(eye, target), factor), target);
}

/** In block lengths. */
function fly(ahead, right, up) {
  if (projection() !== "perspective") return;
  const at = free();
  const seen = axes(at);
  const scale = facts.side;
  let by = seen.ahead.map((x) => x * ahead * scale);
  by = plus(by, seen.right, right * scale);
  by = plus(by, [0, 0, 1], up * scale);
  place(plus(at.eye, by), plus(at.target, by));
}

async function act(move, { again = false } = {}) {
  if (fixed() || !(await learn())) return;
  if (!again) remember();
  move();
  known = JSON.stringify(pictureRequest());
  if (state.place) Object.assign(facts, { eye: state.place.eye, target: state.place.target });
  tell("camera");
}

const pointers = new Map();
let acts = 0;
let spread = 0;

function middle() {
  const all = [...pointers.values()];
  const x = all.reduce((sum, p) => sum + p.x, 0) / all.length;
  const y = all.reduce((sum, p) => sum + p.y, 0) / all.length;
  return { x, y, apart: all.length > 1 ? Math.hypot(all[0].x - all[1].x, all[0].y - all[1].y) : 0 };
}

function dragged(event) {
  if (!pointers.has(event.pointerId)) return;
  const before = middle();
  pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  const now = middle();
  const dx = now.x - before.x;
  const dy = now.y - before.y;
  const moves = pointers.size > 1 || event.shiftKey || event.buttons === 2 || event.buttons === 4;
  const first = acts++ === 0;
  act(() => {
    if (moves) {
      pan(-dx / stage.clientHeight, dy / stage.clientHeight);
      if (before.apart > 0 && now.apart > 0) dolly(before.apart / now.apart);
    } else {
      turn(dx * 0.35, dy * 0.3);
    }
  }, { again: !first });
}

function released(event) {
  pointers.delete(event.pointerId);
  if (pointers.size === 0) {
    acts = 0;
    stage.classList.remove("moving");
  }
}

export function reset() {
  remember();
  for (const path of [...state.changes.keys()]) if (path.startsWith("camera.")) state.changes.delete(path);
  state.place = null;
  tell("changes");
}

function pressed(event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const far = event.shiftKey;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;  // with Caps Lock too
  const moves = {
    ArrowLeft: () => (far ? pan(-0.05, 0) : turn(-4, 0)), ArrowRight: () => (far ? pan(0.05, 0) : turn(4, 0)),
    ArrowUp: () => (far ? pan(0, 0.05) : turn(0, 3)), ArrowDown: () => (far ? pan(0, -0.05) : turn(0, -3)),
    "+": () => dolly(0.9), "=": () => dolly(0.9), "-": () => dolly(1 / 0.9),
    w: () => fly(0.03, 0, 0), s: () => fly(-0.03, 0, 0), a: () => fly(0, -0.03, 0), d: () => fly(0, 0.03, 0),
    e: () => fly(0, 0, 0.02), q: () => fly(0, 0, -0.02),
  };
  if (key === "r") reset();
  else if (moves[key]) act(moves[key], { again: event.repeat });
  else return;
  event.preventDefault();
}

export function start() {
  stage.addEventListener("pointerdown", (event) => {
    stage.focus({ preventScroll: true });
    stage.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    stage.classList.add("moving");
  });
  stage.addEventListener("pointermove", dragged);
  for (const name of ["pointerup", "pointercancel", "lostpointercapture"]) stage.addEventListener(name, released);
  stage.addEventListener("contextmenu", (event) => event.preventDefault());
  stage.addEventListener("wheel", (event) => {
    event.preventDefault();
    clearTimeout(spread);
    const first = spread === 0;
    spread = setTimeout(() => { spread = 0; }, 500);
    act(() => dolly(Math.exp(Math.max(-0.5, Math.min(0.5, event.deltaY * 0.0012)))), { again: !first });
  }, { passive: false });
  stage.addEventListener("dblclick", reset);
  stage.addEventListener("keydown", pressed);
}
