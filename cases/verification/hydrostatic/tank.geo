// A closed tank. All lengths in metres.

DefineConstant[
  width  = {0.4, Name "width"},
  height = {1, Name "height"}
];

If (width <= 0 || height <= 0)
  Error("width and height must be positive");
  Abort;
EndIf

Point(1) = {0, 0, 0};
Point(2) = {width, 0, 0};
Point(3) = {width, height, 0};
Point(4) = {0, height, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};

Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

Physical Surface("water") = {1};
Physical Curve("wall") = {1, 2, 3, 4};
