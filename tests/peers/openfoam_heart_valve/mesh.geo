// Quadrilaterals, one cell deep, over cases/heart_valve/rigid.geo: `cell` wide in vessel and chamber, a third of
// it in the jet, an eighth at the leaflets.
DefineConstant[ cell = {0.001, Name "cell"} ];
Include "rigid.geo";
Delete Physicals;

Field[1] = Distance;
Field[1].EdgesList = {102, 103, 108};
If (whole)
  Field[1].EdgesList = {102, 103, 108, 202, 203, 208};
EndIf
Field[1].NNodesByEdge = 200;
Field[2] = Threshold;
Field[2].IField = 1;
Field[2].LcMin = cell / 8;
Field[2].LcMax = cell;
Field[2].DistMin = 0.0004;
Field[2].DistMax = 0.010;
Field[3] = Box;
Field[3].VIn = cell / 3;
Field[3].VOut = cell;
Field[3].XMin = -0.008;
Field[3].XMax = 0.025;
Field[3].YMin = -0.004;
Field[3].YMax = 0.004;
Field[3].Thickness = 0.010;
Field[4] = Min;
Field[4].FieldsList = {2, 3};
Background Field = 4;
Mesh.CharacteristicLengthExtendFromBoundary = 0;
Mesh.CharacteristicLengthFromPoints = 0;
Mesh.Algorithm = 6;
Mesh.RecombineAll = 1;
Mesh.MshFileVersion = 2.2;

out() = Extrude {0, 0, 0.001} { Surface{1}; Layers{1}; Recombine; };
Physical Volume("blood") = {out(1)};
Physical Surface("frontAndBack") = {1, out(0)};
If (whole)
  Physical Surface("leaflets") = {out(3), out(4), out(5), out(6), out(14), out(15), out(16), out(17)};
  Physical Surface("wall") = {out(2), out(7), out(8), out(9), out(11), out(12), out(13), out(18)};
  Physical Surface("outlet") = {out(10)};
  Physical Surface("inlet") = {out(19)};
Else
  Physical Surface("axis") = {out(2)};
  Physical Surface("outlet") = {out(3)};
  Physical Surface("wall") = {out(4), out(5), out(6), out(11)};
  Physical Surface("leaflets") = {out(7), out(8), out(9), out(10)};
  Physical Surface("inlet") = {out(12)};
EndIf
