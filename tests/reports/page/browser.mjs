// The fixture's report in headless Chromium, for the tests of its page: made once, opened from disk, removed after them. The arguments
// of the test are FIXTURE_PROGRAM REPORTS_FOLDER CHROMIUM.
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import os from "node:os";
import path from "node:path";
import { after, before } from "node:test";
import { pathToFileURL } from "node:url";

export const [fixture, reports, browserProgram] = process.argv.slice(2);
const lacking = !browserProgram || !existsSync(browserProgram) ? "Chromium is not installed"
  : ["vega", "playwright-core"].find((name) => !existsSync(path.join(reports, "node_modules", name))) ? "npm ci was not run in reports/" : null;
if (lacking) {
  console.log(`skipped: ${lacking}`);
  process.exit(77);
}
const { chromium } = createRequire(path.join(reports, "package.json"))("playwright-core");

export const folder = mkdtempSync(path.join(os.tmpdir(), "gibench-page-"));
export const report = path.join(folder, "report");
export let browser;

before(async () => {
  execFileSync(fixture, [folder], { stdio: "ignore" });
  browser = await chromium.launch({
    executablePath: browserProgram,
    args: ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
      "--disable-component-update", "--disable-sync"],
  });
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

// A page of the report; `problems` collects console errors, exceptions, failed files and requests that leave the disk.
export async function open({ width = 1280, hash = "" } = {}) {
  const page = await browser.newPage({ viewport: { width, height: 900 } });
  page.setDefaultTimeout(300000);  // other tests run beside this one: what is waited for comes, however long it takes
  const problems = [];
  page.on("console", (message) => { if (["error", "warning"].includes(message.type())) problems.push(message.text()); });
  page.on("pageerror", (error) => problems.push(error.message));
  page.on("requestfailed", (request) => problems.push(`${request.url()} failed`));
  page.on("request", (request) => { if (!/^(file|data|blob):/.test(request.url())) problems.push(`asks ${request.url()}`); });
  await page.goto(pathToFileURL(path.join(report, "index.html")).href + hash);
  return { page, problems };
}

export async function readThrough(page) {
  const height = await page.evaluate(() => document.documentElement.scrollHeight);
  for (let y = 0; y < height; y += 500) {
    await page.evaluate((at) => scrollTo(0, at), y);
    await page.waitForTimeout(30);
  }
}

// The first scene's viewer with a picture of noise on the left, drawn.
export async function openViewer() {
  const { page, problems } = await open();
  const scene = page.locator("section.scene").first();
  await scene.scrollIntoViewIfNeeded();
  const stage = scene.locator(".stage");
  await page.waitForFunction(() => document.querySelector(".stage").dataset.drawn >= "1");
  await redrawn(page, () => scene.locator("select[id$=-left]").selectOption({ label: "pathtracer 16 spp" }));
  return { page, problems, scene, stage };
}

// Waits until the viewer has drawn again after `change`.
export async function redrawn(page, change) {
  const before = await page.evaluate(() => +document.querySelector(".stage").dataset.drawn);
  await change();
  await page.waitForFunction((count) => +document.querySelector(".stage").dataset.drawn > count, before);
}

// The stage without what lies over its pictures, so that only pixels of the pictures count.
export async function picture(page, stage) {
  await page.addStyleTag({ content: ".divider, .corner { display: none }" });
  return (await stage.screenshot()).toString("base64");
}
