// Linear pixels: half floats in script files, because a page opened from disk may not fetch.
"use strict";
(function () {
  const waiting = new Map(), stored = new Map();

  // The value of every half float.
  const halves = new Float32Array(65536);
  for (let bits = 0; bits < 65536; bits += 1) {
    const exponent = (bits >> 10) & 31, fraction = bits & 1023, sign = bits & 32768 ? -1 : 1;
    if (exponent === 31) halves[bits] = fraction ? NaN : sign * Infinity;
    else halves[bits] = sign * (exponent === 0 ? fraction * 2 ** -24 : (1 + fraction / 1024) * 2 ** (exponent - 15));
  }

  // Called by the files of data/images.
  gibench.storePixels = function (file, text) {
    const bytes = atob(text), values = new Uint16Array(bytes.length / 2);
    for (let i = 0; i < values.length; i += 1) values[i] = bytes.charCodeAt(2 * i) | (bytes.charCodeAt(2 * i + 1) << 8);
    stored.set(file, values);
  };

  function load(file) {
    if (!waiting.has(file)) {
      waiting.set(file, new Promise((resolve, reject) => {
        const script = document.createElement("script");
        script.src = "data/" + file;
        script.onload = () => { script.remove(); resolve(stored.get(file)); };
        script.onerror = () => reject(new Error(file + " is missing"));
        document.head.append(script);
      }));
    }
    return waiting.get(file);
  }

  // The files that make up `layer` of a picture; empty where it has no such layer.
  function partsOf(picture, layer) {
    const { layers } = picture;
    if (layers[layer]) return [layers[layer]];
    return layer === "total" && layers.direct && layers.indirect ? [layers.direct, layers.indirect] : [];
  }

  // A promise of the layer's values, R, G, B by pixel from the top left; null where there is none.
  async function values(picture, layer) {
    const parts = partsOf(picture, layer);
    if (parts.length === 0) return null;
    const loaded = await Promise.all(parts.map((part) => load(part.file)));
    const sum = new Float32Array(picture.width * picture.height * 3);
    loaded.forEach((bits, k) => {
      const { scale } = parts[k];
      for (let i = 0; i < sum.length; i += 1) sum[i] += halves[bits[i]] * scale;
    });
    return sum;
  }

  // One number per pixel, channels averaged: |x − r|, or |x − r| / (|r| + 0.01), whose mean is mape(0.01).
  function errorMap(x, r, relative) {
    const map = new Float32Array(r.length / 3);
    for (let i = 0, at = 0; i < map.length; i += 1) {
      let sum = 0;
      for (let channel = 0; channel < 3; channel += 1, at += 1) {
        const difference = Math.abs(x[at] - r[at]);
        sum += relative ? difference / (Math.abs(r[at]) + 0.01) : difference;
      }
      map[i] = sum / 3;
    }
    return map;
  }

  // The reference's own noise in the same unit: `noise` is ½|A − B| of its halves.
  function noiseMap(noise, r, relative) {
    const map = new Float32Array(r.length / 3);
    for (let i = 0, at = 0; i < map.length; i += 1)
      for (let channel = 0; channel < 3; channel += 1, at += 1)
        map[i] += (relative ? noise[at] / (Math.abs(r[at]) + 0.01) : noise[at]) / 3;
    return map;
  }

  const mean = (list) => list.reduce((sum, value) => sum + value, 0) / list.length;

  gibench.pixels = { values, errorMap, noiseMap, mean, has: (picture, layer) => partsOf(picture, layer).length > 0 };
})();
