// The keys of the look, by their sections: each with its unit, range, default and help, changed ones marked.
import { made } from "./job.js";
import { post } from "./server.js";
import { canRedo, canUndo, follow, redo, remember, set, settings, state, tell, undo, value } from "./state.js";

const rows = new Map();
const list = document.getElementById("keys");
const search = document.getElementById("search");
const changedOnly = document.getElementById("changed-only");

function range(key) {
  const low = key.minimum ?? null;
  const high = key.maximum ?? null;
  if (low === null && high === null) return "";
  if (high === null) return `${key.minimum_excluded ? ">" : "≥"} ${low}`;
  if (low === null) return `≤ ${high}`;
  return key.minimum_excluded ? `> ${low} and ≤ ${high}` : `${low} to ${high}`;
}

const isText = (key) => key.type === "text" || key.type === "choice";
const shown = (key, toml) => {
  if (!toml.startsWith('"')) return toml;
  try { return JSON.parse(toml); } catch { return toml.slice(1, -1); }
};
/** What is typed, as TOML. */
function written(key, text) {
  const word = (key.values ?? []).some((one) => one.name === text);
  return isText(key) || word ? JSON.stringify(text) : text.trim();
}

function control(key, id) {
  if (key.type === "true or false") return made("input", { type: "checkbox", id });
  if (key.type === "choice") {
    return made("select", { id }, ...key.values.map((one) => made("option", { value: one.name, textContent: one.name, title: one.help })));
  }
  const input = made("input", { type: "text", id, spellcheck: false, autocomplete: "off" });
  if (key.type.includes("number") && !key.type.startsWith("list") && !key.values) {
    input.type = "number";
    input.step = "any";
  }
  if (key.values) {
    const words = made("datalist", { id: `${id}-words` }, ...key.values.map((one) => made("option", { value: one.name })));
    input.setAttribute("list", words.id);
    return [input, words];
  }
  return input;
}

function row(key) {
  const id = `key-${key.key.replaceAll(".", "-")}`;
  const [input, words] = [control(key, id)].flat();
  const name = key.key.slice(key.section.length + 1).replaceAll("_", " ").replace(/^\d+/, (number) => Number(number) + 1);
  const label = made("label", { htmlFor: id, title: key.key }, name, made("span", { className: "unit", textContent: key.unit }));
  const back = made("button", { type: "button", className: "back", textContent: "↺", title: "as it was" });
  back.setAttribute("aria-label", `${key.key} as it was`);
  if (key.fixed) input.disabled = true;
  const facts = [key.help, range(key), `default ${key.default}`, key.fixed].filter(Boolean).join("; ");
  const help = made("p", { className: "help", id: `${id}-help`, textContent: facts });
  input.setAttribute("aria-describedby", help.id);
  const wrong = made("p", { className: "wrong", hidden: true });
  wrong.setAttribute("role", "alert");
  const element = made("div", { className: "key" }, label, input, back, help, wrong, ...(words ? [words] : []));
  input.addEventListener("change", () => change(key, input.type === "checkbox" ? String(input.checked) : written(key, input.value)));
  back.addEventListener("click", () => change(key, key.value));
  rows.set(key.key, { key, element, input, wrong, name });
  return element;
}

async function change(key, text) {
  const { wrong } = rows.get(key.key);
  if (key.key.startsWith("overlay.") && text === "") return takeOverlayAway(key.key);
  let fault;
  try {
    ({ fault } = await (await post("check", { settings: settings({ [key.key]: text }) })).json());
  } catch (refusal) {
    fault = refusal.message;
  }
  if (fault) {
    wrong.textContent = fault.replaceAll(/^--set \d+(:\d+)?: /gm, "");
    wrong.hidden = false;
    return;
  }
  remember();
  if (key.section === "camera" && ["at", "look_at", "framing", "azimuth", "elevation", "distance"].includes(key.key.slice(7))) state.place = null;
  set({ [key.key]: text });
  tell("changes");
}

