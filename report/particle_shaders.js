// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// What the graphics unit does: particles as discs or shaded balls, surfaces as glass, lines.
const particleShaders = (function () {
  // A square for each particle, turned to the viewer. `place` is 0 to 1 along each side of the box around all.
  const ballVertex = `
    precision highp float;
    uniform mat4 modelViewMatrix, projectionMatrix;
    uniform vec3 extent, plain;
    uniform vec4 cut;
    uniform float radius, largest, lift;
    uniform bool coloured;
    uniform sampler2D colours;
    in vec3 position, place;
    in float size, value;
    out vec2 corner;
    out vec3 colour;
    out float depth;
    void main() {
      vec3 at = (place - 0.5) * extent;
      float reach = largest > 0.0 ? size * largest : radius;
      corner = position.xy;
      colour = coloured ? texelFetch(colours, ivec2(int(value * 255.0 + 0.5), 0), 0).rgb : plain;
      vec4 seen = modelViewMatrix * vec4(at + vec3(0.0, 0.0, lift), 1.0);
      seen.xy += reach * position.xy;
      gl_Position = dot(cut.xyz, at) > cut.w ? vec4(2.0, 2.0, 2.0, 1.0) : projectionMatrix * seen;
      depth = 0.5 * projectionMatrix[2][2] * reach;
    }`;
  // Depths of a ball, in 2-D too: where discs overlap, the nearest particle is seen.
  const ballFragment = `
    precision highp float;
    uniform bool shaded;
    in vec2 corner;
    in vec3 colour;
    in float depth;
    out vec4 seen;
    void main() {
      float from = length(corner);
      float share = clamp((1.0 - from) / fwidth(from) + 0.5, 0.0, 1.0);
      if (share == 0.0) discard;
      float height = sqrt(max(0.0, 1.0 - from * from));
      float light = shaded ? 0.42 + 0.62 * max(0.0, dot(vec3(corner, height), vec3(-0.38, 0.48, 0.79))) : 1.0;
      gl_FragDepth = gl_FragCoord.z + depth * height;
      seen = vec4(light * colour, share);
    }`;
  const surfaceVertex = `
    precision highp float;
    uniform mat4 modelViewMatrix, projectionMatrix;
    uniform vec3 extent;
    in vec3 place;
    out vec3 at;
    void main() {
      vec4 seen = modelViewMatrix * vec4((place - 0.5) * extent, 1.0);
      at = seen.xyz;
      gl_Position = projectionMatrix * seen;
    }`;
  const surfaceFragment = `
    precision highp float;
    uniform vec3 plain;
    in vec3 at;
    out vec4 seen;
    void main() {
      vec3 normal = normalize(cross(dFdx(at), dFdy(at)));
      seen = vec4((0.5 + 0.5 * abs(normal.z)) * plain, 0.3);
    }`;
  const lineVertex = `
    precision highp float;
    uniform mat4 modelViewMatrix, projectionMatrix;
    in vec3 position;
    void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`;
  const lineFragment = `
    precision highp float;
    uniform vec3 plain;
    out vec4 seen;
    void main() { seen = vec4(plain, 1.0); }`;
  return { ballVertex, ballFragment, surfaceVertex, surfaceFragment, lineVertex, lineFragment };
})();
