// Two vein valves in series with flexible channels between them, surrounded by tissue, and an embolus. All lengths in
// metres, angles in radians. The upper half:
//
//   ______________________________________________________________   casing
//                        tissue
//   __.              .------------.                .-------------    shell of a chamber, rigid
//     |             .'   ______   '.              .'   __________    chamber_height at the chamber's middle
//     |             | .''      ''. |              | .''
//     *=============*'''--.      ''*==============*''''--.           half_width; = flexible, * clamped
//        channel 1      tip    rim     channel 2        tip
//   ..............................................................   centre line, y = 0
//                     chamber 1                      chamber 2 ... and channel 1 again
//
// The origin is the middle of chamber 1. The period begins and ends in the middle of chamber 2, so that no flexible wall
// is cut; the end lines are unnamed. The flow is to the right: through valve 1 from channel 1 into channel 2. A rigid rim
// at both ends of each channel keeps its wall away from the leaflets' roots. Each side of a chamber is part of an ellipse
// through the chamber's two corners and its top. The tissue is one fluid along the whole vein, so that one channel can
// expand while the other is squeezed.
//
// The embolus is a bar with round ends, or a disc if its length equals its height. It is a separate area; the fluid in it
// solidifies when the run starts.

DefineConstant[
  half_width     = {0.004, Name "half_width"},      // of the vein
  chamber_length = {0.040, Name "chamber_length"},  // between the corners
  chamber_height = {0.007, Name "chamber_height"},  // half height at the chamber's middle
  channel_1      = {0.048, Name "channel_1"},       // length between the chambers, before valve 1
  channel_2      = {0.048, Name "channel_2"},       // length between the chambers, after valve 1
  rim            = {0.002, Name "rim"},             // rigid part at each end of a channel
  shell          = {0.0015, Name "shell"},          // thickness of the chambers' walls
  casing         = {0.0115, Name "casing"},         // half height of the whole geometry
  leaflet_length = {0.010, Name "leaflet_length"},
  root_inset     = {0, Name "root_inset"},          // the vein is narrower by this on both sides at the chambers' corners
  tip_gap        = {0.002, Name "tip_gap"},         // between the two tips of a valve
  embolus        = {1, Name "embolus"},             // 0: none, blood in its place
  embolus_length = {0.0052, Name "embolus_length"}, // total length
  embolus_height = {0.0052, Name "embolus_height"},
  embolus_x      = {-0.034, Name "embolus_x"},      // position of its middle
  embolus_y      = {0,      Name "embolus_y"},
  embolus_tilt   = {0,      Name "embolus_tilt"}    // from the x axis, counter-clockwise
];

root = half_width - root_inset;   // half width at the chambers' corners
rise = root - tip_gap / 2;  // of a leaflet, from its root towards the centre line
corner = chamber_length / 2;

If (half_width <= 0 || tip_gap <= 0 || rim <= 0 || root_inset < 0)
  Error("half_width, tip_gap and rim must be positive, and root_inset not negative");
  Abort;
EndIf
If (rise < 0)
  Error("tip_gap is wider than the vein");
  Abort;
EndIf
If (leaflet_length <= rise || leaflet_length >= corner)
  Error("leaflet_length must exceed half_width - root_inset - tip_gap/2 and be below chamber_length/2");
  Abort;
EndIf
If (chamber_height <= half_width)
  Error("chamber_height must exceed half_width");
  Abort;
EndIf
If (shell <= 0 || casing <= chamber_height + shell)
  Error("shell must be positive, and casing must exceed chamber_height + shell");
  Abort;
EndIf
If (channel_1 <= 2 * rim || channel_2 <= 2 * rim)
  Error("channel_1 and channel_2 must exceed 2 rim");
  Abort;
EndIf
If (embolus_height <= 0 || embolus_length < embolus_height)
  Error("embolus_height must be positive, and embolus_length at least as large");
  Abort;
EndIf

left = -chamber_length - channel_1;
right = chamber_length + channel_2;
axis = corner / Sqrt(1 - (root / chamber_height)^2);  // the ellipses' semi-axis along x
shell_axis = (corner + rim) / Sqrt(1 - ((half_width + shell) / (chamber_height + shell))^2);

// Centres of the ellipses, and a point on the long axis of each.
Point(1) = {0, 0, 0};
Point(2) = {axis, 0, 0};
Point(3) = {left, 0, 0};
Point(4) = {left + axis, 0, 0};
Point(5) = {right, 0, 0};
Point(6) = {right - axis, 0, 0};
Point(7) = {shell_axis, 0, 0};
Point(8) = {left + shell_axis, 0, 0};
Point(9) = {right - shell_axis, 0, 0};

