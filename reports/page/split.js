// The effects that scenes call for, those that methods simulate, and the error that the missing ones cause.
"use strict";
(function () {
  const { element, table, plotting, sections, study } = gibench;

  function split(key) {
    const section = document.getElementById("split");
    const title = element("h2", { id: "split-title" }, "Where the error comes from");
    if (key === null || study.errors[key].split.table.rows.length === 0) {
      section.replaceChildren(title, element("p", {}, "No run has its error split into model error and discretisation error."));
      return;
    }
    const { points, bounces, table: parts } = study.errors[key].split, entry = study.keys[key];
    const isDefault = key === 0;
    section.replaceChildren(...[title,
      element("p", { class: "lead" }, "A method that cannot simulate a kind of light path has an error that no refinement removes: its model error (◆), the difference between the reference of its own paths and that of all paths. ",
        "The rest is its discretisation error (●), the difference between the method and the reference of its own paths. On a scene of which it simulates every path, a method has no model error. Hollow marks are not resolved."),
      points.length ? sections.plot((width) => plotting.splitPlot(study, gibench.plots, key, width), `Model and discretisation part of the ${study.metrics[entry.metric].title} of ${entry.of}. Bars are 95% intervals.${plotting.rowsNote(points.map((p) => `${p.scene}: ${p.run}`))}`, isDefault ? ["error-split.svg", "error-split.pdf"] : []) : null,
      table(parts, { files: isDefault ? "error-split" : null, methodColumn: 2 }),
      ...(bounces.rows.length ? [element("h3", {}, "Each bounce order separately"), table(bounces, { files: isDefault ? "error-per-bounce" : null })] : [])].filter((part) => part !== null));
  }

  function effects() {
    document.getElementById("effects").append(element("h2", { id: "effects-title" }, "Effects"),
      ...(study.calls.rows.length ? [table(study.calls)] : []),
      element("details", { class: "block" }, element("summary", {}, "Why each scene calls for an effect or not"), table(study.evidence)),
      element("p", { class: "lead" }, "● simulated: the scene calls for it and the method computes it. ✕ missing: the scene calls for it, the method cannot do it, and its picture lacks it. – not allowed: called for, and left out by the user. ○ skipped: the scene does not call for it, so no time was spent on it. The last column is what the light paths that are not simulated cost."),
      table(study.effect_matrix, { methodColumn: 1 }),
      element("details", { class: "block" }, element("summary", {}, "Why each effect was skipped or is missing"), table(study.effects, { methodColumn: 1 })));
  }

  sections.split = split;
  sections.effects = effects;
})();
