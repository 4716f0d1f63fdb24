// Tables as the data gives them: every text is ready, nothing is computed here.
"use strict";
(function () {
  const { element } = gibench;
  const marks = { simulated: "●", missing: "✕", skipped: "○", done: "✓", "called-for": "●", "not-called-for": "○", "not-allowed": "–" };

  function cell(text, column) {
    const key = text.replaceAll(" ", "-");
    const status = ["simulated", "missing", "skipped", "called-for", "not-called-for", "not-allowed", "done", "refused", "timed-out", "crashed", "failed"].includes(key);
    if (!status) return element("td", { class: column.number ? "number" : null }, text);
    return element("td", { class: column.number ? "number" : null },
      element("span", { class: `mark ${key}` }, element("span", { "aria-hidden": "true" }, (marks[key] ?? "▲") + " "), text));
  }

  // `files` names the table's files in tables/; `style` gives method names their colour and shape.
  function table(data, { files = data.name, caption = data.caption, methodColumn = -1 } = {}) {
    const head = element("tr", {}, data.columns.map((column) => element("th", { scope: "col", class: column.number ? "number" : null }, column.title)));
    const made = (row) => element("tr", {}, row.map((text, at) => {
      if (at === 0) return element("th", { scope: "row" }, text);
      if (at === methodColumn) return element("td", {}, methodMark(text), text);
      return cell(text, data.columns[at]);
    }));
    const body = element("tbody", {});
    gibench.inPieces(body, data.rows.length, (position) => made(data.rows[position]),
      (buttons) => element("tr", {}, element("td", { colspan: data.columns.length }, buttons)));
    const links = files === null ? [] : ["csv", "md", "tex"].flatMap((ending) => [" ", element("a", { href: `tables/${encodeURIComponent(files)}.${ending}` }, ending.toUpperCase())]);
    return element("figure", { class: "table" },
      element("figcaption", {}, caption, links.length ? element("span", { class: "downloads" }, links) : null),
      element("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": caption },
        element("table", {}, element("thead", {}, head), body)));
  }

  const shapes = {
    circle: "M6 1.5a4.5 4.5 0 1 0 .01 0z", square: "M2 2h8v8h-8z", "triangle-up": "M6 1.5 11 10.5H1z", "triangle-down": "M6 10.5 1 1.5h10z",
    diamond: "M6 .5 11 6 6 11.5 1 6z", cross: "M4.3 1h3.4v3.3H11v3.4H7.7V11H4.3V7.7H1V4.3h3.3z", "triangle-right": "M10.5 6l-9 5V1z", "triangle-left": "M1.5 6l9-5v10z",
  };

  // The method's mark as in the plots.
  function methodMark(method) {
    const style = gibench.study.methods.find((entry) => entry.name === method);
    if (!style) return null;
    const name = "http://www.w3.org/2000/svg";
    const svg = document.createElementNS(name, "svg"), path = document.createElementNS(name, "path");
    svg.setAttribute("viewBox", "0 0 12 12");
    svg.setAttribute("class", "method-mark");
    svg.setAttribute("aria-hidden", "true");
    path.setAttribute("d", shapes[style.shape] ?? shapes.circle);
    path.setAttribute("fill", style.colour);
    svg.append(path);
    return svg;
  }

  gibench.table = table;
  gibench.methodMark = methodMark;
})();