// Upper side (0) and lower side (1), both in the direction of x.
For low In {0:1}
  side = 1 - 2 * low;
  first = 100 + 100 * low;
  Point(first + 0) = {left, side * chamber_height, 0};
  Point(first + 1) = {left + corner, side * root, 0};
  Point(first + 2) = {left + corner + rim, side * half_width, 0};
  Point(first + 3) = {-corner - rim, side * half_width, 0};
  Point(first + 4) = {-corner, side * root, 0};  // root of valve 1
  Point(first + 5) = {0, side * chamber_height, 0};
  Point(first + 6) = {corner, side * root, 0};
  Point(first + 7) = {corner + rim, side * half_width, 0};
  Point(first + 8) = {right - corner - rim, side * half_width, 0};
  Point(first + 9) = {right - corner, side * root, 0};  // root of valve 2
  Point(first + 10) = {right, side * chamber_height, 0};

  // The third point of an ellipse lies on its axis along x.
  Ellipse(first + 0) = {first + 0, 3, 4, first + 1};
  Line(first + 1) = {first + 1, first + 2};
  Line(first + 2) = {first + 2, first + 3};  // channel 1
  Line(first + 3) = {first + 3, first + 4};
  Ellipse(first + 4) = {first + 4, 1, 2, first + 5};
  Ellipse(first + 5) = {first + 5, 1, 2, first + 6};
  Line(first + 6) = {first + 6, first + 7};
  Line(first + 7) = {first + 7, first + 8};  // channel 2
  Line(first + 8) = {first + 8, first + 9};
  Ellipse(first + 9) = {first + 9, 5, 6, first + 10};

  // The outer sides of the chambers, in the direction of x, and the casing.
  Point(first + 30) = {left, side * (chamber_height + shell), 0};
  Point(first + 31) = {left + corner + rim, side * (half_width + shell), 0};
  Point(first + 32) = {-corner - rim, side * (half_width + shell), 0};
  Point(first + 33) = {0, side * (chamber_height + shell), 0};
  Point(first + 34) = {corner + rim, side * (half_width + shell), 0};
  Point(first + 35) = {right - corner - rim, side * (half_width + shell), 0};
  Point(first + 36) = {right, side * (chamber_height + shell), 0};
  Point(first + 37) = {left, side * casing, 0};
  Point(first + 38) = {right, side * casing, 0};
  Ellipse(first + 30) = {first + 30, 3, 8, first + 31};
  Line(first + 31) = {first + 31, first + 2};
  Line(first + 32) = {first + 3, first + 32};
  Ellipse(first + 33) = {first + 32, 1, 7, first + 33};
  Ellipse(first + 34) = {first + 33, 1, 7, first + 34};
  Line(first + 35) = {first + 34, first + 7};
  Line(first + 36) = {first + 8, first + 35};
  Ellipse(first + 37) = {first + 35, 5, 9, first + 36};
  Line(first + 38) = {first + 37, first + 38};  // casing
  Line(first + 39) = {first + 30, first + 37};  // open ends
  Line(first + 40) = {first + 36, first + 38};
  Curve Loop(10 + low) = {first + 30, first + 31, first + 2, first + 32, first + 33, first + 34, first + 35, first + 7,
                          first + 36, first + 37, first + 40, -(first + 38), -(first + 39)};
  Plane Surface(10 + low) = {10 + low};

  // Leaflets, from root to tip.
  reach = Sqrt(leaflet_length^2 - rise^2);
  Point(first + 20) = {-corner + reach, side * tip_gap / 2, 0};
  Point(first + 21) = {right - corner + reach, side * tip_gap / 2, 0};
  Line(first + 20) = {first + 4, first + 20};
  Line(first + 21) = {first + 9, first + 21};
EndFor

// The open ends.
Line(300) = {200, 100};
Line(301) = {210, 110};

Curve Loop(1) = {200:209, 301, -109, -108, -107, -106, -105, -104, -103, -102, -101, -100, -300};

c = Cos(embolus_tilt);
s = Sin(embolus_tilt);
radius = embolus_height / 2;
half = embolus_length / 2 - radius;  // from its middle to the centres of its round ends
// Corners of the embolus, counter-clockwise from the lower left one, and the outermost points of its ends.
Point(400) = {embolus_x - half * c + radius * s, embolus_y - half * s - radius * c, 0};
Point(401) = {embolus_x + half * c + radius * s, embolus_y + half * s - radius * c, 0};
Point(402) = {embolus_x + (half + radius) * c, embolus_y + (half + radius) * s, 0};
Point(403) = {embolus_x + half * c - radius * s, embolus_y + half * s + radius * c, 0};
Point(404) = {embolus_x - half * c - radius * s, embolus_y - half * s + radius * c, 0};
Point(405) = {embolus_x - (half + radius) * c, embolus_y - (half + radius) * s, 0};
Point(406) = {embolus_x - half * c, embolus_y - half * s, 0};
Point(407) = {embolus_x + half * c, embolus_y + half * s, 0};
If (half > 0)
  Line(400) = {400, 401};
  Circle(401) = {401, 407, 402};
  Circle(402) = {402, 407, 403};
  Line(403) = {403, 404};
  Circle(404) = {404, 406, 405};
  Circle(405) = {405, 406, 400};
  Curve Loop(2) = {400:405};
Else
  Circle(401) = {400, 406, 402};
  Circle(402) = {402, 406, 404};
  Circle(404) = {404, 406, 405};
  Circle(405) = {405, 406, 400};
  Curve Loop(2) = {401, 402, 404, 405};
EndIf
If (embolus > 0)
  Plane Surface(1) = {1, 2};
  Plane Surface(2) = {2};
  Physical Surface("embolus") = {2};
Else
  Plane Surface(1) = {1};
EndIf

Physical Surface("blood") = {1};
Physical Surface("tissue") = {10, 11};
Physical Curve("chambers") = {100, 101, 103:106, 108, 109, 130:137, 200, 201, 203:206, 208, 209, 230:237};
Physical Curve("casing") = {138, 238};
Physical Curve("channel_1") = {102, 202};
Physical Curve("channel_2") = {107, 207};
Physical Curve("leaflets_1") = {120, 220};
Physical Curve("leaflets_2") = {121, 221};
Physical Point("channel_ends") = {102, 103, 107, 108, 202, 203, 207, 208};
Physical Point("leaflet_roots") = {104, 109, 204, 209};
