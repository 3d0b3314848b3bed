// A straight round pipe along x, periodic: its two ends are unnamed. All lengths in metres.

SetFactory("OpenCASCADE");

DefineConstant[
  radius = {5e-4, Name "radius"},
  length = {4e-4, Name "length"}
];

If (radius <= 0 || length <= 0)
  Error("radius and length must be positive");
  Abort;
EndIf

Cylinder(1) = {0, 0, 0, length, 0, 0, radius};

Physical Volume("water") = {1};
Physical Surface("wall") = {1};
