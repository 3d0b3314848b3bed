// A beam that stands out from the left wall of a closed tank, in the middle of its height. All lengths in metres.

DefineConstant[
  length    = {10e-3, Name "length"},
  thickness = {1e-3, Name "thickness"},
  space     = {4e-3, Name "space"},
  is_filled = {1, Name "is_filled"}
];

If (length <= 0 || thickness <= 0 || space <= 0)
  Error("length, thickness and space must be positive");
  Abort;
EndIf

SetFactory("OpenCASCADE");
Rectangle(1) = {0, -thickness/2, 0, length, thickness};
If (is_filled)
  Rectangle(2) = {0, -thickness/2 - space, 0, length + space, thickness + 2*space};
  BooleanDifference(3) = { Surface{2}; Delete; }{ Surface{1}; };
  Physical Surface("liquid") = {3};
EndIf
Physical Surface("beam") = {1};

e = 1e-3 * thickness;
root() = Curve In BoundingBox {-e, -thickness/2 - e, -e, e, thickness/2 + e, e};
Physical Curve("root") = {root()};
If (is_filled)
  sides() = Curve In BoundingBox {-e, -thickness - space, -e, e, thickness + space, e};
  sides() -= {root()};
  sides() += {Curve In BoundingBox {length + space - e, -thickness - space, -e, length + space + e, thickness + space, e}};
  sides() += {Curve In BoundingBox {-e, -thickness/2 - space - e, -e, length + space + e, -thickness/2 - space + e, e}};
  sides() += {Curve In BoundingBox {-e, thickness/2 + space - e, -e, length + space + e, thickness/2 + space + e, e}};
  Physical Curve("wall") = {sides()};
EndIf
