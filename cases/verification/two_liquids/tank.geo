// A closed tank with two liquids, one above the other. All lengths in metres.

DefineConstant[
  width  = {0.4, Name "width"},
  height = {0.5, Name "height"}
];

If (width <= 0 || height <= 0)
  Error("width and height must be positive");
  Abort;
EndIf

SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, width, height};
Rectangle(2) = {0, height, 0, width, height};
Coherence;

Physical Surface("heavy") = {1};
Physical Surface("light") = {2};
e() = Boundary{ Surface{1, 2}; };
Physical Curve("wall") = {e()};
