// The report's page in headless Chromium, opened from disk: node page.test.mjs FIXTURE_PROGRAM REPORTS_FOLDER CHROMIUM
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readdirSync, readFileSync, rmSync } from "node:fs";
import path from "node:path";
import test from "node:test";
import { pathToFileURL } from "node:url";
import { browser, fixture, folder, open, openViewer, picture, readThrough, redrawn, report, reports } from "./browser.mjs";

const methods = ["pathtracer", "meshless", "spectral"];
const errorPlots = ".scene .plot-figure:has(figcaption:text('against time'))";

test("loads from disk without errors, warnings or requests that leave it", async () => {
  const { page, problems } = await open();
  await readThrough(page);
  await page.waitForFunction(() => [...document.querySelectorAll(".plot")].every((plot) => plot.dataset.drawn === "yes"));
  assert.deepEqual(problems, []);
  await page.close();
});

test("the sentence on top and its table are of the error that is shown", async () => {
  const { page, problems } = await open();
  const sentence = () => page.locator("#glance .verdict").textContent();
  const first = await sentence();
  assert.match(first, /^(On (none of \d+ scenes? does a method reach|\d+ of \d+ scenes? a method reaches) its error in the indirect irradiance at the surface samples sooner|No run can be compared)/);
  assert.ok((await page.locator("#glance tbody tr").count()) > 0);
  await page.locator("#error-choice label:has(input[value=image])").click();
  await page.waitForFunction((before) => document.querySelector("#glance .verdict").textContent !== before, first);
  assert.match(await sentence(), /in the camera image|No run can be compared/);
  assert.deepEqual(problems, []);
  await page.close();
});

test("the slider moves the border between two pictures, by keys and by dragging", async () => {
  const { page, problems, scene, stage } = await openViewer();
  const wipe = scene.locator("input.wipe");
  await wipe.focus();
  await page.keyboard.press("Home");
  const right = await picture(page, stage);
  await page.keyboard.press("End");
  const left = await picture(page, stage);
  assert.notEqual(left, right);
  const box = await stage.boundingBox();
  await page.mouse.move(box.x + box.width * 0.9, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.3, box.y + box.height / 2, { steps: 4 });
  await page.mouse.up();
  assert.ok(Math.abs((await wipe.inputValue()) - 300) <= 10);
  const between = await picture(page, stage);
  assert.notEqual(between, left);
  assert.notEqual(between, right);
  assert.match(await scene.locator(".readout").textContent(), /Pixel \d+, \d+ · pathtracer 16 spp: .* · .* W/);
  assert.deepEqual(problems, []);
  await page.close();
});

test("exposure, light and error maps change the pixels", async () => {
  const { page, problems, scene, stage } = await openViewer();
  const seen = [await picture(page, stage)];
  const check = async (change) => {
    await redrawn(page, change);
    const now = await picture(page, stage);
    assert.ok(!seen.includes(now));
    seen.push(now);
  };
  await check(async () => { await scene.locator("input.exposure").focus(); await page.keyboard.press("ArrowLeft"); });
  await check(() => scene.locator(".controls label:has(input[value=indirect])").click());
  await check(() => scene.locator("label:has(input[value=relative])").click());
  assert.match(await scene.locator(".viewer .colour-bar").textContent(), /^0 %2\.5 %5 %7\.5 %≥ 10 %$/);
  await check(async () => { await scene.locator("input.error-range").focus(); await page.keyboard.press("ArrowRight"); });
  await check(() => scene.locator("label:has(input[value=absolute])").click());
  await check(() => scene.locator("button.tile").nth(2).click());
  assert.deepEqual(problems, []);
  await page.close();
});

