// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// A group of particles, or a surface, as three.js draws it.
// `about`: shared by all: extent of the box, its longest side in m, flat, tables of colours.
const particleLayer = function (group, about, lift) {
  const bytesOf = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const axes = about.flat ? 2 : 3;
  const decoded = [];
  // Arrays of the group at one time, made once.
  function at(index) {
    if (!decoded[index]) {
      const from = group.at[index];
      decoded[index] = {
        place: new Uint16Array(bytesOf(from.place).buffer),
        size: new Uint16Array(bytesOf(from.radius).buffer),
        values: from.values.map(bytesOf),
      };
    }
    return decoded[index];
  }
  const isSurface = group.triangles !== "";
  const counts = group.at.map((one) => Math.round(one.place.replace(/=+$/, "").length * 3 / 4 - 0.5) / (2 * axes) | 0);
  const most = Math.max(1, ...counts);
  const uniforms = {
    extent: { value: new THREE.Vector3(...about.extent) }, plain: { value: new THREE.Vector3(...plainOf(group.name)) },
    radius: { value: group.radius / about.longest }, largest: { value: group.largest / about.longest },
    lift: { value: about.flat ? lift : 0 }, shaded: { value: !about.flat }, coloured: { value: false },
    colours: { value: about.tables.sequential }, cut: { value: about.cut },
  };
  if (group.name === "solid" || isSurface) uniforms.cut = { value: about.noCut };

  function plainOf(name) {
    const plain = { fluid: [70, 125, 190], walls: [150, 153, 160], moving_walls: [120, 124, 135], spheres: [70, 125, 190], solid: [196, 18, 48] };
    return plain[name].map((part) => part / 255);
  }
  function attribute(Kind, array, size) {
    const made = new Kind(array, size, true);
    made.setUsage(THREE.DynamicDrawUsage);
    return made;
  }

  const Geometry = isSurface ? THREE.BufferGeometry : THREE.InstancedBufferGeometry;
  const Attribute = isSurface ? THREE.BufferAttribute : THREE.InstancedBufferAttribute;
  const geometry = new Geometry();
  const place = attribute(Attribute, new Uint16Array(axes * most), axes);
  const size = attribute(Attribute, new Uint16Array(most), 1);
  const value = attribute(Attribute, new Uint8Array(most), 1);
  geometry.setAttribute("place", place);
  if (isSurface) {
    geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(bytesOf(group.triangles).buffer), 1));
  } else {
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]), 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    geometry.setAttribute("size", size);
    geometry.setAttribute("value", value);
  }
  const object = new THREE.Mesh(geometry, new THREE.RawShaderMaterial({
    glslVersion: THREE.GLSL3, uniforms, side: THREE.DoubleSide,
    vertexShader: isSurface ? particleShaders.surfaceVertex : particleShaders.ballVertex,
    fragmentShader: isSurface ? particleShaders.surfaceFragment : particleShaders.ballFragment,
    transparent: isSurface, depthWrite: !isSurface, alphaToCoverage: !isSurface,
  }));
  object.frustumCulled = false;

  let shownFrame = -1, shownField = -1;
  function put(attribute, array) {
    attribute.array.set(array);
    attribute.needsUpdate = true;
  }
  // `field`: its number, -1: one colour.
  function show(frame, field) {
    const index = group.at.length === 1 ? 0 : frame;
    const from = at(index);
    const isNew = index !== shownFrame;
    if (isNew) {
      put(place, from.place);
      put(size, from.size);
      if (!isSurface) geometry.instanceCount = from.place.length / axes;
      object.userData.count = from.place.length / axes;
    }
    if (field >= 0 && (isNew || field !== shownField)) {
      if (from.values.length > 0) put(value, from.values[field]);
      uniforms.colours.value = group.fields[field].diverging ? about.tables.diverging : about.tables.sequential;
    }
    uniforms.coloured.value = field >= 0;
    shownFrame = index;
    if (field >= 0) shownField = field;
  }
  return { object, show, plain: plainOf(group.name) };
};
