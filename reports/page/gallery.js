// Every picture of a scene side by side, shown as its viewer shows two of them.
"use strict";
(function () {
  const { element, oncePerFrame, viewer } = gibench;

  // `pick(picture)` is called when one is chosen for the right side of the viewer.
  gibench.makeGallery = function (study, scene, pick) {
    let state = null;
    const tiles = scene.pictures.map((picture) => {
      const canvas = element("canvas", { width: 1, height: 1, "aria-hidden": "true", style: `aspect-ratio:${picture.width}/${picture.height}` });
      const note = element("span", { class: "tile-note" });
      const method = picture.run === null ? null : study.runs[picture.run].method;
      const button = element("button", { type: "button", class: "tile", onclick: () => pick(picture) },
        canvas, element("span", { class: "tile-name" }, method ? gibench.methodMark(method) : null, viewer.nameOf(study, picture)), note);
      return { picture, canvas, note, button };
    });
    const redraw = oncePerFrame(async () => {
      for (const { picture, canvas, note, button } of tiles) {
        note.textContent = (await viewer.draw(canvas, scene, picture, state)) ?? "";
        button.setAttribute("aria-pressed", String(state.left === picture || state.right === picture));
      }
    });
    return {
      root: element("div", { class: "gallery", role: "group", "aria-label": "All pictures; choose one for the right side" }, tiles.map((tile) => tile.button)),
      show(next) { state = next; redraw(); },
    };
  };
})();
