// A straight channel with a wound in its lower wall, about a third of the way along. All lengths in metres.
//
//   ______________________________________   wall
//
//   ->                                  ->   blood, periodic along x
//   ____________ wound ___________________   wall

DefineConstant[
  length = {0.006, Name "length"},
  width  = {0.002, Name "width"},
  wound  = {0.0006, Name "wound"}
];

If (wound <= 0 || wound >= length || width <= 0)
  Error("wound must be shorter than length, and all lengths positive");
  Abort;
EndIf

Point(1) = {0, 0, 0};
Point(2) = {(length - wound) / 3, 0, 0};
Point(3) = {(length - wound) / 3 + wound, 0, 0};
Point(4) = {length, 0, 0};
Point(5) = {length, width, 0};
Point(6) = {0, width, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Curve Loop(1) = {1:6};
Plane Surface(1) = {1};

Physical Surface("blood") = {1};
Physical Curve("wall") = {1, 3, 5};
Physical Curve("wound") = {2};