/** Of one that was added. */
function takeOverlayAway(path) {
  const begin = path.slice(0, path.lastIndexOf(".") + 1);
  const number = Number(path.split(".")[1]);
  remember();
  // Those behind it keep their numbers, so that it is hidden rather than taken out.
  const later = [...state.changes.keys()].some((one) => one.startsWith("overlay.") && Number(one.split(".")[1]) > number);
  if (later) set({ [`${begin}show`]: "false" });
  else for (const one of [...state.changes.keys()]) if (one.startsWith(begin)) state.changes.delete(one);
  tell("changes");
}

function show() {
  const sought = search.value.trim().toLowerCase();
  const counts = new Map();
  for (const [path, { key, element, input, wrong, name }] of rows) {
    const text = value(path);
    const changed = state.changes.has(path);
    if (document.activeElement !== input || wrong.hidden) {
      if (input.type === "checkbox") input.checked = text === "true";
      else input.value = shown(key, text);
    }
    if (document.activeElement !== input) wrong.hidden = true;
    element.classList.toggle("changed", changed);
    const fits = !sought || `${path} ${name} ${key.help} ${key.unit}`.toLowerCase().includes(sought);
    const absent = path.startsWith("overlay.") && value(path.replace(/\.[^.]*$/, ".kind")) === "";
    element.hidden = absent || !fits || (changedOnly.checked && !changed);
    const count = counts.get(key.section) ?? { changed: 0, seen: 0 };
    count.changed += changed;
    count.seen += !element.hidden;
    counts.set(key.section, count);
  }
  for (const part of list.children) {
    const count = counts.get(part.dataset.section);
    part.hidden = count.seen === 0;
    part.querySelector("summary span").textContent = count.changed || "";
    if (sought || changedOnly.checked) part.open = true;
  }
  document.getElementById("changed-count").textContent = state.changes.size ? `(${state.changes.size})` : "";
  document.getElementById("undo").disabled = !canUndo();
  document.getElementById("redo").disabled = !canRedo();
}

function add(key) {
  let part = list.querySelector(`[data-section="${key.section}"]`);
  if (!part) {
    part = made("details", { open: key.section === "camera" }, made("summary", {}, key.section, made("span")));
    part.dataset.section = key.section;
    list.append(part);
  }
  part.append(row(key));
}

/** One more overlay: its keys, of which the kind counts as changed. */
function addOverlay() {
  const numbers = [...state.keys.keys()].filter((path) => path.startsWith("overlay.")).map((path) => Number(path.split(".")[1]));
  const number = Math.max(-1, ...numbers) + 1;
  for (const one of state.subject.further_overlay) {
    const last = one.key.split(".").slice(2).join(".");
    const key = { ...one, key: `overlay.${number}.${last}` };
    if (last === "kind") key.value = "";  // there is none in the scene
    state.keys.set(key.key, key);
    add(key);
  }
  remember();
  set({ [`overlay.${number}.kind`]: JSON.stringify(document.getElementById("overlay-kind").value) });
  list.querySelector("[data-section=overlay]").open = true;
  tell("changes");
}

export function start() {
  for (const last of [false, true]) state.subject.keys.filter((key) => (key.section === "model") === last).forEach(add);
  const kinds = state.subject.further_overlay.find((one) => one.key.endsWith(".kind"));
  document.getElementById("overlay-kind").append(...kinds.values.map((one) => new Option(one.name, one.name)));
  document.getElementById("add-overlay").addEventListener("click", addOverlay);
  search.addEventListener("input", show);
  changedOnly.addEventListener("change", show);
  document.getElementById("undo").addEventListener("click", undo);
  document.getElementById("redo").addEventListener("click", redo);
  document.addEventListener("keydown", (event) => {
    const typing = ["INPUT", "SELECT"].includes(event.target.tagName) && event.target.type !== "range" && event.target.type !== "checkbox";
    if (typing || !(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z") return;
    event.preventDefault();
    if (event.shiftKey) redo(); else undo();
  });
  follow(show);
  show();
}
