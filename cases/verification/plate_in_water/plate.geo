// A plate along x, periodic, with liquid and a wall on both of its sides. All lengths in metres.

DefineConstant[
  length    = {20e-3, Name "length"},
  thickness = {1e-3, Name "thickness"},
  height    = {10e-3, Name "height"}
];

If (length <= 0 || thickness <= 0 || height <= 0)
  Error("length, thickness and height must be positive");
  Abort;
EndIf

SetFactory("OpenCASCADE");
Rectangle(1) = {0, -thickness/2, 0, length, thickness};
Rectangle(2) = {0, thickness/2, 0, length, height};
Rectangle(3) = {0, -thickness/2 - height, 0, length, height};
Coherence;

Physical Surface("plate") = {1};
Physical Surface("liquid") = {2, 3};
e = 1e-3 * thickness;
y = thickness/2 + height;
lid() = Curve In BoundingBox {-e, y - e, -e, length + e, y + e, e};
floor() = Curve In BoundingBox {-e, -y - e, -e, length + e, -y + e, e};
Physical Curve("wall") = {lid(), floor()};
