// A layer of tissue between two plates; periodic in x. All lengths in metres.

DefineConstant[
  half_thickness = {1e-4, Name "half_thickness"},
  length         = {8e-5, Name "length"}
];

If (half_thickness <= 0 || length <= 0)
  Error("half_thickness and length must be positive");
  Abort;
EndIf

SetFactory("OpenCASCADE");
Rectangle(1) = {0, -half_thickness, 0, length, 2 * half_thickness};

Physical Surface("tissue") = {1};
Physical Curve("floor") = {1};
Physical Curve("lid") = {3};
