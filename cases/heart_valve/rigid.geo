// The upper half of the heart valve of heart_valve.geo with leaflets that are walls: an area `leaflet_thickness` thick about
// the leaflet's line, round at its tip and let into the wall at its root. whole = 1 draws the lower half as well.
// All lengths in metres.
//
//                  .-'''''''''-.
//               .'               '.             chamber_radius around the origin
//   -----------.                   *----------   half_width
//               '\\.               |
//                  '\\.            |
//                     '\\ tip      |
//   ................................................  y = 0: the plane of symmetry, unnamed
//   |<-- upstream -->|       0     |<- downstream ->|  periodic: the two end lines are unnamed

DefineConstant[
  half_width        = {0.0125, Name "half_width"},        // of the vessel
  upstream          = {0.065,  Name "upstream"},          // from the middle of the chamber
  downstream        = {0.080,  Name "downstream"},
  chamber_radius    = {0.0215, Name "chamber_radius"},
  leaflet_length    = {0.016,  Name "leaflet_length"},
  leaflet_thickness = {0.001,  Name "leaflet_thickness"},
  tip_gap           = {0.004,  Name "tip_gap"},           // between the middles of the two tips
  whole             = {0,      Name "whole"}
];

rise = half_width - tip_gap / 2;
corner = Sqrt(chamber_radius^2 - half_width^2);
If (leaflet_length <= rise || chamber_radius <= half_width)
  Error("needs leaflet_length > half_width - tip_gap/2 and chamber_radius > half_width");
  Abort;
EndIf
sine = rise / leaflet_length;                             // of the angle between leaflet and axis
cosine = Sqrt(1 - sine^2);
half = leaflet_thickness / 2;
If (tip_gap / 2 <= half * cosine || upstream <= corner + half / sine || downstream <= corner)
  Error("the leaflets touch, or the vessel is too short");
  Abort;
EndIf

tip_x = -corner + leaflet_length * cosine;
end_x = tip_x - half * cosine;                            // of the round tip's middle
end_y = tip_gap / 2 + half * sine;
root_x = -corner - half / sine;                           // where the underside meets the vessel
// Where the upper side meets the chamber: a + s (cosine, -sine), a the root moved up by half the thickness.
a_x = -corner + half * sine;
a_y = half_width + half * cosine;
b = a_x * cosine - a_y * sine;
s = -b - Sqrt(b^2 - (a_x^2 + a_y^2 - chamber_radius^2));

Point(1) = {0, 0, 0};                                     // centre of the chamber

Macro HalfOfTheValve                                      // up: 1 or -1, n: the number its points and lines begin with
  Point(n + 1) = {-upstream, up * half_width, 0};
  Point(n + 2) = {root_x, up * half_width, 0};
  Point(n) = {end_x, up * end_y, 0};
  Point(n + 3) = {end_x - half * sine, up * (end_y - half * cosine), 0};
  Point(n + 9) = {tip_x, up * tip_gap / 2, 0};
  Point(n + 4) = {end_x + half * sine, up * (end_y + half * cosine), 0};
  Point(n + 5) = {a_x + s * cosine, up * (a_y - s * sine), 0};
  Point(n + 6) = {0, up * chamber_radius, 0};
  Point(n + 7) = {corner, up * half_width, 0};
  Point(n + 8) = {downstream, up * half_width, 0};
  Line(n + 1) = {n + 1, n + 2};
  Line(n + 2) = {n + 2, n + 3};
  Circle(n + 3) = {n + 3, n, n + 9};
  Circle(n + 8) = {n + 9, n, n + 4};
  Line(n + 4) = {n + 4, n + 5};
  Circle(n + 5) = {n + 5, 1, n + 6};
  Circle(n + 6) = {n + 6, 1, n + 7};
  Line(n + 7) = {n + 7, n + 8};
Return

up = 1; n = 100;
Call HalfOfTheValve;
If (whole)
  up = -1; n = 200;
  Call HalfOfTheValve;
  Line(31) = {208, 108};
  Line(32) = {101, 201};
  Curve Loop(1) = {201:203, 208, 204:207, 31, -107:-104, -108, -103:-101, 32};
  Physical Curve("wall") = {101, 105, 106, 107, 201, 205, 206, 207};
  Physical Curve("leaflets") = {102, 103, 108, 104, 202, 203, 208, 204};
Else
  Point(21) = {-upstream, 0, 0};
  Point(28) = {downstream, 0, 0};
  Line(30) = {21, 28};
  Line(31) = {28, 108};
  Line(32) = {101, 21};
  Curve Loop(1) = {30, 31, -107:-104, -108, -103:-101, 32};
  Physical Curve("wall") = {101, 105, 106, 107};
  Physical Curve("leaflets") = {102, 103, 108, 104};
EndIf
Plane Surface(1) = {1};
Physical Surface("blood") = {1};
