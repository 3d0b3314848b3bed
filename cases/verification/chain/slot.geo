// A slot below a ceiling, one particle wide. All lengths in metres.

DefineConstant[
  width  = {0.001, Name "width"},
  length = {0.01, Name "length"}
];

If (width <= 0 || length <= 0)
  Error("width and length must be positive");
  Abort;
EndIf

Point(1) = {-width / 2, 0, 0};
Point(2) = {-width / 2, -length, 0};
Point(3) = {width / 2, -length, 0};
Point(4) = {width / 2, 0, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};

Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

Physical Surface("glue") = {1};
Physical Curve("slot") = {1, 2, 3};
Physical Curve("ceiling") = {4};
