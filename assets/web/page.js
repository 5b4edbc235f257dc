// What moves the camera and time, and what is told beside the picture.
const part = (id) => document.getElementById(id);
const stage = part("stage");
const slider = part("moment");
const perSecond = 12;  // beds while it plays
let shown = { bed: -1, surfaces: null };
let wanted = run.beds.length - 1;
let loading = false;
let playing = null;
let asked = false;
let moved = false;  // whether the first view is left
let pointer = null;

const aspectOf = () => Math.max(canvas.clientWidth, 1) / Math.max(canvas.clientHeight, 1);

function draw() {
  if (asked) return;
  asked = true;
  requestAnimationFrame(() => {
    asked = false;
    if (!moved) fitPose(aspectOf());
    drawStage();
    tellView();
    tellPlace();
  });
}

async function load() {
  if (loading) return;
  loading = true;
  try {
    while (shown.bed !== wanted) {
      const bed = wanted;
      const bitmap = await pictureOf(bed);
      const surfaces = surfacesOf(bed);
      showBed(surfaces, bitmap);
      bitmap.close();
      shown = { bed, surfaces };
      stage.dataset.bed = bed;
      draw();
    }
  } finally {
    loading = false;
  }
}

function loadAgain() {
  shown = { bed: -1, surfaces: null };
  return load();
}

function goTo(bed) {
  wanted = Math.min(run.beds.length - 1, Math.max(0, bed));
  slider.value = wanted;
  const { label } = run.beds[wanted];
  part("step").textContent = label;
  slider.setAttribute("aria-valuetext", label);
  return load();
}

function play(on) {
  clearInterval(playing);
  playing = null;
  if (on) {
    if (wanted === run.beds.length - 1) goTo(0);
    playing = setInterval(() => {
      if (loading) return;
      if (wanted === run.beds.length - 1) play(false);
      else goTo(wanted + 1);
    }, 1000 / perSecond);
  }
  const word = on ? "pause" : "play";
  part("play").setAttribute("aria-label", word);
  part("play").title = `${word} (Space)`;
  part("play").querySelector("path").setAttribute("d", on ? "M4 3h3v10H4zM9 3h3v10H9z" : "M4 2.5 13 8l-9 5.5z");
}

/** A round length: 1, 2 or 5 times a power of ten. */
function roundLength(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  return power * (most >= 5 * power ? 5 : most >= 2 * power ? 2 : 1);
}

function lengthText(length) {
  if (run.length !== "m") return `${length} ${run.length}`;
  if (length >= 1000) return `${length / 1000} km`;
  if (length < 0.01) return `${Number((length * 1000).toPrecision(3))} mm`;
  return length < 1 ? `${Number((length * 100).toPrecision(3))} cm` : `${length} m`;
}

function tellView() {
  const perLength = canvas.clientHeight / (2 * run.tangent * pose.distance);
  const side = Math.max(...run.size);
  const length = roundLength((110 / perLength) * side);
  part("bar").style.width = `${(length / side) * perLength}px`;
  part("length").textContent = lengthText(Number(length.toPrecision(1)));
  part("needle").style.transform = `rotate(${180 - pose.azimuth}deg)`;
}

/** Where a ray comes to the surface. */
function groundUnder({ from, way }) {
  const [wide, tall] = run.extent;
  const { surface } = shown.surfaces;
  const step = Math.max(wide / columns, tall / rows) / (2 * Math.hypot(...way));
  const start = Math.max(0, pose.distance - 1.5) / Math.hypot(...way);
  for (let t = start; t < start + 4 / Math.hypot(...way); t += step) {
    const [x, y, z] = along(from, way, t);
    const column = Math.floor((x / wide + 0.5) * columns);
    const row = Math.floor((y / tall + 0.5) * rows);
    if (column < 0 || row < 0 || column >= columns || row >= rows) continue;
    const cell = row * columns + column;
    if (hasData(cell) && z <= surface[cell] && z >= run.base) return z > surface[cell] - 0.1 ? { column, row, cell } : null;
  }
  return null;
}

const short = (value) => String(Number(value.toPrecision(4)));

function tellPlace() {
  if (!pointer || !shown.surfaces) { part("place").textContent = ""; return; }
  const box = canvas.getBoundingClientRect();
  const x = (2 * (pointer.x - box.left)) / box.width - 1;
  const y = 1 - (2 * (pointer.y - box.top)) / box.height;
  const found = groundUnder(rayThrough(x, y, aspectOf()));
  if (!found) { part("place").textContent = ""; return; }
  const east = ((found.column + 0.5) / columns) * run.size[0];
  const north = ((found.row + 0.5) / rows) * run.size[1];
  const water = depthOf(shown.bed, found.cell);
  const unit = run.unit ? ` ${run.unit}` : "";
  part("place").textContent = `${short(east)}, ${short(north)} ${run.length}: height ${short(heightOf(shown.bed, found.cell))}${unit}` +
    (water > 0 ? `, water ${short(water)} m` : "");
}