test("under every picture stands its relative error, until the pictures themselves show errors", async () => {
  const { page, problems, scene } = await openViewer();
  const maps = scene.locator(".tile canvas.map");
  assert.equal(await maps.count(), await scene.locator(".tile").count());
  await page.waitForFunction(() => [...document.querySelectorAll("section.scene .tile canvas.map")].slice(0, 2).every((map) => map.width > 1));
  assert.match(await scene.locator(".legend.maps .colour-bar").textContent(), /≥ 50 %$/);
  // Of the second tile: the same mean as when its picture shows the relative error.
  const note = scene.locator(".tile-note").nth(1), told = await note.textContent();
  assert.match(told, /^mean [\d.]+ %$/);
  await redrawn(page, () => scene.locator("label:has(input[value=relative])").click());
  await page.waitForFunction(() => document.querySelector("section.scene .tile canvas.map").hidden);
  assert.equal(await note.textContent(), told);
  assert.equal(await scene.locator(".legend.maps").isVisible(), false);
  assert.deepEqual(problems, []);
  await page.close();
});

test("pixels arrive as they were written", async () => {
  const { page } = await openViewer();
  const worst = await page.evaluate(async () => {
    const reference = gibench.study.scenes[0].pictures.find((picture) => picture.run === null);
    const values = await gibench.pixels.values(reference, "indirect");
    let worst = 0;
    for (let row = 0; row < reference.height; row += 1)
      for (let column = 0; column < reference.width; column += 1) {
        const x = (column + 0.5) / reference.width, y = (row + 0.5) / reference.height, lit = 0.6 + 0.6 * y;
        [0.35 * (1 - x) + 0.05, 0.12, 0.3 * x + 0.05].forEach((albedo, channel) => {
          const value = values[(row * reference.width + column) * 3 + channel];
          worst = Math.max(worst, Math.abs(value / (albedo * lit) - 1));
        });
      }
    return worst;
  });
  assert.ok(worst < 2 ** -10, `relative error ${worst}`);
  await page.close();
});

test("every plot of error against time shows every method, and has its table", async () => {
  const { page } = await open();
  await readThrough(page);
  const plots = page.locator(errorPlots);
  assert.equal(await plots.count(), 2);
  for (let k = 0; k < 2; k += 1) {
    await plots.nth(k).locator(".plot[data-drawn=yes] svg.marks").waitFor();
    const labels = await plots.nth(k).locator(".role-legend-label text").allTextContents();
    const points = await plots.nth(k).locator("path[aria-roledescription=point]").evaluateAll((marks) => marks.map((mark) => mark.getAttribute("aria-label")));
    assert.equal(points.length, 9);
    for (const method of methods) {
      assert.ok(labels.includes(method), `${method} is in the legend`);
      assert.ok(points.some((label) => label.includes(`Method: ${method}`)), `${method} has points`);
    }
  }
  assert.deepEqual(await page.locator("section.scene figure.table tbody").evaluateAll((bodies) => bodies.map((body) => body.rows.length)), [9, 36, 13]);
  await page.close();
});

test("marks of methods have their run's name beside them, and lines join runs of one sweep or one name alone", async () => {
  const { page } = await open();
  const drawn = await page.evaluate(() => {
    const { study, plots, plotting } = gibench, key = 0, first = study.scenes[0].runs.find((index) => study.errors[key].runs[index] && study.runs[index].method !== study.methods[0].name);
    // Three modes of one method, a coarser run of one of them, and a fifth at the first one's place.
    const labels = ["radiosity", "radiosity, coarse", "implicit", "antiradiance", "the same again"];
    const runs = labels.map((label, i) => ({ ...study.runs[first], label, time: { surface: 2 ** (i % 4), image: 2 ** (i % 4) } }));
    const errors = { ...study.errors, [key]: { ...study.errors[key], runs: runs.map((_, i) => ({ ...study.errors[key].runs[first], y: 0.1 * 2 ** -(i % 4), low: undefined, high: undefined })) } };
    const spec = plotting.errorPlot({ ...study, runs, errors }, plots, { ...study.scenes[0], runs: runs.map((_, i) => i) }, key, 600);
    return { series: spec.datasets.runs.map((p) => p.series), names: spec.datasets.names };
  });
  assert.equal(drawn.series[0], drawn.series[1]);
  assert.equal(new Set(drawn.series).size, 4);
  assert.deepEqual(drawn.names.map((name) => name.name), ["radiosity", "radiosity, coarse", "implicit", "antiradiance", "the same again"]);
  const [at, , , , again] = drawn.names;
  assert.ok(at.align !== again.align || at.dy !== again.dy, "two names at one place would lie on one another");
  await page.close();
});

