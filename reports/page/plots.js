// From the study to complete Vega-Lite specifications: used by the page and by render.mjs, so that both draw the same.
"use strict";
(function (gibench) {
  const font = "'Liberation Sans', 'DejaVu Sans', Arial, Helvetica, sans-serif";
  const config = (width) => ({
    background: "#ffffff",
    autosize: { type: "fit-x", contains: "padding" },
    font,
    view: { stroke: "#c8c8c8" },
    axis: {
      labelFontSize: 12, titleFontSize: 12.5, titleFontWeight: "bold", titleColor: "#222222", labelColor: "#222222",
      gridColor: "#e6e6e6", domainColor: "#777777", tickColor: "#777777", titlePadding: 8,
    },
    legend: {
      labelFontSize: 12, titleFontSize: 12.5, labelColor: "#222222", titleColor: "#222222", orient: "top", symbolSize: 90,
      symbolStrokeWidth: 1.8, columns: Math.max(1, Math.floor(width / 120)), labelLimit: 220,
    },
  });

  // Replaces every string "$name" of a template by values.name.
  function fill(template, values) {
    if (typeof template === "string" && template.startsWith("$") && template.slice(1) in values) return values[template.slice(1)];
    if (Array.isArray(template)) return template.map((item) => fill(item, values));
    if (template === null || typeof template !== "object") return template;
    return Object.fromEntries(Object.entries(template).map(([name, item]) => [name, fill(item, values)]));
  }

  // The range of positive numbers with a margin; at least a factor of three wide, so that a log axis has ticks.
  function logDomain(numbers, margin) {
    const positive = numbers.filter((n) => n > 0 && isFinite(n));
    if (positive.length === 0) return [0.1, 10];
    let low = Math.min(...positive) / margin, high = Math.max(...positive) * margin;
    while (high / low < 12) { low /= 1.2; high *= 1.2; }
    return [low, high];
  }

  function linearDomain(numbers) {
    const finite = numbers.filter(isFinite);
    if (finite.length === 0) return [0, 1];
    const low = Math.min(...finite), high = Math.max(...finite);
    const margin = 0.08 * (high - low || Math.abs(high) || 1);
    return [low - margin, high + margin];
  }

  // Ticks at 1, 2 and 5 of every decade, at 1 and 3, or at the decades alone: the fewer, the more of them there are.
  function logTicks([low, high]) {
    const decades = Math.log10(high / low), digits = decades <= 2.6 ? [1, 2, 5] : decades <= 4.2 ? [1, 3] : [1], ticks = [];
    const every = Math.max(1, Math.ceil(decades / 8));
    for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); power += 1)
      for (const digit of digits) {
        const tick = +`${digit}e${power}`;
        if (tick >= low && tick <= high && power % every === 0) ticks.push(tick);
      }
    return ticks;
  }

  // Only the methods that have a point: a legend entry without a mark misleads.
  function styles(study, used) {
    const methods = study.methods.filter((method) => used.has(method.name));
    return {
      methods: methods.map((m) => m.name),
      colours: methods.map((m) => m.colour),
      shapes: methods.map((m) => m.shape),
      dashes: methods.map((m) => (m.dash.length ? m.dash : [1, 0])),
    };
  }

  function seconds(value) {
    if (value < 1e-3) return `${+(value * 1e6).toPrecision(3)} µs`;
    return value < 1 ? `${+(value * 1e3).toPrecision(3)} ms` : `${+value.toPrecision(3)} s`;
  }

  // Runs that a line joins: those of one sweep, whose labels end in its values; without such an ending those of a method whose
  // labels are one up to a comma ("meshless" and "meshless, coarse").
  const seriesOf = (run) => `${run.method} ${/ [^ =]+=[^ ]*$/.test(run.label) ? run.label.replace(/=[^ ]*$/, "") : run.label.split(",")[0]}`;

  // Where the name of each point stands: right of its mark, left, above or below, the first place that keeps clear of the marks
  // and of the names before it; none where all are taken. `xOf` and `yOf` give pixels.
  function placeNames(points, xOf, yOf, width, height) {
    const taken = points.map((p) => ({ left: xOf(p) - 6, right: xOf(p) + 6, top: yOf(p) - 6, bottom: yOf(p) + 6 }));
    const isFree = (box) => box.left >= 0 && box.right <= width && box.top >= 0 && box.bottom <= height
      && taken.every((other) => box.right < other.left || box.left > other.right || box.bottom < other.top || box.top > other.bottom);
    return points.filter((p) => p.name).flatMap((p) => {
      const wide = 6 * p.name.length, half = 6.5;
      const places = [{ align: "left", dx: 9, dy: 0, left: 9 }, { align: "right", dx: -9, dy: 0, left: -9 - wide },
        { align: "center", dx: 0, dy: -15, left: -wide / 2 }, { align: "center", dx: 0, dy: 15, left: -wide / 2 },
        { align: "right", dx: 6, dy: -15, left: 6 - wide }, { align: "right", dx: 6, dy: 15, left: 6 - wide }];
      for (const { align, dx, dy, left } of places) {
        const box = { left: xOf(p) + left, right: xOf(p) + left + wide, top: yOf(p) + dy - half, bottom: yOf(p) + dy + half };
        if (!isFree(box)) continue;
        taken.push(box);
        return [{ x: p.x, error: p.error, name: p.name, align, dx, dy }];
      }
      return [];
    });
  }

  // The points of one scene for one error; `left_out` counts runs that a log axis cannot show.
  function errorPoints(study, scene, key) {
    const domain = study.keys[key].domain, metric = study.metrics[study.keys[key].metric];
    const points = [];
    let leftOut = 0;
    for (const index of scene.runs) {
      const run = study.runs[index], error = study.errors[key].runs[index], time = run.time[domain];
      if (!error || time === undefined || run.status !== "done") continue;
      if (time <= 0 || (metric.logarithmic && error.y <= 0)) { leftOut += 1; continue; }
      const smallest = metric.logarithmic ? error.y / 50 : -Infinity;
      points.push({
        index, run: run.label, method: run.method, name: run.method === study.methods[0]?.name ? null : run.label, series: seriesOf(run), x: time, time: seconds(time), error: error.y, text: error.text, unresolved: error.unresolved,
        floor: error.floor ?? null,
        low: error.low === undefined ? null : Math.max(error.low, smallest), high: error.high ?? null,
      });
    }
    return { points, leftOut };
  }

  // The errors of points along x: against time, or against a parameter.
  function curves(study, templates, key, width, points, x) {
    const entry = study.keys[key], metric = study.metrics[entry.metric];
    const values = points.flatMap((p) => [p.error, p.high ?? p.error, Math.max(p.low ?? p.error, metric.logarithmic ? p.error / 3 : -Infinity)]);
    const floors = points.map((p) => p.floor).filter((floor) => floor > 0);
    const floor = floors.length ? Math.max(...floors) : null;
    const xDomain = logDomain(points.map((p) => p.x), x.margin);
    const domain = metric.logarithmic ? logDomain(values, 1.35) : linearDomain(values);
    const height = 320, along = ([low, high], value) => Math.log(value / low) / Math.log(high / low);
    const across = metric.logarithmic ? along : ([low, high], value) => (value - low) / (high - low);
    // The axis and its title take about sixty pixels of the width.
    const drawn = width - 70, named = x.names ? placeNames(points, (p) => drawn * along(xDomain, p.x), (p) => height * (1 - across(domain, p.error)), drawn, height) : [];
    return fill(templates["error-curve"], {
      width, height, config: config(width), runs: points, names: named, ...(x.styles ?? styles(study, new Set(points.map((p) => p.method)))), legend: x.legend ?? "Method",
      floor: floor !== null && floor > domain[0] ? [{ floor: Math.min(floor, domain[1]), bottom: domain[0], label: "the reference's noise floor" }] : [],
      xTitle: x.title, xDomain, xTicks: x.ticks ?? logTicks(xDomain), xFormat: x.format, errorTicks: metric.logarithmic ? logTicks(domain) : null,
      errorTitle: entry.axis, errorScale: metric.logarithmic ? "log" : "linear", errorDomain: domain,
      tooltip: [{ field: "run", title: "Run" }, { field: "method", title: x.legend ?? "Method" }, { field: "text", title: "Error" }, { field: "time", title: "Time" }],
      errorFormat: metric.percent ? "~%" : "~g",
    });
  }

  function errorPlot(study, templates, scene, key, width) {
    const title = `Time (s): prepare + light + shade${study.keys[key].domain === "image" ? " the image" : " the samples"}`;
    return curves(study, templates, key, width, errorPoints(study, scene, key).points, { title, margin: 1.6, format: "~g", names: true });
  }

  // The parameters that a study sweeps on a scene: [{ name, points }]. A series is what differs in that parameter alone and
  // has three values of it at least; numbers above zero only, as the axis is logarithmic.
  function sweeps(study, scene, key) {
    const { points } = errorPoints(study, scene, key);
    const names = [...new Set(points.flatMap((p) => study.runs[p.index].parameters.map(([name]) => name)))];
    return names.flatMap((name) => {
      const series = new Map();
      for (const point of points) {
        const parameters = study.runs[point.index].parameters, own = parameters.find(([n]) => n === name);
        const value = own ? Number(own[1]) : NaN;
        if (!(value > 0) || !isFinite(value)) continue;
        const rest = JSON.stringify([point.method, parameters.filter(([n]) => n !== name)]);
        series.set(rest, (series.get(rest) ?? new Map()).set(value, { ...point, x: value, series: rest }));
      }
      const swept = [...series.values()].filter((values) => values.size >= 3).flatMap((values) => [...values.values()]);
      return swept.length ? [{ name, points: swept }] : [];
    });
  }

  // The names of the series of a sweep: the study's label of its runs, which ends in the swept value; else the method.
  function seriesLabels(sweep) {
    const labels = new Map();
    for (const point of sweep.points) {
      const ending = ` ${sweep.name}=${point.x}`;
      if (point.run.endsWith(ending)) labels.set(point.series, point.run.slice(0, -ending.length));
      else if (!labels.has(point.series)) labels.set(point.series, point.method);
    }
    return labels;
  }

  // A style for each series: that of its method for the first of a method, further ones from what is left.
  function seriesStyles(study, sweep) {
    const labels = seriesLabels(sweep), spare = { colours: ["#0072B2", "#009E73", "#E69F00", "#56B4E9", "#CC79A7", "#7F7F7F"], shapes: ["square", "diamond", "triangle-down", "cross", "circle", "triangle-right"], dashes: [[6, 3], [2, 2], [8, 3, 2, 3], [1, 3], [10, 4], [4, 2]] };
    const all = { methods: [], colours: [], shapes: [], dashes: [] }, seen = new Set();
    for (const [series, label] of labels) {
      const own = study.methods.find((method) => method.name === sweep.points.find((p) => p.series === series).method);
      const next = all.methods.length, first = !seen.has(own.name);
      seen.add(own.name);
      all.methods.push(label);
      all.colours.push(first ? own.colour : spare.colours.filter((c) => !all.colours.includes(c) && !study.methods.some((m) => seen.has(m.name) && m.colour === c))[0] ?? "#000000");
      all.shapes.push(first ? own.shape : spare.shapes.filter((shape) => !all.shapes.includes(shape))[0] ?? "circle");
      all.dashes.push(first ? [1, 0] : spare.dashes[next % spare.dashes.length]);
    }
    return { labels, styles: all };
  }

  function sweepPlot(study, templates, key, width, sweep) {
    const values = [...new Set(sweep.points.map((p) => p.x))].sort((a, b) => a - b);
    const ticks = values.length <= 10 ? values : undefined;
    const { labels, styles: own } = seriesStyles(study, sweep);
    const points = sweep.points.map((p) => ({ ...p, method: labels.get(p.series) }));
    return curves(study, templates, key, width, points, { title: sweep.name.replaceAll("_", " "), margin: 1.25, ticks, format: "~r", styles: own, legend: "Series" });
  }

  // A plot with a row for each run shows this many rows; the table below it has all.
  const mostRows = 60;
  const firstRows = (names) => new Set([...new Set(names)].slice(0, mostRows));

  // What a caption adds where a plot has not all rows.
  const rowsNote = (names) => {
    const count = new Set(names).size;
    return count > mostRows ? ` The first ${mostRows} of ${count} rows; the table has all.` : "";
  };

  function rankingPlot(study, templates, key, width) {
    const ranked = study.errors[key].ranking.points, rows = firstRows(ranked.map((p) => p.run));
    const points = ranked.filter((p) => rows.has(p.run)).map((p) => ({ ...p, where: p.scene || "geometric mean" }));
    const factorDomain = logDomain(points.map((p) => p.factor).concat([1]), 1.5);
    return fill(templates.ranking, {
      width, height: 24 * new Set(points.map((p) => p.run)).size, config: config(width), points, factorDomain, factorTicks: logTicks(factorDomain), ...styles(study, new Set(points.map((p) => p.method))),
      order: [...new Set(points.map((p) => p.run))],
    });
  }

  // The runs of a scene that have a row in the plot of stages: those whose time is known, with the chosen error or without it.
  const timedRuns = (study, scene, domain) => scene.runs.filter((index) => study.runs[index].status === "done" && study.runs[index].time[domain] > 0);

  function stagesPlot(study, templates, scene, domain, width) {
    const stages = [], totals = [];
    for (const index of timedRuns(study, scene, domain).slice(0, mostRows)) {
      const run = study.runs[index], total = run.time[domain];
      const shade = run.seconds[`shade_${domain}`] ?? run.seconds.shade;
      [["prepare", run.seconds.prepare], ["light", run.seconds.light], ["shade", shade]].forEach(([stage, value], rank) => {
        if (value > 0) stages.push({ run: run.label, stage, rank, share: value / total, time: seconds(value) });
      });
      totals.push({ run: run.label, time: seconds(total) });
    }
    return fill(templates.stages, {
      width, height: 22 * totals.length, config: config(width), stages, totals, order: totals.map((t) => t.run),
    });
  }

  // Both parts of every run's error; runs whose light paths are complete have the one.
  function splitPlot(study, templates, key, width) {
    const entry = study.keys[key], metric = study.metrics[entry.metric];
    const drawn = study.errors[key].split.points
      .filter((p) => !metric.logarithmic || p.y > 0)
      .map((p) => ({ ...p, row: `${p.scene}: ${p.run}`, low: p.low === undefined ? null : Math.max(p.low, metric.logarithmic ? p.y / 50 : -Infinity), high: p.high ?? null }));
    const rows = firstRows(drawn.map((p) => p.row)), points = drawn.filter((p) => rows.has(p.row));
    const values = points.flatMap((p) => [p.y, p.high ?? p.y]);
    // What is all but nothing stands at the left edge, and leaves the rest its room.
    const least = Math.max(...values) / 1e4;
    const domain = metric.logarithmic ? logDomain(values.map((value) => Math.max(value, least)), 1.5) : linearDomain(values);
    const order = [...new Set(points.map((p) => p.row))];
    return fill(templates["error-split"], {
      width, height: 24 * order.length, config: config(width), points, order, domain, scale: metric.logarithmic ? "log" : "linear",
      ticks: metric.logarithmic ? logTicks(domain) : null, format: metric.percent ? "~%" : "~g", title: entry.axis,
    });
  }

  // Seconds after n frames: preparing and n frames, beside n times path tracing to the frame's error, its band between
  // the ends of that time's interval.
  function payOffPlot(study, templates, width) {
    const list = study.relights.list.filter((relight) => relight.path_tracing);
    const paid = list.flatMap((relight) => Object.values(relight.frames_that_pay ?? {})).filter((frames) => frames > 0);
    const last = 10 ** Math.ceil(Math.log10(10 * Math.max(10, ...paid)));
    const counts = Array.from({ length: 61 }, (_, i) => last ** (i / 60));
    const name = (relight) => `${relight.scene}: ${relight.label}`;
    const lines = [], bands = [];
    for (const relight of list) {
      const { value, low, high } = relight.path_tracing;
      for (const frames of counts) {
        lines.push({ relight: name(relight), kind: "relighting", frames, seconds: relight.prepare + frames * relight.frame });
        const traced = value ?? low;
        if (traced) lines.push({ relight: name(relight), kind: value ? "path tracing" : "path tracing, at least", frames, seconds: frames * traced });
        if (low && high) bands.push({ relight: name(relight), frames, low: frames * low, high: frames * high });
      }
    }
    const xDomain = [1, last], yDomain = logDomain(lines.map((p) => p.seconds), 1.3);
    const kinds = ["relighting", "path tracing", "path tracing, at least"].filter((kind) => lines.some((line) => line.kind === kind));
    return fill(templates["pay-off"], {
      width, config: config(width), lines, bands, xDomain, xTicks: logTicks(xDomain), yDomain, yTicks: logTicks(yDomain),
      relights: list.map(name), colours: list.map((_, i) => ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"][i % 7]),
      kinds, dashes: kinds.map((kind) => ({ relighting: [1, 0], "path tracing": [6, 4] })[kind] ?? [2, 3]),
    });
  }

  gibench.plotting = { errorPlot, errorPoints, payOffPlot, rankingPlot, rowsNote, splitPlot, stagesPlot, sweepPlot, sweeps, timedRuns };
})(globalThis.gibench ?? (globalThis.gibench = {}));
