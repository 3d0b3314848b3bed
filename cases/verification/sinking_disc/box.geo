// A disc in the middle of a closed box. All lengths in metres.

SetFactory("OpenCASCADE");

DefineConstant[
  diameter = {1e-3, Name "diameter"},
  width    = {5e-3, Name "width"},
  height   = {12e-3, Name "height"}
];

If (diameter <= 0 || width <= diameter || height <= diameter)
  Error("needs 0 < diameter < width and height");
  Abort;
EndIf

Rectangle(1) = {-width / 2, -height / 2, 0, width, height};
Disk(2) = {0, 0, 0, diameter / 2};
BooleanFragments{ Surface{1}; Delete; }{ Surface{2}; Delete; }

body() = Surface In BoundingBox{-0.51 * diameter, -0.51 * diameter, -1, 0.51 * diameter, 0.51 * diameter, 1};
rim() = Boundary{ Surface{body()}; };
all() = Surface{:};
all() -= body();
sides() = Curve{:};
sides() -= rim();
Physical Surface("liquid") = all();
Physical Surface("disc") = body();
Physical Curve("wall") = sides();
