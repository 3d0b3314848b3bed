// A square, periodic in x and y. All lengths in metres.

DefineConstant[
  side = {0.044, Name "side"}
];

If (side <= 0)
  Error("side must be positive");
  Abort;
EndIf

Point(1) = {0, 0, 0};
Point(2) = {side, 0, 0};
Point(3) = {side, side, 0};
Point(4) = {0, side, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};

Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

// The sides are unnamed because they are periodic.
Physical Surface("blood") = {1};
