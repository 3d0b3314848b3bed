// A deep vein valve: a straight vein along x with a valve chamber (sinus) around x = 0 and two straight leaflets.
// All lengths in metres, angles in radians.
//
//                      ___.......___            chamber_height above the centre line at x = 0
//              _..--'''             '''--.._
//   ----------*----.___                     *----------   half_width
//             root     ''''----.. tip
//                                            ...........   centre line, y = 0
//             root     ....----'' tip
//   ----------*----'''                      *----------
//              ''--..___             ___..--''
//                       ''''''''''''
//             |<------ chamber_length ------>|
//   |<--------------- domain_length --------------->|     periodic: the two end lines are unnamed
//
// Each side of the chamber is part of an ellipse around the origin through the chamber's two corners and its top.

DefineConstant[
  half_width     = {0.004,  Name "half_width"},      // of the vein
  domain_length  = {0.092,  Name "domain_length"},
  chamber_length = {0.040,  Name "chamber_length"},  // between the corners
  chamber_height = {0.007,  Name "chamber_height"},  // half height at x = 0
  leaflet_length = {0.0175, Name "leaflet_length"},
  tip_gap        = {0.002,  Name "tip_gap"}          // between the two tips
];

rise = half_width - tip_gap / 2;  // of a leaflet, from its root towards the centre line

If (half_width <= 0 || tip_gap <= 0)
  Error("half_width and tip_gap must be positive");
  Abort;
EndIf
If (rise < 0)
  Error("tip_gap is wider than the vein");
  Abort;
EndIf
If (leaflet_length <= rise)
  Error("leaflet_length is too short to reach tip_gap: it must exceed half_width - tip_gap/2");
  Abort;
EndIf
If (chamber_height <= half_width)
  Error("chamber_height must exceed half_width");
  Abort;
EndIf
If (chamber_length <= 0 || domain_length <= chamber_length)
  Error("chamber_length must be positive, and domain_length must exceed it");
  Abort;
EndIf

corner = chamber_length / 2;
end = domain_length / 2;
axis = corner / Sqrt(1 - (half_width / chamber_height)^2);  // the ellipse's semi-axis along x

Point(1) = {0, 0, 0};     // centre of the ellipses
Point(2) = {axis, 0, 0};  // on their long axis, where chamber_height is not larger

Point(10) = {-end, half_width, 0};
Point(11) = {-corner, half_width, 0};  // upper root
Point(12) = {0, chamber_height, 0};
Point(13) = {corner, half_width, 0};
Point(14) = {end, half_width, 0};

Point(20) = {-end, -half_width, 0};
Point(21) = {-corner, -half_width, 0};  // lower root
Point(22) = {0, -chamber_height, 0};
Point(23) = {corner, -half_width, 0};
Point(24) = {end, -half_width, 0};

// Upper wall, then lower wall, both in the direction of x. The third point of an ellipse lies on its axis along x.
Line(10) = {10, 11};
Ellipse(11) = {11, 1, 2, 12};
Ellipse(12) = {12, 1, 2, 13};
Line(13) = {13, 14};
Line(20) = {20, 21};
Ellipse(21) = {21, 1, 2, 22};
Ellipse(22) = {22, 1, 2, 23};
Line(23) = {23, 24};

// The open ends.
Line(30) = {20, 10};
Line(31) = {24, 14};

Curve Loop(1) = {20, 21, 22, 23, 31, -13, -12, -11, -10, -30};
Plane Surface(1) = {1};

// Leaflets, from root to tip: inclined by Asin(rise / leaflet_length) towards the centre line.
tip_x = -corner + Sqrt(leaflet_length^2 - rise^2);
Point(15) = {tip_x, tip_gap / 2, 0};
Point(25) = {tip_x, -tip_gap / 2, 0};
Line(40) = {11, 15};
Line(41) = {21, 25};

Physical Surface("blood") = {1};
Physical Curve("wall") = {10, 11, 12, 13, 20, 21, 22, 23};
Physical Curve("leaflets") = {40, 41};
Physical Point("leaflet_roots") = {11, 21};
