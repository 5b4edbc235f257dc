// node view.js BROWSER WHAT ADDRESS [FOLDER]: uses a page as a user does, and fails where it does not answer as it should;
// screenshots go into the folder. WHAT: "run" of `fumon view RUN` (the settings of the still that it saves go to settings.txt),
// "watch" of `fumon run --view`, whose run is watched to its end, "watch-sweep" of `fumon sweep --view` likewise, "sweep" of `fumon view SWEEP`, "scene" of `fumon view SCENE`,
// where other values of the model are computed and dem.asc is opened and filmed by the keyboard alone.
"use strict";
const fs = require("fs");
const [program, what, address, folder] = process.argv.slice(2);
const browser = require("./browser.js").open(program, ["--disable-gpu"]);
const { evaluate, faults, send, pause, size } = browser;
const until = (expression, what) => browser.until(expression, what,
  "[location.pathname.slice(33), document.getElementById('message')?.textContent, document.getElementById('told')?.textContent, document.getElementById('state')?.textContent].join(' | ')");

const wholeIsSeen = "document.getElementById('picture').dataset.kind === 'whole' && !document.getElementById('stage').hasAttribute('aria-busy')";
const click = (id) => evaluate(`document.getElementById(${JSON.stringify(id)}).click()`);

const screenshot = (name) => browser.screenshot(folder, name);

async function drag(...how) {
  await browser.drag("stage", ...how);
  await until(wholeIsSeen, "no whole picture after a drag");
}

const changed = () => evaluate("document.getElementById('changed').textContent");
const expect = (truth, what) => { if (!truth) throw new Error(what); };

async function saved(button) {
  await evaluate("document.getElementById('told').textContent = ''");
  await click(button);
  await until("document.getElementById('told').textContent.startsWith('saved: ')", `${button} saves nothing`);
}

async function key(id, value) {
  await evaluate(`(() => { const input = document.getElementById('key-${id}'); input.value = ${JSON.stringify(value)}; input.dispatchEvent(new Event('change')); })()`);
}

async function scrub(moment) {
  await evaluate(`(() => { const slider = document.getElementById('moment'); slider.value = ${moment}; slider.dispatchEvent(new Event('input')); })()`);
}

async function useRun() {
  await until(`document.readyState === 'complete' && ${wholeIsSeen}`, "no picture");
  expect(await evaluate("document.getElementById('picture').dataset.step") === "40", "a run is not shown at its last step");
  await screenshot("desktop");

  await drag([120, 40]);
  expect((await changed()).includes("azimuth ="), "a drag does not turn the camera");
  await click("undo");
  expect((await changed()) === "nothing is changed", "undo keeps the turn");
  await drag([60, 0], 1, 8);  // with Shift
  await until("document.getElementById('changed').textContent.includes('look_at = [')", "a drag with Shift does not move the camera");
  await screenshot("desktop-moved");
  await evaluate("document.getElementById('stage').focus()");
  await send("Input.dispatchKeyEvent", { type: "keyDown", key: "r", text: "r" });
  await until("document.getElementById('changed').textContent === 'nothing is changed'", "the key R does not give the first view back");

  await key("sun-elevation", "200");
  await until("[...document.querySelectorAll('.wrong')].some(one => !one.hidden && one.textContent.includes('sun.elevation is 200'))", "a wrong value is not refused");
  await key("sun-elevation", "60");
  await until("document.getElementById('changed').textContent.includes('elevation = 60')", "a key does not change");
  await key("look-colour_by", "height");
  await until("document.getElementById('changed').textContent.includes('colour_by = \"height\"')", "a word does not change");
  await scrub(2);
  await until("document.getElementById('picture').dataset.step === '20'", "time does not pass");
  await pause(200);
  await until(wholeIsSeen, "no whole picture after the slider");
  await screenshot("desktop-changed");

  await click("tab-take");
  fs.writeFileSync("settings.txt", "--set\nsun.elevation=60\n--set\nlook.colour_by=height");
  await saved("save-still");
  await saved("save-scene");
  await click("add-key");
  await until("document.querySelectorAll('#shots .places button').length === 1", "no view is added to a shot");
  await evaluate("document.getElementById('stage').focus()");
  for (let i = 0; i < 3; ++i) await send("Input.dispatchKeyEvent", { type: "keyDown", key: "ArrowRight" });
  await until(wholeIsSeen, "no whole picture after a key");
  await scrub(4);
  await click("add-key");
  await until("document.querySelectorAll('#shots .places button').length === 2", "no second view is added");
  await saved("save-film");
  await screenshot("desktop-take");
  await click("tab-plots");
  await until("document.querySelectorAll('#drawn svg path').length > 0", "no plots");
  await screenshot("desktop-plots");

  await size(390, 844, true);
  await pause(800);
  await until(wholeIsSeen, "no picture on a phone");
  await click("tab-settings");
  expect(await evaluate("document.documentElement.scrollWidth <= document.documentElement.clientWidth"), "the page is wider than a phone");
  await screenshot("phone");
  await evaluate("window.scrollTo(0, 500)");
  await pause(300);
  await screenshot("phone-scrolled");
}

/** Presses a key where the focus is. */
async function press(name, modifiers = 0) {
  const text = name.length === 1 ? name : name === "Enter" ? "\r" : undefined;
  const codes = { Tab: 9, Enter: 13, " ": 32, End: 35, Home: 36, ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40, Delete: 46, Backspace: 8 };
  const key = { key: name, modifiers, windowsVirtualKeyCode: codes[name] ?? name.toUpperCase().charCodeAt(0), ...(text ? { text } : {}) };
  await send("Input.dispatchKeyEvent", { type: "keyDown", ...key });
  await send("Input.dispatchKeyEvent", { type: "keyUp", ...key });
}