function move(change) {
  moved = true;
  change();
  draw();
}

function reset() {
  moved = false;
  draw();
}

const pointers = new Map();

function middle() {
  const all = [...pointers.values()];
  const x = all.reduce((sum, p) => sum + p.x, 0) / all.length;
  const y = all.reduce((sum, p) => sum + p.y, 0) / all.length;
  return { x, y, apart: all.length > 1 ? Math.hypot(all[0].x - all[1].x, all[0].y - all[1].y) : 0 };
}

function dragged(event) {
  pointer = event.pointerType === "mouse" ? { x: event.clientX, y: event.clientY } : null;
  if (!pointers.has(event.pointerId)) { draw(); return; }
  const before = middle();
  pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  const now = middle();
  const [dx, dy] = [now.x - before.x, now.y - before.y];
  const pans = pointers.size > 1 || event.shiftKey || event.buttons === 2 || event.buttons === 4;
  move(() => {
    if (!pans) { turnBy(dx * 0.35, dy * 0.3); return; }
    panBy(-dx / canvas.clientHeight, dy / canvas.clientHeight);
    if (before.apart > 0 && now.apart > 0) dollyBy(before.apart / now.apart);
  });
}

function released(event) {
  pointers.delete(event.pointerId);
  if (pointers.size === 0) stage.classList.remove("moving");
}

function pressed(event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const far = event.shiftKey;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  const moves = {
    ArrowLeft: () => (far ? panBy(-0.05, 0) : turnBy(-4, 0)), ArrowRight: () => (far ? panBy(0.05, 0) : turnBy(4, 0)),
    ArrowUp: () => (far ? panBy(0, 0.05) : turnBy(0, 3)), ArrowDown: () => (far ? panBy(0, -0.05) : turnBy(0, -3)),
    "+": () => dollyBy(0.9), "=": () => dollyBy(0.9), "-": () => dollyBy(1 / 0.9),
  };
  const times = { " ": () => play(!playing), "[": () => goTo(wanted - 1), "]": () => goTo(wanted + 1), Home: () => goTo(0), End: () => goTo(run.beds.length - 1) };
  if (key === "r") reset();
  else if (moves[key]) move(moves[key]);
  else if (times[key]) times[key]();
  else return;
  event.preventDefault();
}

function listen() {
  stage.addEventListener("pointerdown", (event) => {
    stage.focus({ preventScroll: true });
    stage.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    stage.classList.add("moving");
  });
  stage.addEventListener("pointermove", dragged);
  stage.addEventListener("pointerleave", () => { pointer = null; draw(); });
  for (const name of ["pointerup", "pointercancel", "lostpointercapture"]) stage.addEventListener(name, released);
  stage.addEventListener("contextmenu", (event) => event.preventDefault());
  stage.addEventListener("wheel", (event) => {
    event.preventDefault();
    move(() => dollyBy(Math.exp(Math.max(-0.5, Math.min(0.5, event.deltaY * 0.0012)))));
  }, { passive: false });
  stage.addEventListener("dblclick", reset);
  stage.addEventListener("keydown", pressed);
  slider.addEventListener("input", () => { play(false); goTo(Number(slider.value)); });
  part("play").addEventListener("click", () => play(!playing));
  part("first").addEventListener("click", () => goTo(0));
  part("last").addEventListener("click", () => goTo(run.beds.length - 1));
  new ResizeObserver(draw).observe(canvas);
}

async function start() {
  if (typeof DecompressionStream === "undefined") throw new Error("no DecompressionStream");
  part("message").textContent = "unpacking …";
  await unpackBeds();
  canvas.hidden = false;
  startDrawing(loadAgain);
  slider.max = run.beds.length - 1;
  await goTo(run.beds.length - 1);
  part("poster").hidden = true;
  for (const id of ["compass", "scale"]) part(id).hidden = false;
  part("time").hidden = run.beds.length < 2;
  part("message").textContent = "";
  stage.classList.add("live");
  listen();
  draw();
}

/** For scripts: the heights of a bed, row by row from the south-west, in the run's unit; NaN without data. */
globalThis.fumonHeights = (bed) => Float64Array.from({ length: cellCount }, (_, cell) => (hasData(cell) ? heightOf(bed, cell) : NaN));

function giveUp(why) {
  play(false);
  canvas.hidden = true;
  part("poster").hidden = false;
  for (const id of ["compass", "scale", "time"]) part(id).hidden = true;
  part("place").textContent = "";
  part("message").textContent = `This browser cannot turn the bed (${why}); the picture shows its last state.`;
}

// A browser mostly gives back soon what it took away; stage.js then draws once more.
let losing = 0;
canvas.addEventListener("webglcontextlost", () => {
  losing = setTimeout(() => giveUp("its graphics were lost; load the page again"), 5000);
});
canvas.addEventListener("webglcontextrestored", () => clearTimeout(losing));
start().catch((fault) => giveUp(fault.message));
