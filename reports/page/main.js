// The page as a whole: its head, the choice of the error, its sections.
"use strict";
(function () {
  const { element, select, segments, definitions, sections, study } = gibench;

  const plural = (count, word) => `${count} ${word}${count === 1 ? "" : "s"}`;

  function head() {
    const counts = new Map();
    for (const run of study.runs) counts.set(run.status_text, (counts.get(run.status_text) ?? 0) + 1);
    const answered = study.scenes.filter((scene) => scene.skipped === null).length;
    document.getElementById("summary").textContent =
      `${plural(study.runs.length, "run")} of ${plural(study.methods.length, "method")} on ${plural(answered, "scene")}` +
      `${answered < study.scenes.length ? ` (${study.scenes.length - answered} left out)` : ""}: ` +
      [...counts].map(([status, count]) => `${count} ${status}`).join(", ") + ".";
    const machine = new Map(study.machine);
    const facts = [
      ["Machine", [machine.get("cpu"), machine.get("cores") && `${machine.get("cores")} cores`].filter(Boolean).join(", ")],
      ["Commit", study.commit.slice(0, 12)], ["Version", study.version], ["Made", study.created]].filter(([, value]) => value);
    document.getElementById("key-facts").append(...facts.map((fact) => element("div", {}, definitions([fact]))));
  }

  // The error that every plot and table shows: a position in study.keys, or null when nothing was measured.
  let chosen = study.keys.length ? 0 : null;
  let shown = chosen;
  const frames = [];

  function show() {
    sections.glance(chosen);
    sections.across(chosen);
    sections.split(chosen);
    study.scenes.forEach((scene, index) => sections.sceneResults(scene, index, frames[index], chosen));
    document.body.dataset.key = String(chosen);
    shown = chosen;
  }

  // The position of the asked-for error, or of the nearest that was measured.
  function keyOf(domain, component, metric) {
    const position = (test) => study.keys.findIndex(test);
    const tests = [
      (k) => k.domain === domain && k.component === component && k.metric === metric,
      (k) => k.domain === domain && k.component === component,
      (k) => k.domain === domain,
    ];
    return tests.map(position).find((index) => index >= 0) ?? 0;
  }

  // What the page shows of an error is a file of its own; a script element reads it from disk too, where fetch may not.
  function loadErrors(key) {
    if (study.errors[key]) return Promise.resolve();
    return new Promise((resolve, reject) => {
      const file = `data/error-${key}.js`, check = () => (study.errors[key] ? resolve() : reject(new Error(`${file} is damaged`)));
      document.head.append(element("script", { src: file, onload: check, onerror: () => reject(new Error(`${file} is missing`)) }));
    });
  }

  // Says on the page what could not be shown; an empty text takes it away.
  function tell(text) {
    const notice = document.getElementById("choice-notice");
    notice.hidden = text === "";
    notice.textContent = text;
  }

  function drawChoice() {
    const target = document.getElementById("error-choice");
    if (chosen === null) return;
    const key = study.keys[chosen];
    const unique = (list) => [...new Set(list)];
    const domains = unique(study.keys.map((k) => k.domain));
    const components = unique(study.keys.filter((k) => k.domain === key.domain).map((k) => k.component));
    const metrics = study.keys.filter((k) => k.domain === key.domain && k.component === key.component).map((k) => k.metric);
    const choose = async (domain, component, metric) => {
      chosen = keyOf(domain, component, metric);
      drawChoice();
      const wanted = chosen;
      try {
        await loadErrors(wanted);
      } catch (error) {
        if (wanted !== chosen) return;
        chosen = shown;
        drawChoice();
        tell(`${error.message}, so that this error cannot be shown; make the report again.`);
        return;
      }
      if (wanted !== chosen) return;
      tell("");
      show();
    };
    const focused = document.activeElement?.id;
    target.replaceChildren(
      segments("Error at", "domain", domains.map((d) => [d, d]), key.domain, (value) => choose(value, key.component, key.metric)),
      segments("Light", "component", components.map((c) => [c, c]), key.component, (value) => choose(key.domain, value, key.metric)),
      select("Metric", "metric", metrics.map((m) => [m, study.metrics[m].title]), key.metric, (value) => choose(key.domain, key.component, value)));
    if (focused) document.getElementById(focused)?.focus();
  }

  function contents() {
    const links = [["glance", "At a glance"], ["across", "Across scenes"], ["split", "Error split"], ...(study.relights.table.rows.length ? [["relighting", "Relighting"]] : []), ...study.scenes.map((scene) => [scene.slug, scene.name]), ["effects", "Effects"], ["failures", "Runs without a result"], ["definitions", "Definitions"], ["manifest", "Manifest"]];
    document.getElementById("contents").append(...links.map(([id, text]) => element("li", {}, element("a", { href: `#${id}` }, text))));
  }

  head();
  contents();
  for (const scene of study.scenes) {
    const frame = sections.sceneFrame(scene);
    frames.push(frame);
    document.getElementById("scenes").append(frame.section);
  }
  drawChoice();
  show();
  sections.relighting();
  sections.effects();
  sections.fixedSections();
})();
