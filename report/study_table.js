// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The table of a study's runs: sorted by a click on a heading, searched, and drawn only where it is in view, so that it
// stays quick with many thousands of rows.
function studyTable(data, place, controls) {
  const runs = data.runs.length;
  const unitOf = (of) => (of.unit && of.unit !== "1" ? " [" + of.unit + "]" : "");
  const failureOf = (row) => data.failures[row];
  // Each with a text and a value to sort by; null comes last.
  const columns = [{ name: "run", text: (row) => data.runs[row], value: (row) => row }];
  for (const key of data.keys) {
    if (new Set(key.values).size < 2) continue;
    const numbers = key.values.map((value) => (value.trim() === "" ? NaN : Number(value)));
    const numeric = numbers.every((value) => Number.isFinite(value));
    columns.push({ name: key.name + unitOf(key), text: (row) => key.values[row], numeric,
      value: (row) => (numeric ? numbers[row] : key.values[row]) });
  }
  for (const result of data.results)
    columns.push({ name: result.name + unitOf(result), numeric: true, value: (row) => result.values[row],
      text: (row) => (result.values[row] == null && !failureOf(row) ? "none" : pageAxes.numberText(result.values[row])) });
  if (data.errors.length)
    columns.push({ name: "failed because", wide: true, value: (row) => (failureOf(row) ? data.errors[failureOf(row)[1]] : null),
      text: (row) => (failureOf(row) ? "code " + failureOf(row)[0] + ": " + data.errors[failureOf(row)[1]] : "") });

  let sorted = { column: 0, down: false }, search = "", chosen = () => true, rows = [];

  function element(name, attributes, ...children) {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    made.append(...children);
    return made;
  }
  const body = element("tbody", {}), head = element("tr", {}), groups = element("colgroup", {});
  columns.forEach((column, k) => {
    let longest = 0;
    for (let row = 0; row < runs; ++row) longest = Math.max(longest, column.text(row).length);
    const width = Math.min(Math.max(longest + 2, 8, ...column.name.split(/[ .]/).map((word) => word.length + 3)), 60);
    groups.append(element("col", { style: "width:" + width + "ch" }));
    // A long name breaks after its dots.
    const parts = column.name.split(".").flatMap((part, i, all) => (i + 1 < all.length ? [part + ".", element("wbr", {})] : [part]));
    const button = element("button", { type: "button" }, ...parts, element("span", { class: "arrow", "aria-hidden": "true" }));
    button.addEventListener("click", () => {
      sorted = { column: k, down: sorted.column === k && !sorted.down };
      update();
    });
    head.append(element("th", column.numeric ? { scope: "col", class: "number" } : { scope: "col" }, button));
    column.width = width;
  });
  const table = element("table", { style: "width:" + columns.reduce((sum, column) => sum + column.width, 0) + "ch" },
    element("caption", {}, "Runs"), groups, element("thead", {}, head), body);
  const box = element("div", { class: "run-rows", role: "region", tabindex: "0", "aria-label": "Table of the runs" }, table);
  place.append(box);

  const input = element("input", { type: "search", id: "search", placeholder: "any text" });
  const count = element("span", { class: "note", "aria-live": "polite" });
  input.addEventListener("input", () => { search = input.value.toLowerCase(); update(); });
  controls.append(element("label", {}, "Rows with ", input), count);

  function compare(a, b) {
    const column = columns[sorted.column], x = column.value(a), y = column.value(b);
    if (x == null || y == null) return x == null && y == null ? a - b : x == null ? 1 : -1;
    const order = x < y ? -1 : x > y ? 1 : a - b;
    return sorted.down ? -order : order;
  }
  function rowElement(row) {
    const failed = failureOf(row);
    return element("tr", failed ? { class: "failed" } : {}, ...columns.map((column, k) => {
      const text = column.text(row);
      if (k === 0) {
        const name = data.pages[row] === "1" ? element("a", { href: "runs/" + encodeURIComponent(text) + "/report.html" }, text) : text;
        return element("th", { scope: "row" }, name);
      }
      return element("td", column.numeric ? { class: "number" } : column.wide ? { title: text } : {}, text);
    }));
  }
  let height = 30, drawn = "";
  function draw() {
    const first = Math.max(0, Math.floor(box.scrollTop / height) - 10);
    const last = Math.min(rows.length, Math.ceil((box.scrollTop + box.clientHeight) / height) + 10);
    const now = first + " " + last;
    if (drawn === now) return;
    drawn = now;
    const space = (count) => (count > 0 ? [element("tr", { "aria-hidden": "true" }, element("td", { colspan: String(columns.length), style: "height:" + count * height + "px;padding:0;border:0" }))] : []);
    body.replaceChildren(...space(first), ...rows.slice(first, last).map(rowElement), ...space(rows.length - last));
  }
  function update() {
    rows = [];
    for (let row = 0; row < runs; ++row)
      if (chosen(row) && (!search || columns.some((column) => column.text(row).toLowerCase().includes(search)))) rows.push(row);
    rows.sort(compare);
    [...head.children].forEach((heading, k) => {
      const order = k !== sorted.column ? "none" : sorted.down ? "descending" : "ascending";
      heading.setAttribute("aria-sort", order);
      heading.querySelector(".arrow").textContent = { none: "", ascending: " ▲", descending: " ▼" }[order];
    });
    count.textContent = rows.length === runs ? runs + " runs" : rows.length + " of " + runs + " runs";
    drawn = "";
    draw();
    const one = body.querySelector("tr:not([aria-hidden])");
    if (one && Math.abs(one.getBoundingClientRect().height - height) > 0.5) {
      height = one.getBoundingClientRect().height;
      drawn = "";
      draw();
    }
  }
  box.addEventListener("scroll", draw, { passive: true });
  window.addEventListener("resize", draw);
  update();
  return { show(which) { chosen = which; update(); } };
}
