// node page.js BROWSER PAGE BEDS [FOLDER]: opens a page of `fumon export` from its file as a user does: the picture is drawn, the
// camera moves by mouse and keys, time passes, and the heights that it holds are those of the files in the folder BEDS, STEP.asc for
// each bed. Writes screenshots into FOLDER.
"use strict";
const fs = require("fs");
const path = require("path");
const [program, page, beds, folder] = process.argv.slice(2);
const browser = require("./browser.js").open(program, ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"]);
const { evaluate, send, until, pause } = browser;
const expect = (truth, what) => { if (!truth) throw new Error(what); };
const message = "document.getElementById('message')?.textContent";
const url = "file://" + path.resolve(page);
const expected = fs.readdirSync(beds).map((file) => ({ step: Number(path.parse(file).name), values: heightsOf(path.join(beds, file)) }))
  .sort((a, b) => a.step - b.step);
const rounded = JSON.parse(/id="data">(.*?)<\/script>/s.exec(fs.readFileSync(page, "utf8"))[1]).heights.step;
const last = expected.length - 1;
const shows = (bed) => until(`document.getElementById('stage').dataset.bed === '${bed}'`, `bed ${bed} is not shown`, message);

/** Of an ESRI ASCII grid, whose first row is the northernmost; null without data. */
function heightsOf(file) {
  const lines = fs.readFileSync(file, "utf8").trim().split("\n");
  const first = lines.findIndex((line) => /^\s*[-+.\d]/.test(line));
  const nodata = lines.slice(0, first).map((line) => line.split(/\s+/)).find(([key]) => key.toLowerCase() === "nodata_value");
  return lines.slice(first).reverse().flatMap((line) => line.trim().split(/\s+/))
    .map((text) => (nodata && Number(text) === Number(nodata[1]) ? null : Number(text)));
}

/** The levels of the canvas, small, as text: read in the frame in which it is drawn. */
const pixels = () => evaluate(`new Promise((done) => requestAnimationFrame(() => {
  document.getElementById('stage').dispatchEvent(new PointerEvent('pointerleave'));  // draws it again
  requestAnimationFrame(() => {
    const copy = new OffscreenCanvas(160, 100).getContext('2d');
    copy.drawImage(document.getElementById('canvas'), 0, 0, 160, 100);
    done(Array.from(copy.getImageData(0, 0, 160, 100).data).join());
  });
}))`);

/** How many colours it has where something is drawn. */
function coloursOf(text) {
  const levels = text.split(",");
  const all = new Set();
  for (let i = 0; i < levels.length; i += 4) if (levels[i + 3] !== "0") all.add(levels.slice(i, i + 3).join());
  return all.size;
}

async function press(key) {
  await send("Input.dispatchKeyEvent", { type: "keyDown", key, ...(key.length === 1 ? { text: key } : {}) });
  await send("Input.dispatchKeyEvent", { type: "keyUp", key });
  await pause(100);
}

async function compareHeights() {
  for (let bed = 0; bed <= last; ++bed) {
    const read = await evaluate(`Array.from(fumonHeights(${bed}), (height) => (Number.isNaN(height) ? null : height))`);
    const wanted = expected[bed].values;
    expect(read.length === wanted.length, `bed ${bed} has ${read.length} heights, not ${wanted.length}`);
    const worst = read.reduce((most, height, i) => {
      if ((height === null) !== (wanted[i] === null)) return Infinity;
      return height === null ? most : Math.max(most, Math.abs(height - wanted[i]));
    }, 0);
    expect(worst <= 0.51 * rounded, `bed ${bed}: a height is off by ${worst}, in steps of ${rounded}`);
  }
}

async function use() {
  await browser.show(url);
  await until("document.getElementById('canvas')?.hidden === false && document.getElementById('poster').hidden", "the picture is not drawn", message);
  await shows(last);
  const first = await pixels();
  expect(coloursOf(first) > 50, `the picture has ${coloursOf(first)} colours`);
  await browser.screenshot(folder, "page-desktop");
  await browser.drag("stage", [150, 30]);
  const turned = await pixels();
  expect(turned !== first, "a drag does not turn the block");
  await browser.screenshot(folder, "page-turned");
  await press("r");
  expect((await pixels()) === first, "the key R does not give the first view back");
  for (const key of ["ArrowLeft", "ArrowUp", "+"]) {
    const before = await pixels();
    await press(key);
    expect((await pixels()) !== before, `the key ${key} moves nothing`);
  }
  await press("r");

  await press("Home");
  await shows(0);
  expect((await pixels()) !== first, "the first bed looks like the last");
  await press("]");
  await shows(1);
  await evaluate("(() => { const slider = document.getElementById('moment'); slider.value = 2; slider.dispatchEvent(new Event('input')); })()");
  await shows(2);
  const label = await evaluate("document.getElementById('step').textContent");
  expect(label.includes(String(expected[2].step)), `the label of step ${expected[2].step} is ${label}`);
  await browser.screenshot(folder, "page-earlier");
  await press(" ");  // plays to the end
  await shows(last);
  await until("document.getElementById('play').getAttribute('aria-label') === 'play'", "playing does not end");
  expect((await pixels()) === first, "the last bed looks another way after playing");
  await compareHeights();

  await evaluate("globalThis.lost = document.getElementById('canvas').getContext('webgl2').getExtension('WEBGL_lose_context'); lost.loseContext()");
  await pause(200);
  await evaluate("lost.restoreContext()");
  await pause(500);
  expect((await pixels()) === first, "the picture does not come back after a loss of its context");

  await browser.scheme("dark");
  await pause(200);
  await browser.screenshot(folder, "page-dark");
  await browser.size(390, 844, true);
  await pause(500);
  expect(await evaluate("document.documentElement.scrollWidth <= document.documentElement.clientWidth"), "the page is wider than a phone");
  await browser.screenshot(folder, "page-phone");
  expect(await evaluate("globalThis.harmed === undefined"), "a script of a title ran");
  expect(browser.faults.length === 0, browser.faults.join("\n"));
}

use().then(() => 0, (fault) => { console.error(fault.message); return 1; }).then((status) => {
  if (status) console.error(browser.faults.join("\n"));
  browser.close(status);
});
