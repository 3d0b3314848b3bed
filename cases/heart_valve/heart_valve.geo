// A bicuspid heart valve: a straight vessel along x with a round chamber around the origin and two straight leaflets.
// All lengths in metres, angles in radians.
//
//                  .-'''''''''-.
//               .'               '.             chamber_radius around the origin
//   -----------*                   *----------   half_width
//          root '-.                |
//                  '-. tip         |
//                                  |  .........   centre line, y = 0
//                  .-' tip         |
//          root .-'                |
//   -----------*                   *----------
//               '.               .'
//                  '-._______.-'
//   |<--------------- domain_length --------------->|     periodic: the two end lines are unnamed

DefineConstant[
  half_width     = {0.0125, Name "half_width"},      // of the vessel
  domain_length  = {0.105,  Name "domain_length"},
  chamber_radius = {0.0215, Name "chamber_radius"},
  leaflet_length = {0.016,  Name "leaflet_length"},
  tip_gap        = {0.004,  Name "tip_gap"}          // between the two tips
];

If (half_width <= 0 || tip_gap <= 0)
  Error("half_width and tip_gap must be positive");
  Abort;
EndIf
If (tip_gap / 2 > half_width)
  Error("tip_gap is wider than the vessel");
  Abort;
EndIf
If (chamber_radius <= half_width)
  Error("chamber_radius must exceed half_width");
  Abort;
EndIf

rise = half_width - tip_gap / 2;                       // of a leaflet, from its root towards the centre line
corner = Sqrt(chamber_radius^2 - half_width^2);        // where the chamber meets the vessel
end = domain_length / 2;

If (leaflet_length <= rise)
  Error("leaflet_length is too short to reach tip_gap: it must exceed half_width - tip_gap/2");
  Abort;
EndIf
If (end <= corner)
  Error("domain_length must exceed the length of the chamber, 2 sqrt(chamber_radius^2 - half_width^2)");
  Abort;
EndIf

Point(1) = {0, 0, 0};  // centre of the chamber

Point(10) = {-end, half_width, 0};
Point(11) = {-corner, half_width, 0};  // upper root
Point(12) = {0, chamber_radius, 0};
Point(13) = {corner, half_width, 0};
Point(14) = {end, half_width, 0};

Point(20) = {-end, -half_width, 0};
Point(21) = {-corner, -half_width, 0};  // lower root
Point(22) = {0, -chamber_radius, 0};
Point(23) = {corner, -half_width, 0};
Point(24) = {end, -half_width, 0};

// Upper wall, then lower wall, both in the direction of x.
Line(10) = {10, 11};
Circle(11) = {11, 1, 12};
Circle(12) = {12, 1, 13};
Line(13) = {13, 14};
Line(20) = {20, 21};
Circle(21) = {21, 1, 22};
Circle(22) = {22, 1, 23};
Line(23) = {23, 24};

// The open ends.
Line(30) = {20, 10};
Line(31) = {24, 14};

Curve Loop(1) = {20, 21, 22, 23, 31, -13, -12, -11, -10, -30};
Plane Surface(1) = {1};

// Leaflets, from root to tip.
tip_x = -corner + Sqrt(leaflet_length^2 - rise^2);
Point(15) = {tip_x, tip_gap / 2, 0};
Point(25) = {tip_x, -tip_gap / 2, 0};
Line(40) = {11, 15};
Line(41) = {21, 25};

Physical Surface("blood") = {1};
Physical Curve("wall") = {10, 11, 12, 13, 20, 21, 22, 23};
Physical Curve("leaflets") = {40, 41};
Physical Point("leaflet_roots") = {11, 21};
