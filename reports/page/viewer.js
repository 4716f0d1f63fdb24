// Two pictures of a scene under one slider, with exposure and error maps.
"use strict";
(function () {
  const { element, select, segments, oncePerFrame, pixels, colour } = gibench;

  const referenceOf = (scene) => scene.pictures.find((picture) => picture.run === null);
  const nameOf = (study, picture) => (picture.run === null ? "Reference" : study.runs[picture.run].label);
  const kinds = [["picture", "Picture"], ["relative", "Relative error"], ["absolute", "Absolute error"]];

  // What is shown of a scene; the gallery shows the same of every picture.
  function initialState(study, scene) {
    const baseline = study.methods[0]?.name;
    const others = scene.pictures.filter((picture) => picture.run !== null && study.runs[picture.run].method !== baseline);
    const runs = scene.pictures.filter((picture) => picture.run !== null);
    const right = others[others.length - 1] ?? runs[0] ?? scene.pictures[0];
    const left = referenceOf(scene) ?? runs.find((picture) => picture !== right) ?? right;
    const layer = ["total", "indirect", "direct"].find((name) => pixels.has(left, name)) ?? "total";
    return { left, right, layer, kind: "picture", stops: scene.exposure, range: 0 };
  }

  // The largest number of the colour bar: 10 % or a tenth of the reference's mean, times powers of two.
  function topOf(state, reference) {
    return (state.kind === "relative" ? 0.1 : Math.max(0.1 * pixels.mean(reference), 1e-6)) * 2 ** state.range;
  }

  // Draws one picture as the state asks. Resolves to a note where it cannot be drawn so, or to null.
  async function draw(canvas, scene, picture, state) {
    const { width, height } = picture;
    const values = await pixels.values(picture, state.layer);
    if (!values) return `has no ${state.layer} layer`;
    if (state.kind === "picture") {
      colour.drawPicture(canvas, width, height, values, state.stops);
      return null;
    }
    return drawError(canvas, scene, picture, state, values, (truth) => topOf(state, truth));
  }

  // The map of errors, from 0 to topOf(the reference's values).
  async function drawError(canvas, scene, picture, state, values, topOf) {
    const { width, height } = picture, reference = referenceOf(scene);
    const truth = reference && (await pixels.values(reference, state.layer));
    if (!truth || truth.length !== values.length) return "has no reference to differ from";
    const relative = state.kind === "relative", top = topOf(truth);
    if (picture !== reference) {
      const map = pixels.errorMap(values, truth, relative);
      colour.drawMap(canvas, width, height, map, top);
      return `mean ${show(pixels.mean(map), relative)}`;
    }
    const noise = state.layer === "total" ? await pixels.values(reference, "noise") : null;
    const map = noise ? pixels.noiseMap(noise, truth, relative) : new Float32Array(width * height);
    colour.drawMap(canvas, width, height, map, top);
    return noise ? `own noise ½|A − B|, mean ${show(pixels.mean(map), relative)}` : "no halves kept of this layer: own noise unknown";
  }

  // The relative error of the layer that the state shows, from 0 to `top`. Resolves to a note.
  async function drawRelative(canvas, scene, picture, { layer }, top) {
    const values = await pixels.values(picture, layer);
    return values ? drawError(canvas, scene, picture, { layer, kind: "relative" }, values, () => top) : `has no ${layer} layer`;
  }

  const show = (value, percent) => (percent ? `${+(value * 100).toPrecision(3)} %` : `${+value.toPrecision(3)}`);

  // The picture chosen for one side, with its corner label.
  function side(name) {
    const canvas = element("canvas", { class: name, width: 1, height: 1 });
    const label = element("span", { class: `corner ${name}` });
    return { name, canvas, label };
  }

  function pictureOptions(study, scene) {
    const option = (picture) => [String(scene.pictures.indexOf(picture)), nameOf(study, picture)];
    const reference = referenceOf(scene);
    const groups = study.methods.map((method) => ({
      group: method.name,
      options: scene.pictures.filter((p) => p.run !== null && study.runs[p.run].method === method.name).map(option),
    })).filter((entry) => entry.options.length);
    return (reference ? [option(reference)] : []).concat(groups);
  }

  // Moves the border between the pictures by the range input, by dragging on the picture, and by its arrow keys.
  function wipe(stage, range) {
    const place = () => stage.style.setProperty("--wipe", `${range.value / 10}%`);
    const follow = (event) => {
      const box = stage.getBoundingClientRect();
      range.value = String(Math.round(((event.clientX - box.left) / box.width) * 1000));
      place();
    };
    range.addEventListener("input", place);
    stage.addEventListener("pointerdown", (event) => { stage.setPointerCapture(event.pointerId); follow(event); });
    stage.addEventListener("pointermove", (event) => { if (event.buttons & 1) follow(event); });
    place();
  }

  // Values of the pixel under the pointer.
  function readout(stage, line, scene, study, state) {
    const text = (rgb) => rgb.map((v) => +v.toPrecision(3)).join(", ");
    stage.addEventListener("pointermove", async (event) => {
      const { left, right, layer } = state, box = stage.getBoundingClientRect();
      const x = Math.floor(((event.clientX - box.left) / box.width) * left.width), y = Math.floor(((event.clientY - box.top) / box.height) * left.height);
      if (x < 0 || y < 0 || x >= left.width || y >= left.height) return;
      const parts = await Promise.all([left, right].map(async (picture) => {
        const values = await pixels.values(picture, layer), at = (y * picture.width + x) * 3;
        return values && at + 2 < values.length ? `${nameOf(study, picture)}: ${text([values[at], values[at + 1], values[at + 2]])}` : "";
      }));
      line.textContent = `Pixel ${x}, ${y} · ${parts.filter(Boolean).join(" · ")} W/(m² sr)`;
    });
  }

  // Widget and state of one scene; `onchange` is called after every change.
  function makeViewer(study, scene, onchange) {
    const state = initialState(study, scene), id = scene.slug, reference = referenceOf(scene);
    const left = side("left"), right = side("right");
    const stage = element("div", { class: "stage", style: `aspect-ratio:${state.left.width}/${state.left.height}` }, right.canvas, left.canvas, element("div", { class: "divider", "aria-hidden": "true" }), left.label, right.label);
    const range = element("input", { type: "range", class: "wipe", min: 0, max: 1000, step: 5, value: 500, "aria-label": "Border between the left and the right picture" });
    const line = element("p", { class: "readout" }, "Point at the picture to read its values.");
    const legend = element("div", { class: "legend" });
    const exposure = element("input", { type: "range", id: `${id}-exposure`, class: "exposure", min: -12, max: 12, step: 0.25, value: state.stops, oninput: () => { state.stops = +exposure.value; redraw(); } });
    const exposureText = element("output", { for: `${id}-exposure` });
    const scale = element("input", { type: "range", id: `${id}-range`, class: "error-range", min: -6, max: 6, step: 0.5, value: 0, oninput: () => { state.range = +scale.value; redraw(); } });
    const scaleText = element("output", { for: `${id}-range` });

    const redraw = oncePerFrame(async () => {
      const notes = await Promise.all([left, right].map(({ name, canvas }) => draw(canvas, scene, state[name], state)));
      [left, right].forEach(({ name, label }, k) => { label.textContent = nameOf(study, state[name]) + (notes[k] ? ` (${notes[k]})` : ""); });
      left.canvas.setAttribute("aria-label", left.label.textContent);
      right.canvas.setAttribute("aria-label", right.label.textContent);
      exposureText.textContent = `${state.stops >= 0 ? "+" : "−"}${Math.abs(state.stops).toFixed(2)} stops`;
      const asPicture = state.kind === "picture";
      exposure.closest(".field").hidden = !asPicture;
      scale.closest(".field").hidden = asPicture;
      const truth = reference && !asPicture ? await pixels.values(reference, state.layer) : null;
      legend.replaceChildren(...(truth ? [colour.colourBar(topOf(state, truth), state.kind === "relative"), element("p", {}, explain(state.kind))] : []));
      if (truth) scaleText.textContent = `0 – ${show(topOf(state, truth), state.kind === "relative")}`;
      stage.dataset.drawn = String(+(stage.dataset.drawn ?? 0) + 1);
      onchange(state);
    });

    const choose = (name) => select(name === "left" ? "Left" : "Right", `${id}-${name}`, pictureOptions(study, scene), scene.pictures.indexOf(state[name]),
      (value) => { state[name] = scene.pictures[+value]; redraw(); });
    const layers = ["total", "direct", "indirect"].filter((layer) => scene.pictures.some((picture) => pixels.has(picture, layer)));
    const controls = element("div", { class: "controls" },
      choose("left"), choose("right"),
      segments("Light", `${id}-layer`, layers.map((layer) => [layer, layer]), state.layer, (value) => { state.layer = value; redraw(); }),
      segments("Show", `${id}-kind`, reference ? kinds : kinds.slice(0, 1), state.kind, (value) => { state.kind = value; redraw(); }),
      element("label", { class: "field wide", for: `${id}-exposure` }, element("span", {}, "Exposure ", exposureText), exposure),
      element("label", { class: "field wide", for: `${id}-range` }, element("span", {}, "Error range ", scaleText), scale));
    wipe(stage, range);
    readout(stage, line, scene, study, state);
    left.canvas.setAttribute("role", "img");
    right.canvas.setAttribute("role", "img");
    return { root: element("div", { class: "viewer" }, element("div", { class: "compare" }, stage, range, line, legend), controls), state, redraw, choose };
  }

  function explain(kind) {
    return kind === "relative" ? "|x − r| / (|r| + 0.01), channels averaged; the mean over the picture is mape(0.01). The reference shows its own noise."
      : "|x − r| in W/(m² sr), channels averaged. The reference shows its own noise.";
  }

  gibench.viewer = { make: makeViewer, draw, drawRelative, nameOf };
})();
