// A straight channel between two parallel walls, y = 0 and y = width; periodic in x. All lengths in metres.

DefineConstant[
  width  = {1e-3, Name "width"},
  length = {4e-4, Name "length"}
];

If (width <= 0 || length <= 0)
  Error("width and length must be positive");
  Abort;
EndIf

Point(1) = {0, 0, 0};
Point(2) = {length, 0, 0};
Point(3) = {length, width, 0};
Point(4) = {0, width, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {4, 3};
Line(4) = {1, 4};

Curve Loop(1) = {1, 2, -3, -4};
Plane Surface(1) = {1};

// The two ends are unnamed because they are periodic.
Physical Surface("water") = {1};
Physical Curve("wall") = {1, 3};
