// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Draws the measures over time with uPlot: one plot each, with a common pointer and a common range of time.
(function () {
  const { colour, exponentOf, axisName, axis, drawnAsOne, numbersIn, follow, widthOf } = pageAxes;
  const measures = JSON.parse(document.getElementById("page-data").textContent).measures;
  // At the pointer; index: of the point there, null without a pointer.
  const number = (plot, value, series, index) =>
    index == null ? "–" : value == null ? "no value" : String(Number(value.toPrecision(7)));

  function valueRange(plot, low, high) {
    if (low == null) return [low, high];
    const middle = (low + high) / 2;
    return drawnAsOne(low, high) ? uPlot.rangeNum(middle, middle, 0.1, true) : uPlot.rangeNum(low, high, 0.1, true);
  }

  const plots = [];
  for (const place of document.querySelectorAll(".plot")) {
    const measure = measures[Number(place.dataset.measure)];
    const exponent = exponentOf(measure.value.concat(measure.reference || []));
    const options = {
      width: widthOf(place), height: 230,
      scales: { x: { time: false }, y: { range: valueRange } },
      cursor: { sync: { key: "time" }, drag: { x: true, y: false } },
      series: [
        { label: "time [s]", value: number },
        {
          label: "value [" + (measure.unit || "1") + "]", width: 1.5, spanGaps: false,
          stroke: () => colour("--curve"), value: number,
        },
      ],
      axes: [
        axis("time [" + axisName("s", exponentOf(measure.time)) + "]", true, numbersIn(exponentOf(measure.time))),
        axis("[" + axisName(measure.unit || "1", exponent) + "]", false, numbersIn(exponent)),
      ],
    };
    const drawn = [measure.time, measure.value];
    if (measure.reference) {
      options.series.push({
        label: "reference [" + (measure.unit || "1") + "]", width: 1.5, dash: [6, 4], spanGaps: false,
        stroke: () => colour("--line-1"), value: number,
      });
      drawn.push(measure.reference);
    }
    const plot = new uPlot(options, drawn, place);
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

  follow(() => plots, 230);
})();
