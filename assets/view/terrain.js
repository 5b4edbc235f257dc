// Terrain that is dropped on the page, or chosen, is opened beside what is shown.
import { ask } from "./server.js";
import { complain } from "./stage.js";
import { state } from "./state.js";

const most = 64 * 1024 * 1024;
const home = `/${location.pathname.split("/")[1]}/`;
const chooser = document.getElementById("terrain-file");

async function open(file) {
  if (file.size > most) return complain(`${file.name} has more than 64 MB; open it with fumon view ${file.name}`);
  complain(`opening ${file.name} …`);
  try {
    const response = await ask(`${home}terrain?name=${encodeURIComponent(file.name)}`, { method: "POST", body: file });
    if (!response.ok) return complain(await response.text());
    location.href = home + (await response.json()).open;
  } catch (refusal) {
    complain(refusal.message);
  }
}

export function start() {
  if (!state.subject.drops) return;
  const button = document.getElementById("open-terrain");
  button.hidden = false;
  button.addEventListener("click", () => chooser.click());
  chooser.addEventListener("change", () => chooser.files[0] && open(chooser.files[0]));
  document.addEventListener("dragover", (event) => event.preventDefault());
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    const file = event.dataTransfer.files[0];
    if (file) open(file);
  });
}
