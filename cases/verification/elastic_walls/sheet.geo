// A channel of height H, periodic in x, with a flexible sheet along its middle that is held at both ends. Metres.
DefineConstant[
  H = {10e-3, Name "H"},
  L = {10e-3, Name "L"}
];

Point(1) = {0, -H / 2, 0};
Point(2) = {L, -H / 2, 0};
Point(3) = {L, 0, 0};
Point(4) = {L, H / 2, 0};
Point(5) = {0, H / 2, 0};
Point(6) = {0, 0, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Line(7) = {6, 3};
Curve Loop(1) = {1, 2, -7, 6};
Curve Loop(2) = {7, 3, 4, 5};
Plane Surface(1) = {1};
Plane Surface(2) = {2};

Physical Surface("liquid") = {1, 2};
Physical Curve("sheet") = {7};
Physical Curve("wall") = {1, 4};
Physical Point("hold") = {3, 6};
