// A bar with its middle at the origin. All lengths in metres.

DefineConstant[
  length = {40e-3, Name "length"},
  width  = {4e-3, Name "width"},
  angle  = {0, Name "angle"}
];

If (length <= 0 || width <= 0)
  Error("length and width must be positive");
  Abort;
EndIf

SetFactory("OpenCASCADE");
Rectangle(1) = {-length/2, -width/2, 0, length, width};
Rotate {{0, 0, 1}, {0, 0, 0}, angle * Pi / 180} { Surface{1}; }
Physical Surface("bar") = {1};
