// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The plots of a study, drawn with uPlot: results over a key, a line for each value of another one.
function studyPlots(data, figures) {
  const { colour, exponentOf, superscript, axisName, axis, drawnAsOne, numbersIn, follow, widthOf } = pageAxes;
  const height = 320, marks = 12;
  const plain = pageAxes.numberText;
  const withUnit = (text, unit) => (unit && unit !== "1" ? text + " " + unit : text);
  const heading = (of, unit) => of + (unit && unit !== "1" ? " [" + unit + "]" : "");
  const isSeed = (key) => /(^|\.)seed$/.test(key.name);
  const numbersOf = (key) => key.values.map((value) => (value.trim() === "" ? NaN : Number(value)));
  for (const key of data.keys) {
    key.numbers = numbersOf(key);
    key.isNumeric = key.numbers.every(Number.isFinite);
    const distinct = [...new Set(key.values)];
    key.distinct = key.isNumeric ? distinct.sort((a, b) => Number(a) - Number(b)) : distinct;
  }

  // What a plot shows of the runs in `rows`: its points, in groups of one line and one x; keys that vary within a group.
  function prepare(plot, rows) {
    const key = data.keys[plot.key], lines = plot.lines_by < 0 ? null : data.keys[plot.lines_by];
    const groups = new Map(), points = [];
    let without = 0, offAxis = 0;
    for (const row of rows) {
      const y = data.results[plot.result].values[row];
      const x = key.isNumeric ? key.numbers[row] : key.distinct.indexOf(key.values[row]);
      if (y == null) { ++without; continue; }
      if ((plot.log_x && !(x > 0)) || (plot.log_y && !(y > 0))) { ++offAxis; continue; }
      const line = lines ? lines.distinct.indexOf(lines.values[row]) : 0;
      points.push({ x, y, row, line });
      const at = line + " " + key.values[row];
      if (!groups.has(at)) groups.set(at, []);
      groups.get(at).push(points[points.length - 1]);
    }
    const others = data.keys.filter((other) => other !== key && other !== lines && !other.is_formula && other.distinct.length > 1 &&
      [...groups.values()].some((group) => group.some((point) => other.values[point.row] !== other.values[group[0].row])));
    const seeds = others.filter(isSeed), rest = others.filter((other) => !isSeed(other));
    const treatment = !key.isNumeric || rest.length || data.is_scattered ? "points" : seeds.length ? "mean" : "line";
    const means = treatment !== "mean" ? [] : [...groups.values()].map((group) => ({ x: group[0].x, line: group[0].line,
      y: group.reduce((sum, point) => sum + point.y, 0) / group.length, runs: group.length }));
    return { key, lines, points, means, treatment, rest, seeds, without, offAxis };
  }

  function treatmentText(shown) {
    const names = (keys) => keys.map((key) => key.name).join(", ");
    const said = [];
    if (shown.treatment === "mean") said.push("Points: each run. Lines: the mean over " + names(shown.seeds) + ".");
    if (shown.rest.length && !shown.key.isNumeric) said.push("Points: each run; these vary, too: " + names(shown.rest) + ".");
    else if (shown.rest.length) said.push("Points: each run; no lines, as these vary, too: " + names(shown.rest) + "." +
      (data.is_scattered ? "" : " Choose one value of each above to get lines."));
    else if (data.is_scattered) said.push("Points: each run; no lines, as all keys differ from run to run.");
    if (shown.without) said.push(shown.without + (shown.without === 1 ? " run has" : " runs have") + " no value here.");
    if (shown.offAxis) said.push(shown.offAxis + (shown.offAxis === 1 ? " value is" : " values are") + " not above 0 and not shown on the logarithmic axis.");
    return said.join(" ");
  }

  // Places along a logarithmic axis, and which of them get a number.
  function logSplits(low, high) {
    const decades = Math.log10(high / low), found = [];
    for (let exponent = Math.floor(Math.log10(low)); exponent <= Math.log10(high); ++exponent)
      for (let digit = 1; digit < 10; ++digit) {
        const value = Number(digit + "e" + exponent);
        if (value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9)) found.push(value);
      }
    return decades > 4 ? found.filter((value) => digitOf(value) === 1) : found;
  }
  const digitOf = (value) => Number(value.toExponential(0)[0]);
  function logText(splits) {
    const decades = Math.log10(splits[splits.length - 1] / splits[0]);
    const told = decades > 1.7 ? [1] : decades > 0.7 ? [1, 2, 5] : [1, 2, 3, 4, 5, 6, 7, 8, 9];
    return splits.map((value) => {
      if (!told.includes(digitOf(value))) return "";
      const exponent = Number(value.toExponential(0).split("e")[1]);
      if (exponent > -3 && exponent < 5) return plain(value);
      return (digitOf(value) === 1 ? "" : digitOf(value) + "·") + "10" + superscript(exponent);
    });
  }
  // Of the texts below a horizontal axis those that have room beside each other, round numbers first.
  function withRoom(plot, splits, texts) {
    const rounder = [1, 5, 2, 3, 7, 4, 6, 8, 9], shown = [];
    const order = splits.map((_, k) => k).sort((a, b) => rounder.indexOf(digitOf(splits[a])) - rounder.indexOf(digitOf(splits[b])));
    for (const k of order) {
      const at = plot.valToPos(splits[k], "x"), half = 4 * texts[k].length + 3;
      if (shown.some((other) => Math.abs(other.at - at) < other.half + half)) texts[k] = "";
      else if (texts[k] !== "") shown.push({ at, half });
    }
    return texts;
  }
  const padded = (logarithmic, part) => (plot, low, high) => {
    if (low == null) return logarithmic ? [1, 10] : [0, 1];
    if (logarithmic) { const factor = Math.max((high / low) ** part, 1.1); return [low / factor, high * factor]; }
    const more = drawnAsOne(low, high) ? Math.abs(low) * 0.1 || 1 : part * (high - low);
    return [low - more, high + more];
  };
  function axisOf(name, unit, values, logarithmic, isHorizontal, categories) {
    if (categories)
      return { ...axis(name, isHorizontal, (splits) => splits.map((k) => categories[k] ?? "")), splits: () => categories.map((_, k) => k) };
    if (logarithmic) {
      const texts = (plot, splits) => (isHorizontal ? withRoom(plot, splits, logText(splits)) : logText(splits));
      return { ...axis(heading(name, unit), isHorizontal, logText), values: texts,
        splits: (plot, index, low, high) => logSplits(low, high), filter: (plot, splits) => splits };
    }
    const exponent = exponentOf(values);
    return axis(heading(name, exponent || unit ? axisName(unit === "1" ? "" : unit, exponent).trim() : ""), isHorizontal, numbersIn(exponent));
  }
  const lineColour = (line) => () => colour("--line-" + (line % marks));

  // All that is drawn, in one list along x, as uPlot wants it; each series has values where it has points.
  function series(shown, reference) {
    const count = shown.lines ? shown.lines.distinct.length : 1;
    const items = [...shown.points.map((point) => ({ ...point, series: point.line })),
      ...shown.means.map((mean) => ({ ...mean, series: count + mean.line })),
      ...(reference ? reference.x.map((x, k) => ({ x, y: reference.y[k], series: 2 * count, reference: true })) : [])];
    items.sort((a, b) => a.x - b.x || (a.line ?? 0) - (b.line ?? 0) || a.y - b.y);
    const size = shown.points.length > 3000 ? 3 : shown.points.length > 300 ? 5 : 7;
    const dots = (more) => ({ show: true, size, width: 1, ...more });
    const all = [{}];
    for (let line = 0; line < count; ++line)
      all.push({ stroke: lineColour(line), width: 1.5, spanGaps: true, points: dots({ fill: lineColour(line) }),
        ...(shown.treatment === "line" ? {} : { paths: () => null }) });
    for (let line = 0; line < count; ++line)
      all.push({ stroke: lineColour(line), width: 2, spanGaps: true, points: { show: false } });
    all.push({ stroke: () => colour("--text"), paths: () => null, points: dots({ size: 9, width: 2, fill: () => colour("--page") }) });
    const columns = all.map(() => new Array(items.length).fill(null));
    items.forEach((item, k) => { columns[0][k] = item.x; columns[item.series + 1][k] = item.y; });
    return { items, all, columns };
  }

  function legendOf(place, shown, plot) {
    place.replaceChildren();
    const entry = (text, style, kind) => {
      const mark = document.createElement("span"), one = document.createElement("span");
      mark.className = "mark " + kind;
      mark.style.setProperty("--mark", style);
      one.append(mark, text);
      place.append(one);
    };
    if (shown.lines) {
      const title = document.createElement("strong");
      title.textContent = heading(shown.lines.name, shown.lines.unit);
      place.append(title);
      shown.lines.distinct.forEach((value, line) => entry(value, "var(--line-" + (line % marks) + ")", "dot"));
    }
    if (plot.reference) entry("reference: " + plot.reference.file, "var(--text)", "hollow");
  }

  function readoutOf(place, item, shown, plot) {
    place.replaceChildren();
    if (!item) return;
    const result = data.results[plot.result], key = shown.key;
    const x = key.isNumeric ? plain(item.x) : key.distinct[item.x];
    const told = [key.name + " = " + withUnit(x, key.unit), result.name + " = " + withUnit(plain(item.y), result.unit)];
    if (item.reference) told.unshift("reference");
    if (item.runs) told.unshift("mean of " + item.runs + (item.runs === 1 ? " run" : " runs"));
    if (item.runs && shown.lines) told.push(shown.lines.name + " = " + withUnit(shown.lines.distinct[item.line], shown.lines.unit));
    if (item.row != null) {
      for (const other of data.keys)
        if (other !== key && other.distinct.length > 1) told.push(other.name + " = " + withUnit(other.values[item.row], other.unit));
      const name = data.runs[item.row];
      if (data.pages[item.row] === "1") {
        const link = document.createElement("a");
        link.href = "runs/" + encodeURIComponent(name) + "/report.html";
        link.textContent = name;
        place.append(link, ": ");
      } else place.append(name + ": ");
    }
    place.append(told.join(", "));
  }

  function nearest(plot, items, left, top, most) {
    let best = -1, least = most * most;
    items.forEach((item, k) => {
      const away = (plot.valToPos(item.x, "x") - left) ** 2 + (plot.valToPos(item.y, "y") - top) ** 2;
      if (away <= least) { least = away; best = k; }
    });
    return best;
  }

  const drawn = new Map();  // by the plot's place
  function draw(figure, rows) {
    const place = figure.querySelector(".plot"), plot = data.plots[Number(place.dataset.plot)];
    const shown = prepare(plot, rows), { items, all, columns } = series(shown, plot.reference);
    const result = data.results[plot.result], readout = figure.querySelector(".readout");
    legendOf(figure.querySelector(".legend"), shown, plot);
    readoutOf(readout, null);
    figure.querySelector(".treatment").textContent = treatmentText(shown);
    if (drawn.has(place)) drawn.get(place).plot.destroy();
    const categories = shown.key.isNumeric ? null : shown.key.distinct;
    const own = new uPlot({
      width: widthOf(place), height, legend: { show: false },
      cursor: { points: { show: false }, drag: { x: true, y: true, uni: 30 } },
      scales: { x: { time: false, distr: plot.log_x ? 3 : 1, range: categories ? () => [-0.5, categories.length - 0.5] : padded(plot.log_x, 0.04) },
        y: { distr: plot.log_y ? 3 : 1, range: padded(plot.log_y, 0.08) } },
      series: all,
      axes: [axisOf(shown.key.name, shown.key.unit, columns[0], plot.log_x, true, categories),
        axisOf(result.name, result.unit, items.map((item) => item.y), plot.log_y, false, null)],
    }, columns, place);
    const ring = document.createElement("div");
    ring.className = "ring";
    ring.hidden = true;
    own.over.append(ring);
    const state = { plot: own, items, at: -1 };
    drawn.set(place, state);
    state.go = (at) => {
      state.at = at;
      ring.hidden = at < 0;
      if (at < 0) return;
      ring.style.left = own.valToPos(items[at].x, "x") + "px";
      ring.style.top = own.valToPos(items[at].y, "y") + "px";
      readoutOf(readout, items[at], shown, plot);
    };
    state.open = () => {
      const row = state.at < 0 ? null : items[state.at].row;
      if (row != null && data.pages[row] === "1") window.location.href = "runs/" + encodeURIComponent(data.runs[row]) + "/report.html";
    };
    let pressed = null;
    own.over.addEventListener("mousemove", (event) => {
      const at = nearest(own, items, event.offsetX, event.offsetY, 40);
      if (at >= 0) state.go(at);
    });
    own.over.addEventListener("mousedown", (event) => { pressed = [event.clientX, event.clientY]; });
    own.over.addEventListener("click", (event) => {
      if (!pressed || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 3) return;
      const at = nearest(own, items, event.offsetX, event.offsetY, 15);
      if (at < 0) return;
      state.go(at);
      if (event.pointerType !== "touch") state.open();  // a finger shows first; the run's name is a link then
    });
    own.hooks.setScale = [() => { ring.hidden = true; }];
    own.hooks.setSize = [() => { ring.hidden = true; }];
  }
  for (const figure of figures) {
    const place = figure.querySelector(".plot");
    place.addEventListener("keydown", (event) => {
      const state = drawn.get(place), last = state.items.length - 1;
      const whole = () => state.plot.setData(state.plot.data, true);
      const actions = { ArrowLeft: () => state.go(Math.max(state.at - 1, 0)), ArrowRight: () => state.go(Math.min(state.at + 1, last)),
        Home: () => state.go(0), End: () => state.go(last), Enter: () => state.open(), "0": whole };
      if (event.ctrlKey || event.altKey || event.metaKey || !(event.key in actions) || last < 0) return;
      if (event.target !== place) return;
      event.preventDefault();
      actions[event.key]();
    });
  }
  follow(() => [...drawn.values()].map((state) => state.plot), height);
  return { show(rows) { for (const figure of figures) draw(figure, rows); } };
}
