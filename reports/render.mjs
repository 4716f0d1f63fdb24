// Draws the plots of a report folder as SVG and PDF: node render.mjs REPORT. Prints one line on stdout for each thing that is missing.
import { spawnSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";
import vm from "node:vm";
import * as vega from "vega";
import * as vegaLite from "vega-lite";

const report = path.resolve(process.argv[2]);
const folder = path.join(report, "plots");
mkdirSync(folder, { recursive: true });

// The report's own copies, so that the files and the page cannot differ.
const context = vm.createContext({ gibench: {} });
for (const file of ["data/study.js", "data/plots.js", "assets/plots.js"])
  vm.runInContext(readFileSync(path.join(report, file), "utf8"), context);
const { study, plots: templates, plotting } = context.gibench;
const loadErrors = (key) => {
  if (!study.errors[key]) vm.runInContext(readFileSync(path.join(report, `data/error-${key}.js`), "utf8"), context);
};

// The first metric of each domain and component.
function plottedKeys() {
  const seen = new Set();
  return study.keys.flatMap((key, index) => {
    const name = `${key.domain}-${key.component}`;
    if (seen.has(name)) return [];
    seen.add(name);
    return [{ index, name, domain: key.domain }];
  });
}

function specifications() {
  const keys = plottedKeys(), width = 620, list = [];
  if (study.relights.list.some((relight) => relight.path_tracing)) list.push(["relighting", plotting.payOffPlot(study, templates, width)]);
  if (keys.length === 0) return list;
  for (const key of keys) loadErrors(key.index);
  if (study.errors[0].ranking.points.length) list.push(["ranking", plotting.rankingPlot(study, templates, 0, width)]);
  if (study.errors[0].split.points.length) list.push(["error-split", plotting.splitPlot(study, templates, 0, width)]);
  for (const scene of study.scenes) {
    for (const key of keys) {
      for (const sweep of plotting.sweeps(study, scene, key.index))
        list.push([`${scene.slug}-${key.name}-${sweep.name}`, plotting.sweepPlot(study, templates, key.index, width, sweep)]);
      if (plotting.errorPoints(study, scene, key.index).points.length)
        list.push([`${scene.slug}-${key.name}`, plotting.errorPlot(study, templates, scene, key.index, width)]);
    }
    for (const domain of new Set(keys.map((key) => key.domain))) {
      const spec = plotting.stagesPlot(study, templates, scene, domain, width);
      if (spec.datasets.totals.length) list.push([`${scene.slug}-stages-${domain}`, spec]);
    }
  }
  return list;
}

async function writeSvg(name, spec) {
  const plain = JSON.parse(JSON.stringify(spec));
  const view = new vega.View(vega.parse(vegaLite.compile(plain).spec), { renderer: "none", logLevel: vega.Error });
  writeFileSync(path.join(folder, `${name}.vl.json`), JSON.stringify(plain, null, 1) + "\n");
  writeFileSync(path.join(folder, `${name}.svg`), await view.toSVG());
  view.finalize();
}

const found = (program) => spawnSync(program, ["--version"], { stdio: "ignore" }).status === 0;

function chromium() {
  const named = process.env.GIBENCH_CHROMIUM;
  return [named, "chromium", "chromium-browser", "google-chrome"].find((program) => program && found(program));
}

function pdfByChromium(program, svg, pdf) {
  const text = readFileSync(svg, "utf8");
  const [, width, height] = text.match(/width="([\d.]+)" height="([\d.]+)"/);
  const page = `${pdf}.html`;
  writeFileSync(page, `<!doctype html><style>@page{size:${width}px ${height}px;margin:0}body{margin:0}svg{display:block}</style>${text}`);
  const flags = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync", "--no-pdf-header-footer"];
  const run = spawnSync(program, [...flags, `--print-to-pdf=${pdf}`, pathToFileURL(page).href], { stdio: "ignore" });
  rmSync(page);
  return run.status === 0 && existsSync(pdf);
}

function writePdfs(names) {
  const converter = found("rsvg-convert") ? "rsvg-convert" : null;
  const browser = converter ? null : chromium();
  if (!converter && !browser) {
    console.log("the plots are left out as PDF: neither rsvg-convert (package librsvg2-bin) nor chromium is installed");
    return;
  }
  const failed = names.filter((name) => {
    const svg = path.join(folder, `${name}.svg`), pdf = path.join(folder, `${name}.pdf`);
    return converter ? spawnSync(converter, ["-f", "pdf", "-o", pdf, svg]).status !== 0 : !pdfByChromium(browser, svg, pdf);
  });
  if (failed.length) console.log(`${failed.length} plots could not be made as PDF, ${failed[0]}.pdf among them`);
}

const list = specifications();
for (const [name, spec] of list) await writeSvg(name, spec);
writePdfs(list.map(([name]) => name));
