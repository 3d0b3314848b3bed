// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Draws the measures over time with uPlot: one plot each, with a common pointer and a common range of time.
(function () {
  "use strict";
  document.documentElement.classList.add("has-script");
  const measures = JSON.parse(document.getElementById("plot-data").textContent).measures;
  const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  // At the pointer; index: of the point there, null without a pointer.
  const number = (plot, value, series, index) =>
    index == null ? "–" : value == null ? "no value" : String(Number(value.toPrecision(7)));

  // A power of 1000 that keeps the numbers at an axis short; it stands in the axis' name.
  function exponentOf(values) {
    let largest = 0;
    for (const value of values) if (value != null) largest = Math.max(largest, Math.abs(value));
    if (largest === 0 || (largest >= 0.01 && largest < 1e5)) return 0;
    return 3 * Math.floor(Math.log10(largest) / 3);
  }
  const superscript = (exponent) => String(exponent).replace(/[-0-9]/g, (c) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]);
  const axisName = (unit, exponent) => (exponent ? "10" + superscript(exponent) + " " : "") + unit;

  function axis(label, exponent, isTime) {
    const font = "13px system-ui, 'Segoe UI', Roboto, sans-serif";
    const own = {
      label, font, labelFont: font, labelSize: 22,
      stroke: () => colour("--soft"),
      grid: { stroke: () => colour("--grid"), width: 1 },
      ticks: { stroke: () => colour("--line"), width: 1 },
      values: (plot, splits) => splits.map((value) => (value == null ? "" : String(Number((value / 10 ** exponent).toPrecision(6))))),
    };
    if (isTime) own.size = 40;
    else own.size = (plot, values) => 22 + 7.5 * Math.max(3, ...(values || []).map((value) => value.length));
    return own;
  }

  const plots = [];
  const widthOf = (place) => Math.max(200, Math.floor(place.clientWidth));
  for (const place of document.querySelectorAll(".plot")) {
    const measure = measures[Number(place.dataset.measure)];
    const options = {
      width: widthOf(place), height: 230,
      scales: { x: { time: false } },
      cursor: { sync: { key: "time" }, drag: { x: true, y: false } },
      series: [
        { label: "time [s]", value: number },
        {
          label: "value [" + (measure.unit || "1") + "]", width: 1.5, spanGaps: false,
          stroke: () => colour("--curve"), value: number,
        },
      ],
      axes: [
        axis("time [" + axisName("s", exponentOf(measure.time)) + "]", exponentOf(measure.time), true),
        axis("[" + axisName(measure.unit || "1", exponentOf(measure.value)) + "]", exponentOf(measure.value), false),
      ],
    };
    const plot = new uPlot(options, [measure.time, measure.value], place);
    plots.push(plot);
    place.addEventListener("keydown", (event) => onKey(event, plot));
  }

  function setRange(from, to) { for (const plot of plots) plot.setScale("x", { min: from, max: to }); }
  function showAll() {
    for (const plot of plots) plot.setScale("x", { min: plot.data[0][0], max: plot.data[0][plot.data[0].length - 1] });
  }
  function movePointer(plot, by) {
    const time = plot.data[0];
    let at = plot.cursor.idx == null ? (by > 0 ? -1 : time.length) : plot.cursor.idx;
    at = Math.min(Math.max(at + by, 0), time.length - 1);
    plot.setCursor({ left: plot.valToPos(time[at], "x"), top: plot.over.clientHeight / 2 }, true, true);  // in all plots
  }
  function onKey(event, plot) {
    const { min, max } = plot.scales.x;
    const time = plot.data[0];
    const middle = plot.cursor.idx == null ? (min + max) / 2 : time[plot.cursor.idx];
    const zoom = (factor) =>
      setRange(Math.max(middle + (min - middle) * factor, time[0]), Math.min(middle + (max - middle) * factor, time[time.length - 1]));
    const actions = {
      ArrowLeft: () => movePointer(plot, -1), ArrowRight: () => movePointer(plot, 1),
      "+": () => zoom(0.5), "-": () => zoom(2), "0": showAll,
    };
    if (event.ctrlKey || event.altKey || event.metaKey || !(event.key in actions)) return;
    event.preventDefault();
    actions[event.key]();
  }
  document.getElementById("show-all").addEventListener("click", showAll);

  let due = 0;
  window.addEventListener("resize", () => {
    cancelAnimationFrame(due);
    due = requestAnimationFrame(() => {
      for (const plot of plots) plot.setSize({ width: widthOf(plot.root.parentNode), height: 230 });
    });
  });
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    for (const plot of plots) plot.redraw();
  });
})();
