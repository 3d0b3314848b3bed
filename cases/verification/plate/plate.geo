// A plate in the plane z = 0, 20 mm x 10 mm, that touches a block along its short side x = 0. All lengths in metres.

SetFactory("OpenCASCADE");

DefineConstant[
  length = {2e-2, Name "length"},
  width = {1e-2, Name "width"}
];

If (length <= 0 || width <= 0)
  Error("length and width must be positive");
  Abort;
EndIf

Rectangle(1) = {0, 0, 0, length, width};
Box(1) = {-2e-3, -2e-3, -2e-3, 2e-3, width + 4e-3, 4e-3};

Physical Surface("plate") = {1};
Physical Volume("block") = {1};
