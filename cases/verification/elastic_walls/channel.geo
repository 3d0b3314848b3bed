// A channel of height H, periodic in x, between two elastic layers of thickness h whose outer faces are held. Metres.
DefineConstant[
  H = {10e-3, Name "H"},
  h = {3e-3, Name "h"},
  L = {10e-3, Name "L"}
];

y() = {-H / 2 - h, -H / 2, H / 2, H / 2 + h};
For i In {0:3}
  Point(2 * i + 1) = {0, y(i), 0};
  Point(2 * i + 2) = {L, y(i), 0};
  Line(i + 1) = {2 * i + 1, 2 * i + 2};
EndFor
For i In {0:2}
  Line(11 + i) = {2 * i + 2, 2 * i + 4};
  Line(21 + i) = {2 * i + 3, 2 * i + 1};
  Curve Loop(i + 1) = {i + 1, 11 + i, -(i + 2), 21 + i};
  Plane Surface(i + 1) = {i + 1};
EndFor

Physical Surface("liquid") = {2};
Physical Surface("layers") = {1, 3};
Physical Curve("backs") = {1, 4};
