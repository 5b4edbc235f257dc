// node pages.js BROWSER PAGE...: axe's findings, errors of scripts, and what is wider than the page, at three widths in light and
// dark; of PAGE#NAME what opens there, with all of its details.
"use strict";
const fs = require("fs");
const path = require("path");
const puppeteer = require("puppeteer-core");
const axe = fs.readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

async function findings(browser, page, width, scheme) {
  const tab = await browser.newPage();
  const found = [];
  tab.on("pageerror", error => found.push("script: " + error.message));
  await tab.setViewport({ width, height: 900 });
  await tab.emulateMediaFeatures([{ name: "prefers-color-scheme", value: scheme }]);
  const [file, name] = page.split("#");
  await tab.goto("file://" + path.resolve(file) + (name ? "#" + name : ""), { waitUntil: "load" });
  const wide = await tab.evaluate(name => {
    for (const one of document.querySelectorAll("dialog[open] details")) one.open = true;
    const open = document.querySelector("dialog[open]");
    if (name && (!open || open.id !== name)) return "does not open";
    const over = [document.documentElement, open].filter(one => one && one.scrollWidth > one.clientWidth);
    return over.length > 0 ? "wider than the page" : "";
  }, name);
  if (wide) found.push(wide);
  await tab.evaluate(axe);
  const result = await tab.evaluate(() => axe.run(document));
  for (const one of result.violations)
    found.push(`${one.id}: ${one.help}: ${one.nodes.map(node => node.target.join(" ")).join(", ")}`);
  await tab.close();
  return found.map(text => `${page}, ${width} px, ${scheme}: ${text}`);
}

(async () => {
  const [executablePath, ...pages] = process.argv.slice(2);
  const browser = await puppeteer.launch({ executablePath, args: ["--no-sandbox"] });
  const found = [];
  for (const page of pages)
    for (const width of [360, 800, 1400])
      for (const scheme of ["light", "dark"]) found.push(...await findings(browser, page, width, scheme));
  await browser.close();
  for (const text of found) console.log(text);
  if (found.length > 0) process.exit(1);
  console.log("axe: no finding");
})();
