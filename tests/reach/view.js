// node view.js BROWSER ADDRESS [FOLDER]: uses the page of `fumon view` as a user does, and fails where it does not answer as it
// should; writes the settings of the still that it saves to settings.txt, and screenshots into the folder.
"use strict";
const { spawn } = require("child_process");
const fs = require("fs");
const os = require("os");
const path = require("path");
const [program, address, folder] = process.argv.slice(2);

const profile = fs.mkdtempSync(path.join(os.tmpdir(), "fumon-view-"));
const browser = spawn(program, ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars",
  "--remote-debugging-pipe", `--user-data-dir=${profile}`], { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
const waiting = new Map();
const faults = [];
let last = 0;
let text = "";
let session;
browser.stdio[4].on("data", (data) => {
  text += data;
  for (let end; (end = text.indexOf("\0")) >= 0; text = text.slice(end + 1)) heard(JSON.parse(text.slice(0, end)));
});

function heard(told) {
  if (told.id) {
    const { done, failed } = waiting.get(told.id);
    waiting.delete(told.id);
    if (told.error) failed(new Error(told.error.message)); else done(told.result);
  } else if (told.method === "Runtime.exceptionThrown") {
    faults.push("script: " + (told.params.exceptionDetails.exception?.description ?? told.params.exceptionDetails.text));
  } else if (told.method === "Log.entryAdded" && told.params.entry.level === "error") {
    faults.push(`log: ${told.params.entry.text} ${told.params.entry.url ?? ""}`);
  }
}

function send(method, params = {}) {
  return new Promise((done, failed) => {
    waiting.set(++last, { done, failed });
    browser.stdio[3].write(JSON.stringify({ id: last, method, params, sessionId: session }) + "\0");
  });
}

const pause = (ms) => new Promise((done) => setTimeout(done, ms));

async function evaluate(expression) {
  const { result, exceptionDetails } = await send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
  if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
  return result.value;
}

async function until(expression, what) {
  for (let i = 0; i < 300; ++i) {
    if (await evaluate(expression)) return;
    await pause(100);
  }
  throw new Error(`${what}: ${await evaluate("document.getElementById('message')?.textContent + ' ' + document.getElementById('told')?.textContent")}`);
}

const wholeIsSeen = "document.getElementById('picture').dataset.kind === 'whole' && !document.getElementById('stage').hasAttribute('aria-busy')";
const click = (id) => evaluate(`document.getElementById(${JSON.stringify(id)}).click()`);

async function screenshot(name) {
  if (!folder) return;
  fs.mkdirSync(folder, { recursive: true });
  const { data } = await send("Page.captureScreenshot", { format: "png" });
  fs.writeFileSync(path.join(folder, name + ".png"), Buffer.from(data, "base64"));
}

const size = (width, height, mobile) => send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: mobile ? 2 : 1, mobile });

async function drag(by, buttons = 1, modifiers = 0) {
  const box = await evaluate("(({x,y,width,height}) => ({x,y,width,height}))(document.getElementById('stage').getBoundingClientRect())");
  const x = box.x + box.width / 2;
  const y = box.y + box.height / 2;
  const mouse = (type, share) => send("Input.dispatchMouseEvent", { type, x: x + share * by[0], y: y + share * by[1], button: "left", buttons, clickCount: 1, modifiers });
  await mouse("mousePressed", 0);
  for (let i = 1; i <= 5; ++i) { await mouse("mouseMoved", i / 5); await pause(30); }
  await mouse("mouseReleased", 1);
  await pause(200);
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
  const { targetId } = await send("Target.createTarget", { url: "about:blank" });
  session = (await send("Target.attachToTarget", { targetId, flatten: true })).sessionId;
  for (const domain of ["Page", "Runtime", "Log"]) await send(domain + ".enable");
  await size(1440, 900, false);
  await send("Page.navigate", { url: address });
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
  browser.on("exit", () => { fs.rmSync(profile, { recursive: true, force: true }); process.exit(status); });
  browser.kill();
});
