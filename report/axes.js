// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// What the plots of all pages have in common: colours that follow the scheme, axes with short numbers.
"use strict";
document.documentElement.classList.add("has-script");
const pageAxes = (function () {
  const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

  // A power of 1000 that keeps the numbers at an axis short; it stands in the axis' name.
  function exponentOf(values) {
    let largest = 0;
    for (const value of values) if (value != null) largest = Math.max(largest, Math.abs(value));
    if (largest === 0 || (largest >= 0.01 && largest < 1e5)) return 0;
    return 3 * Math.floor(Math.log10(largest) / 3);
  }
  const superscript = (exponent) => String(exponent).replace(/[-0-9]/g, (c) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]);
  const axisName = (unit, exponent) => (exponent ? "10" + superscript(exponent) + " " : "") + unit;

  // Six digits; "" for what is missing.
  function numberText(value) {
    if (value == null) return "";
    const rounded = Number(value.toPrecision(6)), size = Math.abs(rounded);
    return size !== 0 && (size < 1e-3 || size >= 1e6) ? rounded.toExponential() : String(rounded);
  }

  // `texts`: of an array of places along the axis.
  function axis(label, isHorizontal, texts) {
    const font = "13px system-ui, 'Segoe UI', Roboto, sans-serif";
    return {
      label, font, labelFont: font, labelSize: 22,
      stroke: () => colour("--soft"),
      grid: { stroke: () => colour("--grid"), width: 1 },
      ticks: { stroke: () => colour("--line"), width: 1 },
      values: (plot, splits) => texts(splits),
      size: isHorizontal ? 40 : (plot, values) => 22 + 7.5 * Math.max(3, ...(values || []).map((value) => value.length)),
    };
  }
  // The numbers at an axis have six digits; ticks closer than doubles can tell apart never reach the axis' end in uPlot.
  const drawnAsOne = (low, high) => high - low <= 1e-6 * Math.max(Math.abs(low), Math.abs(high));
  const numbersIn = (exponent) => (splits) =>
    splits.map((value) => (value == null ? "" : String(Number((value / 10 ** exponent).toPrecision(6)))));

  // Draws anew where the window or the scheme changes.
  function follow(plots, height) {
    let due = 0;
    window.addEventListener("resize", () => {
      cancelAnimationFrame(due);
      due = requestAnimationFrame(() => {
        for (const plot of plots()) plot.setSize({ width: widthOf(plot.root.parentNode), height });
      });
    });
    window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
      for (const plot of plots()) plot.redraw();
    });
  }
  const widthOf = (place) => Math.max(200, Math.floor(place.clientWidth));
  return { colour, exponentOf, superscript, axisName, axis, drawnAsOne, numbersIn, numberText, follow, widthOf };
})();
