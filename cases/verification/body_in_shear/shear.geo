// A disc or an ellipse, its long axis along x, in the middle of a channel that is periodic in x. All lengths in metres.

SetFactory("OpenCASCADE");

DefineConstant[
  long_axis  = {1e-3, Name "long_axis"},
  short_axis = {1e-3, Name "short_axis"},
  length     = {4e-3, Name "length"},
  height     = {4e-3, Name "height"}
];

If (long_axis < short_axis || short_axis <= 0 || length <= long_axis || height <= long_axis)
  Error("needs 0 < short_axis <= long_axis < length and height");
  Abort;
EndIf

Rectangle(1) = {-length / 2, -height / 2, 0, length, height};
Disk(2) = {0, 0, 0, long_axis / 2, short_axis / 2};
BooleanFragments{ Surface{1}; Delete; }{ Surface{2}; Delete; }

body() = Surface In BoundingBox{-0.51 * long_axis, -0.51 * short_axis, -1, 0.51 * long_axis, 0.51 * short_axis, 1};
all() = Surface{:};
all() -= body();
Physical Surface("liquid") = all();
Physical Surface("body") = body();
Physical Curve("lower_lid") = Curve In BoundingBox{-length, -0.51 * height, -1, length, -0.49 * height, 1};
Physical Curve("upper_lid") = Curve In BoundingBox{-length, 0.49 * height, -1, length, 0.51 * height, 1};
