// Elements, made so that text stays text: whatever a scene or a message says, it is never parsed as HTML.
"use strict";
globalThis.gibench = globalThis.gibench ?? {};

// element("p", {class: "note"}, "text", child, …); properties that start with "on" are listeners, null ones are left out.
gibench.element = function (name, properties = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (value === null || value === undefined || value === false) continue;
    if (key.startsWith("on")) made.addEventListener(key.slice(2), value);
    else made.setAttribute(key, value === true ? "" : String(value));
  }
  made.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return made;
};

// A labelled choice among [value, text] pairs, or {group, options} for groups of them.
gibench.select = function (label, id, options, value, onchange) {
  const option = ([key, text]) => gibench.element("option", { value: key }, text);
  const entries = options.map((entry) =>
    Array.isArray(entry) ? option(entry) : gibench.element("optgroup", { label: entry.group }, entry.options.map(option)));
  const choice = gibench.element("select", { id, onchange: () => onchange(choice.value) }, entries);
  choice.value = String(value);
  return gibench.element("label", { class: "field", for: id }, gibench.element("span", {}, label), choice);
};

// Radio buttons side by side; `options` are [value, text] pairs.
gibench.segments = function (label, name, options, value, onchange) {
  const buttons = options.map(([key, text]) => {
    const input = gibench.element("input", { type: "radio", name, value: key, checked: key === value, onchange: () => onchange(key) });
    return gibench.element("label", {}, input, gibench.element("span", {}, text));
  });
  return gibench.element("fieldset", { class: "segments" }, gibench.element("legend", {}, label), gibench.element("div", {}, buttons));
};

gibench.definitions = function (facts) {
  return facts.flatMap(([name, value]) => [gibench.element("dt", {}, name), gibench.element("dd", {}, value === "" ? "–" : value)]);
};

// Appends make(0), make(1), … to `parent`, the first hundred at once and the rest as they are asked for: a table of 10 000 rows
// opens as fast as one of ten. The CSV file has every row.
gibench.inPieces = function (parent, count, make, makeMore = (button) => button) {
  const piece = 100;
  let shown = 0;
  const add = (upTo) => {
    const made = [];
    for (; shown < Math.min(upTo, count); shown += 1) made.push(make(shown));
    parent.append(...made);
  };
  add(piece);
  if (shown >= count) return;
  const more = gibench.element("button", { type: "button", class: "more", onclick: () => { add(shown + 10 * piece); label(); } });
  const all = gibench.element("button", { type: "button", class: "more", onclick: () => { add(count); label(); } }, `Show all ${count}`);
  const holder = makeMore(gibench.element("div", { class: "pieces" }, more, " ", all));
  const label = () => {
    if (shown >= count) holder.remove();
    else {
      more.textContent = `${shown} of ${count} shown: ${Math.min(10 * piece, count - shown)} more`;
      parent.append(holder);
    }
  };
  label();
};

// Calls `work` once per frame at most.
gibench.oncePerFrame = function (work) {
  let waiting = false;
  return () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => { waiting = false; work(); });
  };
};

// Calls `work` once, when the element comes near the window (or the page is printed).
gibench.whenNear = function (target, work) {
  const watch = new IntersectionObserver((entries) => {
    if (!entries.some((entry) => entry.isIntersecting)) return;
    watch.disconnect();
    work();
  }, { rootMargin: "600px 0px" });
  watch.observe(target);
};
