// A disc in the middle of a tube, both seen along their axis. All lengths in metres.

DefineConstant[
  inner_radius = {5e-3, Name "inner_radius"},
  outer_radius = {15e-3, Name "outer_radius"}
];

If (inner_radius <= 0 || outer_radius <= inner_radius)
  Error("inner_radius must be positive and below outer_radius");
  Abort;
EndIf

SetFactory("OpenCASCADE");
Circle(1) = {0, 0, 0, outer_radius};
Circle(2) = {0, 0, 0, inner_radius};
Curve Loop(1) = {1};
Curve Loop(2) = {2};
Plane Surface(1) = {1, 2};
Plane Surface(2) = {2};

Physical Surface("air") = {1};
Physical Surface("rod") = {2};
Physical Curve("tube") = {1};
