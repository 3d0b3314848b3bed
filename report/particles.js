// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Shows the particles of a run's frames with three.js.
(function () {
  const { colour, exponentOf, axisName, numberText } = pageAxes;
  const place = document.getElementById("particle-view");
  const data = JSON.parse(document.getElementById("particle-data").textContent);

  function element(name, properties, ...children) {
    const made = document.createElement(name);
    Object.assign(made, properties);
    made.append(...children);
    return made;
  }
  const canvas = element("canvas", { tabIndex: 0 });
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", "Particles" + (data.flat ? "" : " in space") + " at the time of the slider below");
  const context = canvas.getContext("webgl2", { antialias: true, alpha: false, powerPreference: "low-power" });
  if (!context) {
    place.append(element("p", { textContent: "This browser offers no WebGL 2, which the moving particles need: another " +
      "browser or another machine shows them. The pictures show some of the frames." }));
    return;
  }

  const sides = data.high.map((high, axis) => high - data.low[axis]);
  const longest = Math.max(...sides, 1e-300);
  const extent = sides.map((side) => side / longest);
  const across = extent.indexOf(Math.min(...extent));
  const has = (name) => data.groups.some((group) => group.name === name);
  const table = (text) => {
    const bytes = new Uint8Array(4 * 256).fill(255), colours = atob(text);
    for (let k = 0; k < 256; ++k)
      for (let c = 0; c < 3; ++c) bytes[4 * k + c] = k < 255 ? colours.charCodeAt(3 * k + c) : data.nan[c];
    const made = new THREE.DataTexture(bytes, 256, 1);
    made.needsUpdate = true;
    return made;
  };
  const about = {
    flat: data.flat, extent, longest, tables: { sequential: table(data.sequential), diverging: table(data.diverging) },
    cut: new THREE.Vector4(0, 0, 0, 1), noCut: new THREE.Vector4(0, 0, 0, 1),
  };
  const largest = Math.max(...data.groups.map((group) => Math.max(group.radius, group.largest))) / longest;
  const layers = data.groups.map((group, k) => particleLayer(group, about, 2 * k * largest));
  const chosen = data.groups.map((group) => ({ shown: true, field: group.name === "solid" || group.fields.length === 0 ? -1 : 0 }));
  const scene = new THREE.Scene();
  for (const layer of layers) scene.add(layer.object);
  const outline = boxOutline();
  if (!data.flat) scene.add(outline);

  const renderer = new THREE.WebGLRenderer({ canvas, context, antialias: true });
  let frame = 0, due = 0;
  const view = particleCamera(canvas, extent, data.flat, across, requestDrawing);
  const lengthBar = element("div", { className: "length-bar" }, element("span"));
  const compass = data.flat ? "" : axesMark();

  function boxOutline() {
    const corners = [];
    for (let axis = 0; axis < 3; ++axis)
      for (let k = 0; k < 4; ++k)
        for (const end of [-0.5, 0.5]) {
          const at = [0, 0, 0];
          at[axis] = end * extent[axis];
          at[(axis + 1) % 3] = (k & 1 ? 0.5 : -0.5) * extent[(axis + 1) % 3];
          at[(axis + 2) % 3] = (k & 2 ? 0.5 : -0.5) * extent[(axis + 2) % 3];
          corners.push(...at);
        }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(corners), 3));
    return new THREE.LineSegments(geometry, new THREE.RawShaderMaterial({
      glslVersion: THREE.GLSL3, uniforms: { plain: { value: new THREE.Vector3(0.5, 0.5, 0.5) } },
      vertexShader: particleShaders.lineVertex, fragmentShader: particleShaders.lineFragment,
    }));
  }
  function axesMark() {
    const made = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    made.setAttribute("class", "compass");
    made.setAttribute("viewBox", "-40 -40 80 80");
    made.setAttribute("aria-hidden", "true");
    for (const name of "xyz") {
      const line = document.createElementNS(made.namespaceURI, "line");
      const text = document.createElementNS(made.namespaceURI, "text");
      text.textContent = name;
      made.append(line, text);
    }
    return made;
  }
  function turnAxesMark() {
    const parts = compass.children;
    for (let axis = 0; axis < 3; ++axis) {
      const seen = new THREE.Vector3(axis === 0 ? 1 : 0, axis === 1 ? 1 : 0, axis === 2 ? 1 : 0)
        .transformDirection(view.camera.matrixWorldInverse);
      parts[2 * axis].setAttribute("x2", 24 * seen.x);
      parts[2 * axis].setAttribute("y2", -24 * seen.y);
      parts[2 * axis + 1].setAttribute("x", 32 * seen.x);
      parts[2 * axis + 1].setAttribute("y", -32 * seen.y);
    }
  }
  // The longest of 1, 2, 5 times a power of ten that a fifth of the width holds.
  function setLengthBar(width, height) {
    const pixels = view.pixelsOfUnit(height) / longest;
    const most = 0.2 * width / pixels;
    const power = 10 ** Math.floor(Math.log10(most));
    const length = power * [5, 2, 1].find((digit) => digit * power <= most * (1 + 1e-9));
    const unit = [["m", 1], ["cm", 1e-2], ["mm", 1e-3], ["µm", 1e-6], ["nm", 1e-9]]
      .find(([, size]) => length >= size * (1 - 1e-9)) || ["nm", 1e-9];
    lengthBar.style.width = length * pixels + "px";
    lengthBar.firstChild.textContent = numberText(length / unit[1]) + " " + unit[0];
  }

  function requestDrawing() {
    if (!due) due = requestAnimationFrame(draw);
  }
  function draw() {
    due = 0;
    layers.forEach((layer, k) => {
      layer.object.visible = chosen[k].shown;
      layer.show(frame, chosen[k].field);
    });
    renderer.render(scene, view.camera);
    const { clientWidth: width, clientHeight: height } = canvas;
    setLengthBar(width, height);
    if (compass) turnAxesMark();
  }
  function resize() {
    const width = Math.max(200, Math.floor(stage.clientWidth));
    const shape = data.flat ? extent[1] / extent[0] : 0.7;
    const height = Math.round(Math.min(Math.max(width * shape * 1.05, Math.min(220, width)), 0.65 * window.innerHeight, 640));
    renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    renderer.setSize(width, height, false);
    canvas.style.height = height + "px";
    view.resize(width, height);
    requestDrawing();
  }
  function setScheme() {
    renderer.setClearColor(colour("--panel"));
    requestDrawing();
  }

  // Time.
  const frames = data.time.length;
  const last = data.time[frames - 1];
  const [timeUnit, timeSize] = [["s", 1], ["ms", 1e-3], ["µs", 1e-6], ["ns", 1e-9]].find(([, size]) => last >= size) || ["s", 1];
  const timeText = (index) => Number((data.time[index] / timeSize).toPrecision(5)) + " " + timeUnit;
  const slider = element("input", { type: "range", min: 0, max: frames - 1, step: 1, value: 0 });
  slider.setAttribute("aria-label", "Time");
  const timeShown = element("span", { className: "time-shown" });
  const play = element("button", { type: "button", textContent: "Play" });
  const perSecond = Math.min(Math.max(frames / 8, 4), 25);
  let playing = 0, started = 0;
  function setFrame(index) {
    frame = Math.min(Math.max(index, 0), frames - 1);
    slider.value = frame;
    slider.setAttribute("aria-valuetext", timeText(frame));
    timeShown.textContent = timeText(frame);
    requestDrawing();
  }
  function setPlaying(on) {
    cancelAnimationFrame(playing);
    playing = 0;
    play.textContent = on ? "Pause" : "Play";
    if (!on) return;
    const first = frame === frames - 1 ? 0 : frame;
    started = performance.now();
    const advance = (now) => {
      const index = (first + Math.max(0, Math.floor((now - started) / 1000 * perSecond))) % frames;
      if (index !== frame) setFrame(index);
      playing = requestAnimationFrame(advance);
    };
    playing = requestAnimationFrame(advance);
  }
  play.addEventListener("click", () => setPlaying(!playing));
  slider.addEventListener("input", () => { setPlaying(false); setFrame(Number(slider.value)); });

  // Groups: whether they are shown, and their colours.
  const labels = { fluid: "Fluid", solid: "Solid", walls: "Walls", moving_walls: "Moving walls", spheres: "Spheres" };
  function scale(field) {
    const unit = field.unit === "1" ? "" : field.unit, exponent = exponentOf([field.low, field.high]);
    const text = (value) => String(Number((value / 10 ** exponent).toPrecision(3)));
    const colours = atob(field.diverging ? data.diverging : data.sequential), stops = [];
    for (let k = 0; k < 255; k += 127 / 8)
      stops.push("rgb(" + [0, 1, 2].map((c) => colours.charCodeAt(3 * Math.round(Math.min(k, 254)) + c)).join(",") + ")");
    const bar = element("div", { className: "scale-bar" });
    bar.style.background = "linear-gradient(to right," + stops.join(",") + ")";
    return [bar, element("div", { className: "scale-ends" }, element("span", { textContent: text(field.low) }),
      element("span", { textContent: axisName(unit, exponent) }), element("span", { textContent: text(field.high) }))];
  }
  function controlsOf(group, k) {
    const box = element("input", { type: "checkbox", checked: true });
    box.addEventListener("change", () => { chosen[k].shown = box.checked; requestDrawing(); });
    const mark = element("span", { className: "group-mark" });
    mark.style.background = "rgb(" + layers[k].plain.map((part) => Math.round(255 * part)).join(",") + ")";
    const made = element("div", { className: "group" }, element("label", {}, box, mark, labels[group.name]));
    if (group.fields.length === 0) return made;
    const select = element("select", {}, element("option", { value: -1, textContent: "one colour" }),
      ...group.fields.map((field, index) => element("option", { value: index, textContent: field.name.replace(/_/g, " ") })));
    select.setAttribute("aria-label", labels[group.name] + " coloured by");
    select.value = chosen[k].field;
    const legend = element("div", { className: "scale" });
    const setField = () => {
      chosen[k].field = Number(select.value);
      mark.hidden = chosen[k].field >= 0;
      legend.replaceChildren(...(chosen[k].field < 0 ? [] : scale(group.fields[chosen[k].field])));
      requestDrawing();
    };
    select.addEventListener("change", setField);
    setField();
    made.append(select, legend);
    return made;
  }

  // In 3-D: what lies before a plane is left out, but for solids. Which side that is, the viewer's place says.
  function cutControls() {
    const isFilled = has("fluid");
    const select = element("select", {}, ...["nowhere", "x", "y", "z"].map((name, k) => element("option", { value: k - 1, textContent: name })));
    select.setAttribute("aria-label", "Cut across");
    select.value = isFilled ? across : -1;
    const at = element("input", { type: "range", min: 0, max: 100, step: 1, value: 50 });
    at.setAttribute("aria-label", "Place of the cut");
    let side = 1;
    const set = () => {
      const axis = Number(select.value);
      at.disabled = axis < 0;
      const normal = [0, 0, 0];
      if (axis >= 0) normal[axis] = side;
      about.cut.set(...normal, axis < 0 ? 1 : side * (Number(at.value) / 100 - 0.5) * extent[axis]);
      requestDrawing();
    };
    const turn = () => {
      const axis = Number(select.value);
      if (axis >= 0) side = view.camera.position.getComponent(axis) < 0 ? -1 : 1;
      set();
    };
    select.addEventListener("change", turn);
    at.addEventListener("input", set);
    turn();
    return element("div", { className: "group" }, element("label", { textContent: "Cut across " }, select), at);
  }

  const whole = element("button", { type: "button", textContent: "Whole view" });
  whole.addEventListener("click", view.reset);
  const stage = element("div", { className: "particle-stage" }, canvas, lengthBar, compass);
  const panel = element("div", { className: "particle-panel" });
  place.append(
    element("p", { textContent: (data.flat ? "Drag to move, " : "Drag to turn, with the right button or two fingers to move, ") +
      "wheel (after a click) or pinch to zoom. With the keyboard, in the picture: arrow keys " +
      (data.flat ? "move" : "turn, with Shift move") + ", + and - zoom, 0 shows all, the space bar plays, comma and full stop step." }),
    element("div", { className: "particle-layout" },
      element("div", {}, stage, element("div", { className: "particle-time" }, play, slider, timeShown)), panel));
  view.reset();
  panel.append(...data.groups.map(controlsOf), ...(data.flat ? [] : [cutControls()]), whole);
  if (data.groups.some((group) => group.fields.length > 0))
    panel.append(element("p", { className: "note", textContent: "Colours span the 1st to the 99th percentile of the whole run, down to 0 " +
      "where that is near, even around 0 for both signs; values beyond have the colour of the end." }));

  canvas.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const others = { " ": () => setPlaying(!playing), ",": () => { setPlaying(false); setFrame(frame - 1); },
      ".": () => { setPlaying(false); setFrame(frame + 1); } };
    if (event.key in others) others[event.key]();
    else if (!view.onKey(event.key, event.shiftKey)) return;
    event.preventDefault();
  });
  canvas.addEventListener("pointerdown", () => canvas.focus({ preventScroll: true }));
  new ResizeObserver(resize).observe(stage);
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", setScheme);
  setScheme();
  resize();
  setFrame(frames - 1);
})();