test("every choice of domain, light and metric works", async () => {
  const { page, problems } = await open();
  const keys = await page.evaluate(() => gibench.study.keys);
  for (const [index, key] of keys.entries()) {
    // Every metric of both domains, and every component: not the whole product, which would take minutes.
    if (key.component !== "indirect" && key.metric !== "relative_rmse") continue;
    await page.locator(`#error-choice label:has(input[value=${key.domain}])`).click();
    await page.locator(`#error-choice label:has(input[value=${key.component}])`).click();
    await page.locator("#metric").selectOption(key.metric);
    await page.waitForFunction((wanted) => document.body.dataset.key === wanted, String(index));
    const drawn = page.locator(errorPlots).first().locator(".plot[data-drawn=yes] svg.marks");
    await page.locator(errorPlots).first().scrollIntoViewIfNeeded();
    await drawn.waitFor();
    const title = await page.evaluate((k) => gibench.study.metrics[k].title, key.metric);
    assert.ok((await drawn.locator(".role-axis-title text").allTextContents()).some((text) => text.startsWith(title)), title);
    assert.ok((await page.locator("section.scene figure.table thead").first().textContent()).includes(title));
    await page.evaluate(() => scrollTo(0, 0));
  }
  assert.deepEqual(problems, []);
  await page.close();
});

test("text from scenes and messages stays text", async () => {
  const { page } = await open();
  await readThrough(page);
  assert.equal(await page.evaluate(() => window.escaped), undefined);
  assert.ok((await page.locator("#failures").textContent()).includes("<img src=x onerror="));
  assert.ok((await page.locator("h2").allTextContents()).includes('two <rooms> & a "wall" _100%_ | $x^2$'));
  await page.close();
});

test("failures, effects and the manifest are shown", async () => {
  const { page } = await open();
  const failures = await page.locator("#failures tbody").textContent();
  for (const status of ["refused", "timed out", "crashed", "failed", "skipped"]) assert.ok(failures.includes(status), status);
  assert.ok((await page.locator("#effects").textContent()).includes("missing"));
  assert.ok((await page.locator("section.scene p.missing").first().textContent()).startsWith("meshless lacks glossy_final_bounce"));
  const manifest = await page.locator("#manifest").textContent();
  for (const fact of ["0123456789abcdef0123456789abcdef01234567", "Test processor", "seed"]) assert.ok(manifest.includes(fact), fact);
  await page.close();
});

test("a sweep's series are told apart by their labels, on log axes", async () => {
  const { page } = await open();
  const drawn = await page.evaluate(() => {
    const { study, plots, plotting } = gibench, method = study.runs[0].method;
    // Two series of one method, and a third run of the first that another sweep made.
    const run = (label, functions, laplacian) => ({ ...study.runs[0], label, method, parameters: [["functions", String(functions)], ["laplacian", laplacian]] });
    const runs = [32, 64, 128].flatMap((n) => [run(`areas functions=${n}`, n, "cotan"), run(`plain functions=${n}`, n, "graph")]).concat(run("areas rays=9", 256, "cotan"));
    const made = { ...study, runs }, scene = { ...study.scenes[0], runs: runs.map((_, i) => i) };
    const [sweep] = plotting.sweeps(made, scene, 0), spec = plotting.sweepPlot(made, plots, 0, 600, sweep);
    const colour = spec.encoding.color.scale;
    return { labels: colour.domain, colours: colour.range, title: spec.encoding.x.title, scale: spec.encoding.x.scale.type, ticks: spec.encoding.x.axis.values, counts: colour.domain.map((label) => spec.datasets.runs.filter((p) => p.method === label).length) };
  });
  assert.deepEqual(drawn.labels, ["areas", "plain"]);
  assert.deepEqual(drawn.counts, [4, 3]);
  assert.notEqual(drawn.colours[0], drawn.colours[1]);
  assert.deepEqual(drawn.ticks, [32, 64, 128, 256]);
  assert.equal(drawn.scale, "log");
  await page.close();
});

