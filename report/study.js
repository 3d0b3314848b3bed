// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The page of a study: which runs the plots and the table show, by the values of the keys that vary.
(function () {
  const mostValues = 60;
  const data = JSON.parse(document.getElementById("page-data").textContent);
  const all = data.runs.map((_, row) => row);
  const plots = studyPlots(data, [...document.querySelectorAll("#plots figure")]);
  const table = studyTable(data, document.getElementById("run-table"), document.getElementById("table-controls"));
  const wanted = new Map();  // key -> its value
  const has = (row) => [...wanted].every(([key, value]) => key.values[row] === value);
  const place = document.getElementById("choices");
  const varied = data.keys.filter((key) => !key.is_formula && key.distinct.length > 1 && key.distinct.length <= mostValues);
  // With one key there is nothing to choose; of samples that differ in everything, nothing would be left.
  if (place && varied.length > 1 && !data.is_scattered) {
    place.append("Show only ");
    for (const key of varied) {
      const label = document.createElement("label"), select = document.createElement("select");
      select.add(new Option("all", ""));
      key.distinct.forEach((value, k) => select.add(new Option(key.unit ? value + " " + key.unit : value, String(k))));
      select.addEventListener("change", () => {
        if (select.value === "") wanted.delete(key);
        else wanted.set(key, key.distinct[Number(select.value)]);
        show();
      });
      label.append(key.name + " ", select);
      place.append(label);
    }
  }
  function show() {
    plots.show(wanted.size ? all.filter(has) : all);
    table.show(has);
  }
  show();
})();
