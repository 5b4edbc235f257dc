// node view.js BROWSER ADDRESS [FOLDER]: uses the page of `fumon view` as a user does, and fails where it does not answer as it
// should; writes the settings of the still that it saves to settings.txt, and screenshots into the folder.
"use strict";
const fs = require("fs");
const [program, address, folder] = process.argv.slice(2);
const browser = require("./browser.js").open(program, ["--disable-gpu"]);
const { evaluate, faults, send, pause, size } = browser;
const until = (expression, what) => browser.until(expression, what,
  "document.getElementById('message')?.textContent + ' ' + document.getElementById('told')?.textContent");

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

async function use() {
  await browser.show(address);
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
  expect(faults.length === 0, faults.join("\n"));
}

use().then(() => 0, (fault) => { console.error(fault.message); return 1; }).then((status) => {
  if (status) console.error(faults.join("\n"));
  browser.close(status);
});
