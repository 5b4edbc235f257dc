// The looks that fumon ships, as small pictures of what is shown: a click takes the look's keys.
import { client, get, post } from "./server.js";
import { pictureRequest, remember, set, settings, state, tell } from "./state.js";

const place = document.getElementById("presets");
let looks = null;
let shown = "";  // what the pictures show

const words = (name) => name.replaceAll("-", " ");

/** Keys of looks that this page knows. */
const known = (look) => Object.fromEntries(Object.entries(look.settings).filter(([path]) => state.keys.has(path)));

function tile(look) {
  const button = document.createElement("button");
  button.type = "button";
  const image = document.createElement("img");
  image.alt = "";
  button.append(image, words(look.name));
  button.addEventListener("click", () => {
    remember();
    set(known(look));
    tell("changes");
  });
  look.image = image;
  return button;
}

/** One after the other, so that the large picture waits for one at most. */
async function draw() {
  const now = JSON.stringify([state.moment, state.place, [...state.changes].filter(([path]) => /^(camera|model)\./.test(path))]);
  if (!place.open || now === shown) return;
  shown = now;
  for (const look of looks) {
    if (shown !== now) return;
    const request = { ...pictureRequest(), settings: settings(known(look)), draft: true, width: 160, height: 90, client: `${client} looks` };
    const response = await post("picture", request).catch(() => null);
    if (!response) continue;
    if (look.image.src) URL.revokeObjectURL(look.image.src);
    look.image.src = URL.createObjectURL(await response.blob());
  }
}

export function start() {
  place.addEventListener("toggle", async () => {
    if (!place.open) return;
    if (!looks) {
      looks = await get("presets").catch(() => []);
      place.querySelector("div").replaceChildren(...looks.map(tile));
    }
    draw();
  });
}
