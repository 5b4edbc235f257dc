// The pages of a gallery: a picture opens over the list, arrow keys, buttons and swipes go on to the next one. The address
// holds the picture's name, so that it can be linked and the browser's way back closes it. Without scripts links lead nowhere,
// and the list is all there is.
"use strict";
const cards = [...document.querySelectorAll(".card")];
const sheets = cards.map(card => document.getElementById(card.hash.slice(1)));
const paging = document.getElementById("paging");
let open = -1;

function close() {
  if (open < 0) return;
  sheets[open].querySelectorAll("video").forEach(video => video.pause());
  document.body.append(paging);
  sheets[open].close();
  cards[open].focus();
  open = -1;
}

function show(number) {
  close();
  open = number;
  sheets[open].append(paging);
  sheets[open].showModal();
  sheets[open].scrollTop = 0;
  const film = sheets[open].querySelector("video");
  if (film) film.play().catch(() => {});
}

function follow() {
  const number = sheets.findIndex(sheet => "#" + sheet.id === location.hash);
  if (number >= 0) show(number); else close();
}

function leave() { history.replaceState(null, "", location.pathname + location.search); close(); }

function turn(by) {
  const number = (open + by + cards.length) % cards.length;
  history.replaceState(null, "", cards[number].hash);
  show(number);
}

function columns() {
  const top = cards[0].offsetTop;
  const count = cards.findIndex(card => card.offsetTop !== top);
  return count < 0 ? cards.length : count;
}

addEventListener("hashchange", follow);
sheets.forEach(sheet => sheet.addEventListener("cancel", event => { event.preventDefault(); leave(); }));
document.getElementById("before").onclick = () => turn(-1);
document.getElementById("after").onclick = () => turn(1);
document.getElementById("close").onclick = leave;

addEventListener("keydown", event => {
  if (event.ctrlKey || event.altKey || event.metaKey || event.target.closest("video, pre, .table")) return;
  const steps = { ArrowLeft: -1, ArrowRight: 1 };
  if (open >= 0) {
    if (event.key in steps) { event.preventDefault(); turn(steps[event.key]); }
    return;
  }
  steps.ArrowUp = -columns();
  steps.ArrowDown = columns();
  if (!(event.key in steps)) return;
  const at = cards.indexOf(document.activeElement);
  const next = at < 0 ? 0 : at + steps[event.key];
  if (next >= 0 && next < cards.length) { event.preventDefault(); cards[next].focus(); }
});

let began = null;
addEventListener("touchstart", event => {
  began = event.touches.length === 1 && !event.target.closest("video, pre, .table") ? event.touches[0] : null;
}, { passive: true });
addEventListener("touchend", event => {
  if (open < 0 || began === null) return;
  const across = event.changedTouches[0].clientX - began.clientX;
  const down = event.changedTouches[0].clientY - began.clientY;
  if (Math.abs(across) > 60 && Math.abs(across) > 2 * Math.abs(down)) turn(across < 0 ? 1 : -1);
});

// A film's picture in the list is that of its middle, and it plays under the pointer.
for (const card of cards) {
  const film = card.querySelector("video");
  if (!film) continue;
  film.addEventListener("loadedmetadata", () => { film.currentTime = film.duration / 2; }, { once: true });
  card.addEventListener("mouseenter", () => film.play().catch(() => {}));
  card.addEventListener("mouseleave", () => film.pause());
}

for (const button of document.querySelectorAll(".copy")) {
  button.onclick = () => {
    const text = button.previousElementSibling;
    getSelection().selectAllChildren(text);
    const told = () => { button.textContent = "Copied"; };
    if (navigator.clipboard) navigator.clipboard.writeText(text.textContent).then(told, () => {});
    else if (document.execCommand("copy")) told();
  };
}

follow();
