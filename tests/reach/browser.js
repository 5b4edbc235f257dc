// A headless Chromium at the end of its debugging pipe: const browser = open(PROGRAM, [ARGUMENTS]).
"use strict";
const { spawn } = require("child_process");
const fs = require("fs");
const os = require("os");
const path = require("path");

const pause = (ms) => new Promise((done) => setTimeout(done, ms));

exports.open = (program, more) => {
  const profile = fs.mkdtempSync(path.join(os.tmpdir(), "fumon-view-"));
  const child = spawn(program, ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars", ...more,
    "--remote-debugging-pipe", `--user-data-dir=${profile}`], { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
  const waiting = new Map();
  const faults = [];
  let last = 0;
  let text = "";
  let session;
  child.stdio[4].on("data", (data) => {
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
      child.stdio[3].write(JSON.stringify({ id: last, method, params, sessionId: session }) + "\0");
    });
  }

  async function evaluate(expression) {
    const { result, exceptionDetails } = await send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  return {
    faults,
    send,
    evaluate,
    pause,
    /** Opens an address in a page of its own. */
    async show(url) {
      session = undefined;
      const { targetId } = await send("Target.createTarget", { url: "about:blank" });
      session = (await send("Target.attachToTarget", { targetId, flatten: true })).sessionId;
      for (const domain of ["Page", "Runtime", "Log"]) await send(domain + ".enable");
      await this.size(1440, 900, false);
      await send("Page.navigate", { url });
    },
    size: (width, height, mobile) => send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: mobile ? 2 : 1, mobile }),
    scheme: (value) => send("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value }] }),
    /** Waits for what an expression tells; `why` is another one that says more where it does not come. */
    async until(expression, what, why = "''") {
      for (let i = 0; i < 300; ++i) {
        if (await evaluate(expression)) return;
        await pause(100);
      }
      throw new Error(`${what}: ${await evaluate(why)}`);
    },
    async screenshot(folder, name) {
      const { data } = await send("Page.captureScreenshot", { format: "png" });
      if (!folder) return;
      fs.mkdirSync(folder, { recursive: true });
      fs.writeFileSync(path.join(folder, name + ".png"), Buffer.from(data, "base64"));
    },
    async drag(id, by, buttons = 1, modifiers = 0) {
      const box = await evaluate(`(({x,y,width,height}) => ({x,y,width,height}))(document.getElementById('${id}').getBoundingClientRect())`);
      const x = box.x + box.width / 2;
      const y = box.y + box.height / 2;
      const mouse = (type, share) => send("Input.dispatchMouseEvent", { type, x: x + share * by[0], y: y + share * by[1], button: "left", buttons, clickCount: 1, modifiers });
      await mouse("mousePressed", 0);
      for (let i = 1; i <= 5; ++i) { await mouse("mouseMoved", i / 5); await pause(30); }
      await mouse("mouseReleased", 1);
      await pause(200);
    },
    /** Ends it; the program then ends with a status. */
    close(status) {
      child.on("exit", async () => {
        for (let left = 100; left > 0; --left) {  // its helpers may still write into the profile
          try { fs.rmSync(profile, { recursive: true, force: true }); break; } catch { await pause(100); }
        }
        process.exit(status);
      });
      child.kill();
    },
  };
};
