// One cell of a square array of cylinders, periodic in x and y. All lengths in metres.

DefineConstant[
  side = {1e-3, Name "side"},
  radius = {2.523e-4, Name "radius"}
];

If (radius <= 0 || side <= 2 * radius)
  Error("radius must be positive and below half of the side");
  Abort;
EndIf

SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, side, side};
Disk(2) = {side / 2, side / 2, 0, radius};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };

Physical Surface("water") = {3};
Physical Curve("cylinder") = {5};
