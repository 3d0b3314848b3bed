// A belt of mucus between two layers of water, between two parallel walls; periodic in x. All lengths in metres.

DefineConstant[
  water  = {1.32e-6, Name "water"},
  mucus  = {0.66e-6, Name "mucus"},
  length = {0.528e-6, Name "length"}
];

If (water <= 0 || mucus <= 0 || length <= 0)
  Error("water, mucus and length must be positive");
  Abort;
EndIf

For row In {0:1}
  Point(1 + 10 * row) = {0, row * (water + mucus), 0};
  Point(2 + 10 * row) = {length, row * (water + mucus), 0};
  Point(3 + 10 * row) = {length, row * (water + mucus) + water, 0};
  Point(4 + 10 * row) = {0, row * (water + mucus) + water, 0};
EndFor

// Walls.
Line(1) = {1, 2};
Line(2) = {14, 13};
// Interfaces between mucus and water.
Line(3) = {4, 3};
Line(4) = {11, 12};
// The ends, which are periodic.
Line(5) = {1, 4};
Line(6) = {2, 3};
Line(7) = {4, 11};
Line(8) = {3, 12};
Line(9) = {11, 14};
Line(10) = {12, 13};

Curve Loop(1) = {1, 6, -3, -5};
Plane Surface(1) = {1};
Curve Loop(2) = {3, 8, -4, -7};
Plane Surface(2) = {2};
Curve Loop(3) = {4, 10, -2, -9};
Plane Surface(3) = {3};

Physical Surface("water") = {1, 3};
Physical Surface("mucus") = {2};
Physical Curve("wall") = {1, 2};