test("a table of many rows opens with its first hundred, and shows the rest when asked", async () => {
  const { page, problems } = await open();
  await page.evaluate(() => {
    const rows = Array.from({ length: 10000 }, (_, i) => [`run ${i}`, String(i)]);
    document.body.append(gibench.element("div", { id: "many" }, gibench.table({ name: "many", caption: "Many", columns: [{ title: "Run" }, { title: "Number", number: true }], rows })));
  });
  const rows = () => page.locator("#many tbody tr:has(th)").count();
  assert.equal(await rows(), 100);
  await page.locator("#many button").first().click();
  assert.equal(await rows(), 1100);
  await page.locator("#many button").last().click();
  assert.equal(await rows(), 10000);
  assert.equal(await page.locator("#many button").count(), 0);
  assert.deepEqual(problems, []);
  await page.close();
});

test("the buttons below a long table are buttons of the page", async () => {
  const { page } = await open();
  const style = await page.evaluate(() => {
    const parent = document.body.appendChild(document.createElement("div"));
    gibench.inPieces(parent, 1000, () => document.createElement("p"));
    const { cursor, borderTopWidth } = getComputedStyle(parent.querySelector(".pieces .more"));
    return { cursor, borderTopWidth };
  });
  assert.deepEqual(style, { cursor: "pointer", borderTopWidth: "1px" });
  await page.close();
});

test("every two runs are compared, and the better one is named only where it is known", async () => {
  const { page, problems } = await open();
  const pairs = page.locator("section.scene").first().locator("details.pairs");
  await pairs.locator("summary").click();
  const rows = await pairs.locator("tbody tr").evaluateAll((all) => all.map((row) => [...row.cells].map((cell) => cell.textContent)));
  assert.equal(rows.length, 36);
  for (const [run, , other, difference, better] of rows) {
    const [low, high] = difference.match(/\[(.*), (.*)\]/).slice(1).map(Number);
    assert.equal(better, high < 0 ? run : low > 0 ? other : "–", difference);
  }
  assert.ok(rows.some((row) => row[4] !== "–"));
  const standings = await page.locator("section.scene").first().locator("figure.table").first().locator("tbody td").allTextContents();
  assert.equal(standings.filter((text) => text === "best").length, 1);
  assert.equal(await page.locator("section.scene").nth(1).locator("details.pairs").count(), 0, "nothing was compared there");
  assert.deepEqual(problems, []);
  await page.close();
});

test("a missing file of an error is told, and what was shown stays", async () => {
  const broken = path.join(folder, "broken");
  execFileSync("cp", ["-r", report, broken]);
  for (const name of readdirSync(path.join(broken, "data"))) if (/^error-/.test(name)) rmSync(path.join(broken, "data", name));
  const page = await browser.newPage(), thrown = [];
  page.on("pageerror", (error) => thrown.push(error.message));
  await page.goto(pathToFileURL(path.join(broken, "index.html")).href);
  const before = await page.locator("#metric").inputValue();
  await page.locator("#metric").selectOption("rmse");
  await page.locator("#choice-notice").waitFor({ state: "visible" });
  assert.match(await page.locator("#choice-notice").textContent(), /^data\/error-\d+\.js is missing/);
  assert.equal(await page.locator("#metric").inputValue(), before);
  assert.equal(await page.evaluate(() => document.body.dataset.key), "0");
  assert.deepEqual(thrown, []);
  await page.close();
});

