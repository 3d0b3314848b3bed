// The ring between two coaxial cylinders. All lengths in metres.

DefineConstant[
  inner_radius = {5e-4, Name "inner_radius"},
  outer_radius = {1e-3, Name "outer_radius"}
];

If (inner_radius <= 0 || outer_radius <= inner_radius)
  Error("inner_radius must be positive and below outer_radius");
  Abort;
EndIf

SetFactory("OpenCASCADE");
Circle(1) = {0, 0, 0, inner_radius};
Circle(2) = {0, 0, 0, outer_radius};
Curve Loop(1) = {1};
Curve Loop(2) = {2};
Plane Surface(1) = {2, 1};

Physical Surface("water") = {1};
Physical Curve("inner_cylinder") = {1};
Physical Curve("outer_cylinder") = {2};