const focused = () => evaluate("document.activeElement?.id ?? ''");

/** Goes on with Tab until an element has the focus. */
async function tabTo(id) {
  for (let i = 0; i < 400; ++i) {
    if (await focused() === id) return;
    await press("Tab");
  }
  throw new Error(`Tab does not reach ${id}`);
}

async function tabBackTo(id) {
  for (let i = 0; i < 400; ++i) {
    if (await focused() === id) return;
    await press("Tab", 8);
  }
  throw new Error(`Shift and Tab do not reach ${id}`);
}

async function useWatch() {
  await until("document.querySelectorAll('#job progress').length === 2 && document.getElementById('picture').naturalWidth > 0", "a run does not tell how far it is");
  await until("document.getElementById('job-picture').naturalWidth > 0", "no newest frame");
  await screenshot("watch");
  await until("document.getElementById('state').textContent.startsWith('complete: ')", "the page does not hear that the run is complete");
  await until("document.getElementById('picture').dataset.step === '6000' && document.getElementById('picture').dataset.kind === 'whole'", "the end of the run is not shown");
  await screenshot("watch-end");
  await pause(1500);  // the server ends; nobody asks it any more
}

async function useSweep() {
  await until("document.querySelectorAll('#grids a img:not([hidden])').length === 3", "no pictures of the runs");
  expect(await evaluate("document.querySelectorAll('#grids .failed .why').length") === 1, "a run that failed is not marked");
  await screenshot("sweep");
  await size(390, 844, true);
  await pause(500);
  expect(await evaluate("document.documentElement.scrollWidth <= document.documentElement.clientWidth"), "the grid is wider than a phone");
  await screenshot("sweep-phone");
  await size(1440, 900, false);
  await evaluate("document.querySelector('#grids a').focus()");
  await press("Enter");
  await until(`location.pathname.endsWith('/run/1/') && document.getElementById('picture') && ${wholeIsSeen}`, "a click opens no run");
  await screenshot("sweep-run");
}

async function useWatchSweep() {
  await until("document.readyState === 'complete' && document.getElementById('job')?.textContent.includes('complete; ')", "the page does not hear that the sweep is complete");
  await until("document.querySelectorAll('#grids a').length === 3", "the grid stays as it was before the end");
  expect(await evaluate("document.getElementById('state').textContent") === "3 done", "not all runs are told as done");
}

async function useScene() {
  await until(`document.readyState === 'complete' && ${wholeIsSeen}`, "no picture");
  await key("model-creep_rate", "0.4");
  await until("document.getElementById('changed').textContent.includes('creep_rate = 0.4')", "a key of the model does not change");
  await scrub(3);
  await until("document.getElementById('picture').dataset.step === '3'", "another model is not computed");
  await key("model-creep_rate", "0.9");
  await until("[...document.querySelectorAll('.wrong')].some(one => !one.hidden && one.textContent.includes('model.creep_rate is 0.9'))", "a wrong value of the model is not refused");
  await click("add-overlay");
  await until("document.getElementById('changed').textContent.includes('overlay 1: kind = \"title\"')", "no overlay is added");
  await evaluate("document.getElementById('presets').open = true");
  await until("document.querySelectorAll('#presets img[src]').length > 8", "no pictures of the looks");
  await screenshot("scene");
  await evaluate("[...document.querySelectorAll('#presets button')].find(one => one.textContent === 'moon').click()");
  await until("document.getElementById('changed').textContent.includes('[sun]')", "a look is not taken");

  // A file as if it was dropped.
  await evaluate(`(async () => {
    const file = new File([${JSON.stringify(fs.readFileSync("dem.asc", "utf8"))}], "dem.asc");
    const transfer = new DataTransfer();
    transfer.items.add(file);
    document.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, cancelable: true }));
  })()`);
  await until("location.pathname.endsWith('/terrain/1/') && document.getElementById('title')?.textContent.includes('dem.asc')", "dropped terrain is not opened");
  await until(wholeIsSeen, "no picture of the terrain");

  // A film of three shots by the keyboard alone.
  for (let shot = 0; shot < 3; ++shot) {
    for (let view = 0; view < 2; ++view) {
      await tabBackTo("stage");
      for (let i = 0; i < 4; ++i) await press(shot === 1 ? "+" : shot === 2 ? "ArrowUp" : "ArrowRight");
      await pause(300);
      await tabTo(shot === 0 && view === 0 ? "tab-settings" : "tab-take");
      if (shot === 0 && view === 0) await press("ArrowRight");
      await tabTo("add-key");
      await press("Enter");
      await until(`document.querySelectorAll('#shots > li:last-child .places button').length === ${view + 1}`, "no view is added by the keyboard");
    }
    if (shot < 2) {
      await tabTo("add-shot");
      await press("Enter");
    }
  }
  await tabTo("save-film");
  await press("Enter");
  await until("document.getElementById('told').textContent.startsWith('saved: ')", "no film is saved by the keyboard");
  await screenshot("terrain-film");
}

const uses = { run: useRun, watch: useWatch, sweep: useSweep, "watch-sweep": useWatchSweep, scene: useScene };
async function use() {
  await browser.show(address);
  await uses[what]();
  expect(faults.length === 0, faults.join("\n"));
}

use().then(() => 0, (fault) => { console.error(fault.message); return 1; }).then((status) => {
  if (status) console.error(faults.join("\n"));
  browser.close(status);
});
