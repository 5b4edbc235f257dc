// A job that goes on in the program which serves the page: how far it is, its messages and newest picture, and how to
// stop it.
import { ask, client } from "./server.js";

export const made = (name, properties = {}, ...parts) => {
  const element = Object.assign(document.createElement(name), properties);
  element.append(...parts);
  return element;
};
const counted = (number) => number.toLocaleString("en");

export function clock(seconds) {
  const whole = Math.round(seconds);
  const two = (number) => String(number).padStart(2, "0");
  const minutes = Math.floor(whole / 60);
  return minutes < 60 ? `${minutes}:${two(whole % 60)}` : `${Math.floor(minutes / 60)}:${two(minutes % 60)}:${two(whole % 60)}`;
}

/** Shows the job in an element, asks for it every second, and calls `heard` with each answer; after that of the end the
    program waits a moment for what `heard` still asks for. */
export function start(place, heard = () => {}) {
  const bars = made("div", { className: "bars" });
  const left = made("p", { className: "left" });
  const stop = made("button", { type: "button", id: "stop", textContent: "Stop" });
  const sure = made("button", { type: "button", id: "stop-sure", textContent: "Stop now; what is made is kept", hidden: true });
  const figure = made("figure", { hidden: true });
  const image = made("img", { id: "job-picture", alt: "" });
  const caption = made("figcaption");
  figure.append(caption, image);
  const heading = made("h2", { textContent: "Messages" });
  const messages = made("ol", { id: "messages" });
  place.append(bars, left, made("div", { className: "row" }, stop, sure), figure, heading, messages);
  const rows = new Map();
  let pictures = 0;
  let told = "";

  stop.addEventListener("click", () => { sure.hidden = !sure.hidden; if (!sure.hidden) sure.focus(); });
  sure.addEventListener("click", async () => {
    sure.hidden = true;
    stop.disabled = true;
    left.textContent = "stopping …";
    await ask("stop", { method: "POST", body: "{}" }).catch((refusal) => { left.textContent = refusal.message; });
  });

  function bar(name) {
    if (!rows.has(name)) {
      const words = made("span");
      const meter = made("progress", { max: 1, value: 0 });
      meter.setAttribute("aria-label", name);
      const row = made("div", {}, words, meter);
      rows.set(name, { words, meter });
      bars.append(row);
    }
    return rows.get(name);
  }

  function show(job) {
    for (const { name, done, all, pace } of job.stages) {
      const { words, meter } = bar(name);
      words.textContent = `${name} ${counted(done)} of ${counted(all)}${pace ? `, ${pace}` : ""}`;
      meter.max = Math.max(1, all);
      meter.value = done;
    }
    if (job.outcome) left.textContent = job.outcome;
    else if (job.stopping) left.textContent = "stopping …";
    else left.textContent = job.seconds_left > 0 ? `${clock(job.seconds_left)} left` : "";
    stop.disabled = Boolean(job.outcome) || job.stopping;
    if (stop.disabled) sure.hidden = true;
    const all = job.messages.join("\n");
    if (all !== told) {
      told = all;
      messages.replaceChildren(...job.messages.map((line) => made("li", { textContent: line })));
    }
    heading.hidden = job.messages.length === 0;
    if (job.pictures > pictures) {
      pictures = job.pictures;
      figure.hidden = false;
      caption.textContent = job.picture;
      image.alt = `newest picture: ${job.picture}`;
      image.src = `job-picture?number=${pictures}`;
    }
  }

  async function watch() {
    try {
      const job = await (await ask(`job?client=${client}`)).json();
      show(job);
      await heard(job);
      if (!job.outcome) {
        setTimeout(watch, 1000);
        return;
      }
      if (pictures > 0) await image.decode().catch(() => {});
      await ask(`job?client=${client}&last=1`);
    } catch (refusal) {
      left.textContent = refusal.message;
      stop.disabled = true;
      heard({ outcome: refusal.message, stages: [], messages: [] });
    }
  }
  watch();
}
