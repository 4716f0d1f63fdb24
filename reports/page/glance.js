// The study at a glance: one sentence, and a row for each configuration on each scene.
"use strict";
(function () {
  const { element, table, sections, study } = gibench;

  function glance(key) {
    const section = document.getElementById("glance");
    const title = element("h2", { id: "glance-title" }, "At a glance");
    if (key === null) {
      section.replaceChildren(title, element("p", {}, "No run measured an error."));
      return;
    }
    const { sentence, table: rows } = study.errors[key].glance;
    section.replaceChildren(title, element("p", { class: "verdict" }, sentence),
      table(rows, { files: key === 0 ? "at-a-glance" : null, methodColumn: 1 }),
      element("p", { class: "note" }, "Ahead or behind: the whole 95% interval of the factor lies above or below 1. A factor with ≥, and a number with ≤, stands for an error that the reference does not resolve; * for path tracing continued beyond its runs. ",
        "Preparing and lighting are paid once, shading for each point or picture of the study’s size: of fewer than the numbers under “pays from”, path tracing is cheaper at the same error. “Never”: path tracing is cheaper for each point or picture too. In brackets what the 95% intervals of the errors leave room for; seconds are taken as exact."));
  }

  sections.glance = glance;
})();
