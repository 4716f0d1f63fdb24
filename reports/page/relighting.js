// What relighting is worth: after how many frames preparing has paid for itself.
"use strict";
(function () {
  const { element, table, plotting, sections, study } = gibench;

  function relighting() {
    const { list, table: relights, frames } = study.relights;
    if (relights.rows.length === 0) return;
    const section = document.getElementById("relighting");
    section.hidden = false;
    section.append(...[element("h2", { id: "relighting-title" }, "Relighting"),
      element("p", { class: "lead" }, "A method that relights prepares once; a frame with other lights or materials then costs only the stages light and shade. This is compared with the time that the path tracer needs, at the same surface samples, for the same RMSE of the indirect light: ",
        "its squared error is inversely proportional to its number of paths. For an error that is not resolved, only a lower bound of that time is known."),
      ...list.map((relight) => element("p", { class: "finding" }, gibench.methodMark(relight.method), relight.sentence)),
      list.some((relight) => relight.path_tracing) ? sections.plot((width) => plotting.payOffPlot(study, gibench.plots, width), "Total seconds against the number of frames, preparation included. Bands are 95% intervals of path tracing to the same error; where a band has no upper end, only its lower end is drawn.", ["relighting.svg", "relighting.pdf"]) : null,
      table(relights, { files: "relighting", methodColumn: 2 }),
      element("details", { class: "block" }, element("summary", {}, "Every relit frame"), table(frames, { files: "relit-frames", methodColumn: 2 }))].filter((part) => part !== null));
  }

  sections.relighting = relighting;
})();