test("the note below the plot of stages counts its rows, with the chosen error or without", async () => {
  const { page } = await open();
  const counted = await page.evaluate(() => {
    const { study, plots, plotting } = gibench;
    const runs = Array.from({ length: 70 }, (_, i) => ({ ...study.runs[0], label: `run ${i}` })), scene = { ...study.scenes[0], runs: runs.map((_, i) => i) };
    // No run but the first has an error.
    const made = { ...study, runs, errors: [{ runs: runs.map((_, i) => (i === 0 ? study.errors[0].runs[0] : null)) }] };
    const timed = plotting.timedRuns(made, scene, "surface");
    return { note: plotting.rowsNote(timed), rows: plotting.stagesPlot(made, plots, scene, "surface", 600).datasets.totals.length };
  });
  assert.equal(counted.note, " The first 60 of 70 rows; the table has all.");
  assert.equal(counted.rows, 60);
  await page.close();
});

test("relighting tells after how many frames preparing has paid, in words, a plot and a table", async () => {
  const { page, problems } = await open({ hash: "#relighting" });
  const section = page.locator("#relighting");
  const findings = await section.locator("p.finding").allTextContents();
  assert.equal(findings.length, 2);
  assert.ok(findings[0].includes("has paid for itself after 2 [2, 3] frames"), findings[0]);
  assert.ok(findings[1].includes("after 4 frames at most"), findings[1]);
  await section.scrollIntoViewIfNeeded();
  await section.locator(".plot[data-drawn=yes] svg.marks").waitFor();
  const labels = await section.locator(".role-legend-label text").allTextContents();
  for (const label of ["cornell-box: relit", "cornell-box: relit finely", "relighting", "path tracing", "path tracing, at least"]) assert.ok(labels.includes(label), label);
  assert.equal(await section.locator("figure.table tbody").first().locator("tr").count(), 2);
  assert.deepEqual(problems, []);
  await page.close();
});

test("controls have names, and a narrow window does not scroll sideways", async () => {
  const { page } = await open({ width: 390 });
  await readThrough(page);
  const nameless = await page.evaluate(() => [...document.querySelectorAll("main input, main select, main button, nav input, nav select")]
    .filter((control) => !control.getAttribute("aria-label") && !control.textContent.trim() && !control.labels?.length).map((control) => control.outerHTML));
  assert.deepEqual(nameless, []);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  await page.close();
});

test("plots are there as SVG and PDF of the same specifications", () => {
  const names = readdirSync(path.join(report, "plots")).filter((name) => name.endsWith(".vl.json")).map((name) => name.slice(0, -8));
  assert.ok(names.includes("ranking") && names.includes("scene-1-cornell-box-surface-indirect") && names.includes("relighting"));
  for (const name of names) {
    const svg = readFileSync(path.join(report, "plots", `${name}.svg`), "utf8");
    assert.match(svg, /^<svg [^]*<\/svg>\s*$/);
    if (name.endsWith("surface-indirect")) for (const method of methods) assert.ok(svg.includes(`>${method}<`), `${name}: ${method}`);
    assert.equal(readFileSync(path.join(report, "plots", `${name}.pdf`)).subarray(0, 5).toString(), "%PDF-");
  }
});

test("without the plot libraries the tables remain, and nothing is asked for in vain", async () => {
  const bare = path.join(folder, "bare");
  execFileSync("cp", ["-r", reports, bare]);
  rmSync(path.join(bare, "node_modules"), { recursive: true });
  const out = path.join(folder, "without");
  execFileSync(fixture, [out], { stdio: "ignore", env: { ...process.env, GIBENCH_REPORTS: bare } });
  const page = await browser.newPage();
  const problems = [];
  page.on("console", (message) => problems.push(message.text()));
  page.on("requestfailed", (request) => problems.push(request.url()));
  await page.goto(pathToFileURL(path.join(out, "report", "index.html")).href);
  assert.equal(await page.locator("section.scene").first().locator("figure.table").first().locator("tbody tr").count(), 9);
  assert.deepEqual(problems, []);
  await page.close();
});
