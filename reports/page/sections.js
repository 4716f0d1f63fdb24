// The sections of the page; each is drawn again when another error is chosen.
"use strict";
(function () {
  const { element, definitions, table, plotting, whenNear, viewer } = gibench;
  const { study } = gibench;

  // A plot with its caption, its files and, below, the table that it is drawn from.
  function plot(makeSpec, caption, files, note) {
    const target = element("div", { class: "plot" });
    const links = files.filter((file) => gibench.plotFiles?.includes(file)).flatMap((file) => [" ", element("a", { href: `plots/${encodeURIComponent(file)}` }, file.split(".").pop().toUpperCase())]);
    const figure = element("figure", { class: "plot-figure" }, element("figcaption", {}, caption, links.length ? element("span", { class: "downloads" }, links) : null), target, note ? element("p", { class: "note" }, note) : null);
    const show = async () => {
      if (!globalThis.vegaEmbed) {
        target.replaceChildren(element("p", { class: "note" }, "Plots need the packages of reports/package.json, which were not installed when this report was made. The table holds the same numbers."));
        return;
      }
      const width = Math.max(240, Math.min(900, target.clientWidth - 44));
      await globalThis.vegaEmbed(target, makeSpec(width), { renderer: "svg", actions: { export: true, source: false, compiled: false, editor: false } });
      target.dataset.drawn = "yes";
    };
    whenNear(figure, show);
    return figure;
  }

  const legend = "Hollow marks are not resolved: their interval reaches down to no error, and the mark is at its upper end. Bars are 95% intervals; the grey band is the reference's noise floor.";

  function across(key) {
    const section = document.getElementById("across");
    const title = element("h2", { id: "across-title" }, "Across the scenes");
    if (key === null) {
      section.replaceChildren(title, element("p", {}, "No run measured an error."));
      return;
    }
    const ranking = study.errors[key].ranking, entry = study.keys[key];
    const isDefault = key === 0;
    section.replaceChildren(title,
      element("p", { class: "lead" }, "How many times faster than the path tracer does each configuration reach its error? The path tracer's time for that error is taken from its own curve on the same scene, ",
        "a straight line in log-log between its runs. Beyond them it is extended with the slope of Monte Carlo (marked *). An error that is not resolved counts as the upper end of its interval, which makes the factor a lower bound (≥). ",
        "Configurations with results on more scenes come first; among equals the geometric mean decides."),
      ranking.points.length
        ? plot((width) => plotting.rankingPlot(study, gibench.plots, key, width), `Speed-up at equal ${study.metrics[entry.metric].title} of ${entry.of}: one small mark for each scene (hollow: * or ≥), a bar for the geometric mean.${plotting.rowsNote(ranking.points.map((p) => p.run))}`, isDefault ? ["ranking.svg", "ranking.pdf"] : [])
        : element("p", { class: "note" }, "There is no speed-up to show, because the path tracer has no curve for this error."),
      table(ranking.table, { files: isDefault ? "ranking" : null, methodColumn: 1 }));
  }

  function plotsOf(scene, key) {
    const entry = study.keys[key], first = study.keys.findIndex((k) => k.domain === entry.domain && k.component === entry.component);
    const stem = `${scene.slug}-${entry.domain}-${entry.component}`, stages = `${scene.slug}-stages-${entry.domain}`;
    const { points, leftOut } = plotting.errorPoints(study, scene, key);
    const note = legend + (leftOut ? ` ${leftOut} runs without a positive error or time are not drawn.` : "");
    if (points.length === 0) return [element("p", { class: "note" }, `No run has this error (${study.metrics[entry.metric].title} of ${entry.of}) on this scene.`)];
    return [
      plot((width) => plotting.errorPlot(study, gibench.plots, scene, key, width), `${study.metrics[entry.metric].title} of ${entry.of} against time.`, key === first ? [`${stem}.svg`, `${stem}.pdf`] : [], note),
      ...plotting.sweeps(study, scene, key).map((sweep) => plot((width) => plotting.sweepPlot(study, gibench.plots, key, width, sweep), `${study.metrics[entry.metric].title} of ${entry.of} against ${sweep.name}.`, key === first ? [`${stem}-${sweep.name}.svg`, `${stem}-${sweep.name}.pdf`] : [])),
      plot((width) => plotting.stagesPlot(study, gibench.plots, scene, entry.domain, width), `Where the time goes.${plotting.rowsNote(plotting.timedRuns(study, scene, entry.domain))}`, [`${stages}.svg`, `${stages}.pdf`]),
    ];
  }

  function runDetails(scene) {
    const details = (run) => {
      const facts = [["status", run.status_text + (run.exit_code === null ? "" : ` (exit status ${run.exit_code})`)], ["message", run.message], ["parameters", run.parameters.map((pair) => pair.join(" = ")).join(", ")],
        ["seed", run.seed === null ? "" : String(run.seed)], ["threads", run.threads === null ? "" : String(run.threads)], ["machine", run.machine], ["wall clock", run.wall ?? ""], ["termination", run.termination],
        ["counters", run.counters.map((pair) => pair.join(" ")).join(", ")], ["warnings", run.warnings.join("; ")], ...run.details].filter(([, value]) => value !== "");
      return element("details", {}, element("summary", {}, gibench.methodMark(run.method), run.label), element("dl", { class: "facts" }, definitions(facts)));
    };
    const list = element("div", {});
    gibench.inPieces(list, scene.runs.length, (position) => details(study.runs[scene.runs[position]]));
    return element("details", { class: "block" }, element("summary", {}, "Parameters, counters and warnings of every run"), list);
  }

  // The parts of a scene that stay when another error is chosen.
  function sceneFrame(scene) {
    const section = element("section", { id: scene.slug, class: "scene", "aria-labelledby": `${scene.slug}-title` });
    section.append(element("h2", { id: `${scene.slug}-title` }, scene.name));
    if (scene.skipped !== null) {
      section.append(element("p", { class: "notice" }, `Left out of the study: ${scene.skipped}`));
      return { section, measured: null };
    }
    const measured = element("div", { class: "measured" }), tableHolder = element("div", {});
    const pictured = element("div", { class: "pictured" });
    for (const [method, effects] of scene.missing)
      section.append(element("p", { class: "missing" }, gibench.methodMark(method), `${method} lacks ${effects.join(", ")}: the scene calls for it, the method cannot do it.`));
    section.append(element("div", { class: "side-by-side" }, pictured, measured));
    if (scene.pictures.length) {
      const gallery = gibench.makeGallery(study, scene, (picture) => {
        const choice = section.querySelector(`#${CSS.escape(scene.slug)}-right`);
        choice.value = String(scene.pictures.indexOf(picture));
        choice.dispatchEvent(new Event("change"));
      });
      const compare = viewer.make(study, scene, (state) => gallery.show(state));
      pictured.append(compare.root);
      section.append(element("h3", {}, "Every picture"), gallery.root);
      whenNear(section, compare.redraw);
    } else {
      pictured.append(element("p", { class: "note" }, "No pictures of this scene were written."));
    }
    section.append(tableHolder, runDetails(scene),
      element("details", { class: "block" }, element("summary", {}, "Scene and reference"), element("dl", { class: "facts" }, definitions(scene.facts.concat(scene.reference.map(([name, value]) => [`reference ${name}`, value]))))));
    return { section, measured, tableHolder };
  }

  function sceneResults(scene, index, frame, key) {
    if (!frame.measured) return;
    frame.measured.replaceChildren(...(key === null ? [element("p", { class: "note" }, "No run of the study measured an error.")] : plotsOf(scene, key)));
    const isDefault = key === null || key === 0;
    const { tables, pairs } = study.errors[key ?? 0];
    frame.tableHolder.replaceChildren(table(tables[index], { files: isDefault ? scene.slug : null, methodColumn: 1 }),
      ...(pairs[index].rows.length ? [element("details", { class: "block pairs" }, element("summary", {}, "Every two runs: which is the better one"), table(pairs[index], { files: isDefault ? `${scene.slug}-pairs` : null, methodColumn: 1 }))] : []));
  }

  function fixedSections() {
    document.getElementById("failures").append(element("h2", { id: "failures-title" }, "Runs without a result"),
      study.failures.rows.length ? table(study.failures) : element("p", {}, "Every run of the study has a result."));
    document.getElementById("definitions").append(element("h2", { id: "definitions-title" }, "Definitions"),
      element("p", { class: "lead" }, "x is the method's value, r the reference's; all on linear values, channels averaged. The squared error is estimated as the mean of (x − A)(x − B) over the two halves of the reference, so that its noise does not count against a method; ",
        "the noise floor is ¼ of the mean (A − B)². Intervals are 95% over the replicates of the reference and the points, and over the method's seeds where a run tried several. Time is prepare + light + shade; reading the scene is the same for all and left out. ",
        "The Monte Carlo slope is −½ for errors and −1 for squared errors; other metrics are not continued beyond the path tracer's runs. A run is on the front when no other run of the scene is both faster and more accurate; errors that are not resolved are compared by the upper end of their interval."),
      element("dl", { class: "facts" }, definitions(Object.values(study.metrics).map((metric) => [metric.name, metric.meaning]))));
    document.getElementById("manifest").append(element("h2", { id: "manifest-title" }, "Manifest"),
      element("dl", { class: "facts" }, definitions([["study", study.name], ["created", study.created], ["version", study.version], ["commit", study.commit], ...study.settings, ...study.machine.map(([name, value]) => [`machine ${name}`, value])])),
      element("p", {}, "Parameters and seed of every run: below its scene, and in ", element("a", { href: "tables/runs.csv" }, "tables/runs.csv"), "."));
    if (study.warnings.length)
      document.getElementById("warnings").append(element("div", { class: "notice", role: "note" }, element("p", {}, "While this report was made:"), element("ul", {}, study.warnings.map((text) => element("li", {}, text)))));
  }

  gibench.sections = { across, plot, sceneFrame, sceneResults, fixedSections };
})();
