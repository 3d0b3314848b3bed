// A strip along x, clamped at x = 0. All lengths in metres.

DefineConstant[
  length = {0.2, Name "length"}
];

If (length <= 0)
  Error("length must be positive");
  Abort;
EndIf

Point(1) = {0, 0, 0};
Point(2) = {length, 0, 0};
Line(1) = {1, 2};

Physical Curve("strip") = {1};
Physical Point("clamp") = {1};
