// Two layers, one above the other, between a floor and a lid; periodic in x. All lengths in metres.

DefineConstant[
  lower  = {0.06, Name "lower"},
  upper  = {0.06, Name "upper"},
  length = {0.008, Name "length"}
];

If (lower <= 0 || upper <= 0 || length <= 0)
  Error("lower, upper and length must be positive");
  Abort;
EndIf

For row In {0:1}
  Point(1 + 2 * row) = {0, row * lower, 0};
  Point(2 + 2 * row) = {length, row * lower, 0};
EndFor
Point(5) = {0, lower + upper, 0};
Point(6) = {length, lower + upper, 0};

Line(1) = {1, 2};
Line(2) = {3, 4};
Line(3) = {5, 6};
// The ends, which are periodic.
Line(4) = {1, 3};
Line(5) = {2, 4};
Line(6) = {3, 5};
Line(7) = {4, 6};

Curve Loop(1) = {1, 5, -2, -4};
Plane Surface(1) = {1};
Curve Loop(2) = {2, 7, -3, -6};
Plane Surface(2) = {2};

Physical Surface("felt") = {1};
Physical Surface("air") = {2};
Physical Curve("floor") = {1};
Physical Curve("lid") = {3};
