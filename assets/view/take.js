// What is taken away: changed keys as text, a scene, a still, a film.
import { post, save } from "./server.js";
import { cameraSettings } from "./stage.js";
import { follow, settings, state, tell, value, pictureRequest } from "./state.js";

const at = (id) => document.getElementById(id);
const shots = [{ seconds: 6, keys: [] }];
let current = 0;

function told(text, wrong = false) {
  at("told").textContent = text;
  at("told").classList.toggle("wrong", wrong);
}

/** Runs what may be refused, and says what came of it. */
async function attempt(work) {
  try {
    told(await work());
  } catch (refusal) {
    told(refusal.message, true);
  }
}

/** All changed keys, those of the camera's place too. */
function changed() {
  const all = new Map();
  for (const setting of [...settings(), ...cameraSettings()]) {
    const end = setting.indexOf("=");
    all.set(setting.slice(0, end), setting.slice(end + 1));
  }
  return all;
}

function toml() {
  let text = "";
  let section = "";
  const tables = [...changed()].sort(([a], [b]) => (a < b ? -1 : 1));
  for (const [path, value] of tables) {
    const [first, ...rest] = path.split(".");
    if (first === "overlay") {
      text += `# overlay ${Number(rest[0]) + 1}: ${rest.slice(1).join(".")} = ${value}\n`;
      continue;
    }
    if (first !== section) text += `${text ? "\n" : ""}[${first}]\n`;
    section = first;
    text += `${rest.join(".")} = ${value}\n`;
  }
  return text;
}

const quoted = (text) => (/^[\w.=+/-]*$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);
const setLine = () => [...changed()].map(([path, value]) => `--set ${quoted(`${path}=${value}`)}`).join(" ");

async function copied(text, what) {
  if (!text) return "nothing is changed yet";
  await navigator.clipboard.writeText(text);
  return `${what} is copied`;
}

function draw() {
  at("changed").textContent = toml() || "nothing is changed";
  at("shots").replaceChildren(...shots.map((shot, number) => {
    const item = document.createElement("li");
    item.classList.toggle("current", number === current);
    const head = document.createElement("div");
    head.className = "head";
    const name = document.createElement("button");
    name.type = "button";
    name.textContent = `Shot ${number + 1}`;
    name.addEventListener("click", () => { current = number; draw(); });
    const seconds = document.createElement("input");
    Object.assign(seconds, { type: "number", min: 0.1, max: 3600, step: 0.5, value: shot.seconds });
    seconds.setAttribute("aria-label", `seconds of shot ${number + 1}`);
    seconds.addEventListener("change", () => { shot.seconds = Number(seconds.value) || shot.seconds; });
    const away = document.createElement("button");
    Object.assign(away, { type: "button", textContent: "×", title: "remove the shot" });
    away.setAttribute("aria-label", `remove shot ${number + 1}`);
    away.addEventListener("click", () => {
      shots.splice(number, 1);
      if (shots.length === 0) shots.push({ seconds: 6, keys: [] });
      current = Math.min(current, shots.length - 1);
      draw();
    });
    head.append(name, seconds, "s", away);
    const places = document.createElement("div");
    places.className = "places";
    places.append(...shot.keys.map((key, place) => {
      const button = document.createElement("button");
      Object.assign(button, { type: "button", textContent: `step ${key.step}`, title: `key ${place + 1}: show it` });
      button.addEventListener("click", () => look({ ...key, moment: momentOf(key) }));
      return button;
    }));
    if (shot.keys.length === 0) places.textContent = "no view yet";
    item.append(head, places);
    return item;
  }));
}

const momentOf = (key) => Math.max(0, state.subject.moments.findIndex((one) => one.step === key.step));

function look(key) {
  state.place = { eye: key.eye, target: key.target };
  state.moment = Math.min(key.moment, state.subject.moments.length - 1);
  tell("moment");
}

async function addKey() {
  if (value("camera.projection") !== '"perspective"') return "a film is seen in perspective; set camera.projection";
  const response = await post("camera", pictureRequest());
  if (!response) return "this moment is not computed yet";
  const { eye, target } = await response.json();
  shots[current].keys.push({ step: state.subject.moments[state.moment].step, eye, target });
  draw();
  return `shot ${current + 1} has ${shots[current].keys.length} views`;
}

const mixed = (a, b, share) => a.map((x, i) => x + share * (b[i] - x));

async function playFilm() {
  const wait = (ms) => new Promise((done) => setTimeout(done, ms));
  for (const shot of shots) {
    if (shot.keys.length === 0) continue;
    const start = performance.now();
    for (let share = 0; share < 1;) {
      share = Math.min(1, (performance.now() - start) / (1000 * shot.seconds));
      const place = share * (shot.keys.length - 1);
      const from = shot.keys[Math.floor(place)];
      const to = shot.keys[Math.ceil(place)];
      const between = place - Math.floor(place);
      const first = momentOf(shot.keys[0]);
      look({ eye: mixed(from.eye, to.eye, between), target: mixed(from.target, to.target, between),
             moment: Math.round(first + share * (momentOf(shot.keys.at(-1)) - first)) });
      await wait(120);
    }
  }
  return "";
}

/** What makes a run store the moments that are shown here. */
function storing(filled) {
  const steps = state.subject.moments.map((one) => one.step);
  const every = Math.max(1, steps[1] ?? 1);
  const fits = filled.every((shot) => shot.keys.every((key) => key.step % every === 0));
  return fits ? `output.fields_every=${every}` : `output.fields_at=[${steps.join()}]`;
}

export function start() {
  at("where").textContent = state.subject.saves ? `Files go to ${state.subject.folder}.` : "Files go to where this browser saves; fumon view --save DIR names a folder.";
  at("still-width").value = state.subject.image.width;
  at("still-height").value = state.subject.image.height;
  const onClick = (id, work) => at(id).addEventListener("click", () => attempt(work));
  onClick("copy-toml", () => copied(toml(), "TOML"));
  onClick("copy-set", () => copied(setLine(), "the line for a command"));
  onClick("save-scene", async () => `saved: ${await save("scene", { settings: [...settings(), ...cameraSettings()], name: at("scene-name").value })}`);
  onClick("save-still", async () => {
    told("drawing …");
    return `saved: ${await save("still", { ...pictureRequest(), width: Number(at("still-width").value), height: Number(at("still-height").value), name: at("still-name").value })}`;
  });
  onClick("add-key", addKey);
  onClick("play-film", playFilm);
  at("add-shot").addEventListener("click", () => { shots.push({ seconds: 6, keys: [] }); current = shots.length - 1; draw(); });
  onClick("save-film", async () => {
    const filled = shots.filter((shot) => shot.keys.length > 0);
    if (filled.length === 0) return "add a view first";
    const file = await save("film", { shots: filled, settings: settings().filter((one) => !one.startsWith("camera.")), name: at("film-name").value });
    const stored = !["computed", "computing"].includes(state.subject.state);
    const run = stored ? quoted(state.subject.name) : "out";
    const first = stored ? "" : `fumon run ${quoted(state.subject.name)} -o out --set ${quoted(storing(filled))}, then `;
    return `saved: ${file}; next ${first}fumon film ${run} ${quoted(file.split(",")[0])}`;
  });
  follow(draw);
  new MutationObserver(() => { at("changed").textContent = toml() || "nothing is changed"; }).observe(at("picture"), { attributes: true });
  draw();
}
