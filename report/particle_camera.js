// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// How particles are looked at: in parallel projection, so that lengths can be compared; turned in 3-D only.
// `extent`: sides of the box around the origin, the longest 1. `across`: the axis that 3-D is first looked along.
const particleCamera = function (canvas, extent, flat, across, changed) {
  const distance = 10;
  const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.01, 2 * distance);
  const up = across === 2 ? 1 : 2;
  camera.up.set(0, up === 1 ? 1 : 0, up === 2 ? 1 : 0);
  const controls = new THREE.OrbitControls(camera, canvas);
  controls.enableRotate = !flat;
  controls.zoomToCursor = true;
  controls.minZoom = 0.05;
  controls.maxZoom = 1e4;
  if (flat) {
    controls.mouseButtons.LEFT = THREE.MOUSE.PAN;
    controls.touches.ONE = THREE.TOUCH.PAN;
  } else {
    controls.touches.TWO = THREE.TOUCH.DOLLY_PAN;
  }
  // The wheel scrolls the page until somebody has clicked into the picture.
  controls.enableZoom = false;
  canvas.addEventListener("focus", () => { controls.enableZoom = true; });
  canvas.addEventListener("blur", () => { controls.enableZoom = false; });
  canvas.addEventListener("touchstart", () => { controls.enableZoom = true; }, { passive: true });

  let isMoved = false;
  controls.addEventListener("start", () => { isMoved = true; });
  controls.addEventListener("change", changed);

  // The zoom at which the whole box is seen.
  function fit() {
    camera.updateMatrixWorld();
    let wide = 0, high = 0;
    const corner = new THREE.Vector3();
    for (let k = 0; k < 8; ++k) {
      corner.set(...extent.map((side, axis) => (k >> axis & 1 ? 0.5 : -0.5) * side)).applyMatrix4(camera.matrixWorldInverse);
      wide = Math.max(wide, Math.abs(corner.x));
      high = Math.max(high, Math.abs(corner.y));
    }
    camera.zoom = 0.95 * Math.min(camera.right / wide, camera.top / high);
    camera.updateProjectionMatrix();
  }
  // To the first view.
  function reset() {
    isMoved = false;
    controls.target.set(0, 0, 0);
    if (flat) {
      camera.up.set(0, 1, 0);
      camera.position.set(0, 0, distance);
    } else {
      const towards = [0, 0, 0];
      const right = 3 - up - across;
      towards[right] = 0.45 * (across === 1 ? 1 : -1);
      towards[up] = 0.5;
      towards[across] = across === 1 ? -1 : 1;
      camera.position.set(...towards).setLength(distance);
    }
    controls.update();
    fit();
    controls.update();
    changed();
  }
  function resize(width, height) {
    camera.right = width / height;
    camera.left = -camera.right;
    camera.updateProjectionMatrix();
    if (!isMoved) fit();
  }
  // What arrow keys and others do; whether the key is one of them.
  function onKey(key, shift) {
    const step = 30, angle = Math.PI / 24;
    const arrows = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    if (key in arrows) {
      const [x, y] = arrows[key];
      if (flat || shift) controls.pan(step * x, step * y);
      else if (x) controls.rotateLeft(-angle * x);
      else controls.rotateUp(-angle * y);
    } else if (key === "+" || key === "-") {
      camera.zoom = Math.min(Math.max(camera.zoom * (key === "+" ? 1.25 : 0.8), controls.minZoom), controls.maxZoom);
      camera.updateProjectionMatrix();
    } else if (key === "0") {
      reset();
      return true;
    } else {
      return false;
    }
    isMoved = true;
    changed();
    return true;
  }
  // Of a length 1 in pixels of a picture so many high.
  const pixelsOfUnit = (height) => height / 2 * camera.zoom;
  return { camera, reset, resize, onKey, pixelsOfUnit };
};
