export { BufferAttribute, BufferGeometry, DataTexture, DoubleSide, DynamicDrawUsage, GLSL3, InstancedBufferAttribute, InstancedBufferGeometry, LineSegments, Mesh, MOUSE, OrthographicCamera, RawShaderMaterial, Scene, TOUCH, Vector3, Vector4, WebGLRenderer } from "three";
export { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
