// From numbers to colours: exposed sRGB for pictures, a colour map for errors.
"use strict";
(function () {
  const steps = 8192, srgb = new Uint8ClampedArray(steps + 1);
  for (let i = 0; i <= steps; i += 1) {
    const v = i / steps;
    srgb[i] = Math.round(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055));
  }

  // Magma: from black to light yellow, growing evenly in lightness, so that it reads in grey and for any colour vision.
  const anchors = ["000004", "180f3d", "440f76", "721f81", "9e2f7f", "cd4071", "f1605d", "fd9668", "feca8d", "fcfdbf"]
    .map((hex) => [0, 2, 4].map((at) => parseInt(hex.slice(at, at + 2), 16)));
  const magma = new Uint8Array(256 * 3);
  for (let i = 0; i < 256; i += 1) {
    const place = (i / 255) * (anchors.length - 1), low = Math.min(Math.floor(place), anchors.length - 2);
    for (let c = 0; c < 3; c += 1) magma[3 * i + c] = Math.round(anchors[low][c] + (place - low) * (anchors[low + 1][c] - anchors[low][c]));
  }

  // Pixels that are not a number are shown in a green that no map here has.
  const broken = [0, 255, 64];

  function drawPicture(canvas, width, height, values, stops) {
    const image = new ImageData(width, height), { data } = image, gain = 2 ** stops * steps;
    for (let i = 0, from = 0, to = 0; i < width * height; i += 1, to += 4) {
      let whole = true;
      for (let c = 0; c < 3; c += 1, from += 1) {
        const level = values[from] * gain;
        whole = whole && level === level;
        data[to + c] = srgb[level >= steps ? steps : level > 0 ? (level + 0.5) | 0 : 0];
      }
      if (!whole) data.set(broken, to);
      data[to + 3] = 255;
    }
    put(canvas, image);
  }

  function drawMap(canvas, width, height, map, top) {
    const image = new ImageData(width, height), { data } = image;
    for (let i = 0, to = 0; i < map.length; i += 1, to += 4) {
      const level = (map[i] / top) * 255;
      if (level !== level) data.set(broken, to);
      else data.set(magma.subarray(3 * Math.min(255, level | 0), 3 * Math.min(255, level | 0) + 3), to);
      data[to + 3] = 255;
    }
    put(canvas, image);
  }

  function put(canvas, image) {
    if (canvas.width !== image.width || canvas.height !== image.height) {
      canvas.width = image.width;
      canvas.height = image.height;
    }
    canvas.getContext("2d").putImageData(image, 0, 0);
  }

  // The colour bar of errors from 0 to `top`, with its numbers as text.
  function colourBar(top, relative) {
    const stops = Array.from({ length: 17 }, (_, k) => {
      const at = Math.round((k / 16) * 255) * 3;
      return `rgb(${magma[at]},${magma[at + 1]},${magma[at + 2]}) ${(k / 16) * 100}%`;
    });
    const text = (value) => (relative ? `${+(value * 100).toPrecision(3)} %` : `${+value.toPrecision(3)}`);
    const ticks = [0, 0.25, 0.5, 0.75, 1].map((share) =>
      gibench.element("span", { style: `left:${share * 100}%` }, (share === 1 ? "≥ " : "") + text(share * top)));
    return gibench.element("div", { class: "colour-bar", role: "img", "aria-label": `Colour bar from 0 to ${text(top)}` },
      gibench.element("div", { class: "ramp", style: `background:linear-gradient(to right,${stops.join(",")})` }),
      gibench.element("div", { class: "ticks" }, ticks));
  }

  gibench.colour = { drawPicture, drawMap, colourBar };
})();
