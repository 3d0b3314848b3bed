// A channel of constant width that rises over a hump and returns to its initial level, with one flap on the inner wall
// of the crest. All lengths in metres, angles in radians.
//
//                      ____.____
//                   .-'    .    '-.            crest: a bend of 2 bend_angle around (0, level)
//                 .'    ___|flap   '.
//               .'    .'   root'.    '.
//             .'    .'           '.    '.      legs: straight, of length leg_length
//   _______.-'    .'               '.    '-._______
//                .'                 '.                centre line at y = 0 here
//   __________.-'                     '-.__________
//
//   |<---------------- domain_length ---------------->|     periodic: the two end lines are unnamed
//
// The centre line consists of straight lines and arcs of radius bend_radius: up from the level by bend_angle, a leg up, over
// the crest, a leg down, and back to the level. The walls are parallel to it at a distance of half_width, so the area is the
// length of the centre line times the width. Except for the flap, the geometry is symmetric about x = 0.

DefineConstant[
  half_width    = {0.003, Name "half_width"},
  domain_length = {0.060, Name "domain_length"},
  bend_radius   = {0.012, Name "bend_radius"},   // of the centre line
  bend_angle    = {Pi/3,  Name "bend_angle"},    // slope of the legs
  leg_length    = {0.004, Name "leg_length"},
  flap_length   = {0.004, Name "flap_length"},
  flap_lean     = {Pi/12, Name "flap_lean"}      // from the wall's normal towards +x
];

s = Sin(bend_angle);
c = Cos(bend_angle);
end = domain_length / 2;
bend_x = 2 * bend_radius * s + leg_length * c;         // end of the level, start of the first bend
crest = 2 * bend_radius * (1 - c) + leg_length * s;    // height of the crest's centre line
level = crest - bend_radius;                           // height of the crest's centre of curvature

If (half_width <= 0 || leg_length <= 0 || flap_length <= 0)
  Error("half_width, leg_length and flap_length must be positive");
  Abort;
EndIf
If (bend_radius <= half_width)
  Error("bend_radius must exceed half_width");
  Abort;
EndIf
If (bend_angle <= 0 || bend_angle > Pi/2)
  Error("bend_angle must lie between 0 and 90 degrees");
  Abort;
EndIf
If (end <= bend_x)
  Error("domain_length is too short for the bends and legs");
  Abort;
EndIf
If (flap_length * Cos(flap_lean) >= 2 * half_width || Fabs(flap_lean) >= Pi/2)
  Error("the flap does not fit into the channel");
  Abort;
EndIf

// Centres of curvature: of the crest, and of the bends that leave and reach the level.
Point(1) = {0, level, 0};
Point(2) = {-bend_x, bend_radius, 0};
Point(3) = {bend_x, bend_radius, 0};

// Lower wall (0) and upper wall (1): parallel to the centre line at -half_width and +half_width.
For wall In {0:1}
  side = (2 * wall - 1) * half_width;
  first = 100 + 100 * wall;
  level_radius = bend_radius - side;  // the bends at the level turn left, the crest turns right
  crest_radius = bend_radius + side;
  foot_x = bend_x - level_radius * s;  // start and end of the legs
  foot_y = bend_radius - level_radius * c;
  top_x = crest_radius * s;
  top_y = level + crest_radius * c;

  Point(first + 0) = {-end, side, 0};
  Point(first + 1) = {-bend_x, side, 0};
  Point(first + 2) = {-foot_x, foot_y, 0};
  Point(first + 3) = {-top_x, top_y, 0};
  Point(first + 4) = {0, level + crest_radius, 0};
  Point(first + 5) = {top_x, top_y, 0};
  Point(first + 6) = {foot_x, foot_y, 0};
  Point(first + 7) = {bend_x, side, 0};
  Point(first + 8) = {end, side, 0};

  Line(first + 0) = {first + 0, first + 1};
  Circle(first + 1) = {first + 1, 2, first + 2};
  Line(first + 2) = {first + 2, first + 3};
  Circle(first + 3) = {first + 3, 1, first + 4};
  Circle(first + 4) = {first + 4, 1, first + 5};
  Line(first + 5) = {first + 5, first + 6};
  Circle(first + 6) = {first + 6, 3, first + 7};
  Line(first + 7) = {first + 7, first + 8};
EndFor

// The open ends.
Line(300) = {100, 200};
Line(301) = {108, 208};

Curve Loop(1) = {100:107, 301, -207, -206, -205, -204, -203, -202, -201, -200, -300};
Plane Surface(1) = {1};

// The flap, from its root on the inner wall of the crest to its tip.
root_y = crest - half_width;
Point(300) = {flap_length * Sin(flap_lean), root_y + flap_length * Cos(flap_lean), 0};
Line(310) = {104, 300};

Physical Surface("blood") = {1};
Physical Curve("wall") = {100:107, 200:207};
Physical Curve("flap") = {310};
Physical Point("flap_root") = {104};
