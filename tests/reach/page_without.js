// node page_without.js BROWSER PAGE: in a browser without WebGL a page of `fumon export` shows its poster and says so in a line.
"use strict";
const path = require("path");
const [program, page] = process.argv.slice(2);
const browser = require("./browser.js").open(program, ["--disable-gpu", "--disable-3d-apis"]);

async function use() {
  await browser.show("file://" + path.resolve(page));
  await browser.until("document.getElementById('message')?.textContent.includes('WebGL 2')", "nothing is said",
    "document.getElementById('message')?.textContent");
  if (!(await browser.evaluate("(({ hidden, naturalWidth }) => !hidden && naturalWidth === 960)(document.getElementById('poster'))")))
    throw new Error("the poster is not shown");
  if (!(await browser.evaluate("document.getElementById('time').hidden"))) throw new Error("time is offered");
}

use().then(() => 0, (fault) => { console.error(fault.message); return 1; }).then((status) => browser.close(status));
