// Every picture of a scene side by side, shown as its viewer shows two of them, and under each its error map.
"use strict";
(function () {
  const { colour, element, oncePerFrame, viewer } = gibench;
  const mapTop = 0.5;  // the largest relative error that the maps tell from larger ones

  // `pick(picture)` is called when one is chosen for the right side of the viewer.
  gibench.makeGallery = function (study, scene, pick) {
    let state = null;
    const hasMaps = scene.pictures.some((picture) => picture.run === null);
    const tiles = scene.pictures.map((picture) => {
      const made = (name) => element("canvas", { class: name, width: 1, height: 1, "aria-hidden": "true", style: `aspect-ratio:${picture.width}/${picture.height}` });
      const canvas = made("shown"), map = hasMaps ? made("map") : null;
      const note = element("span", { class: "tile-note" });
      const method = picture.run === null ? null : study.runs[picture.run].method;
      const button = element("button", { type: "button", class: "tile", onclick: () => pick(picture) },
        canvas, map, element("span", { class: "tile-name" }, method ? gibench.methodMark(method) : null, viewer.nameOf(study, picture)), note);
      return { picture, canvas, map, note, button };
    });
    const legend = element("div", { class: "legend maps" }, hasMaps ? [colour.colourBar(mapTop, true), element("p", {}, "Under each picture its relative error, |x − r| / (|r| + 0.01), of the light that is shown; under the reference its own noise.")] : []);
    const redraw = oncePerFrame(async () => {
      const asPicture = state.kind === "picture";
      legend.hidden = !asPicture;
      for (const { picture, canvas, map, note, button } of tiles) {
        let told = await viewer.draw(canvas, scene, picture, state);
        if (map) map.hidden = !asPicture;
        if (map && asPicture) told = told ?? (await viewer.drawRelative(map, scene, picture, state, mapTop));
        note.textContent = told ?? "";
        button.setAttribute("aria-pressed", String(state.left === picture || state.right === picture));
      }
    });
    return {
      root: element("div", {}, element("div", { class: "gallery", role: "group", "aria-label": "All pictures; choose one for the right side" }, tiles.map((tile) => tile.button)), legend),
      show(next) { state = next; redraw(); },
    };
  };
})();
