// A straight tube along x with a valve of three flat leaflets that point downstream. All lengths in metres.
//
//   wall  ----------------*----.--------------------   seen from the side: leaflet k is the part of an inclined plane
//                          '.   '. edge                that lies in its third of the tube, one edge along the wall,
//                            '.   '.                   two free. Its most upstream point (*, x = 0) is mid-way in
//   axis  ....................'.....'.. x = height     that third, at the wall.
//
//   Seen along x, three slits of width gap separate the leaflets from each other; on the axis, where the leaflets would
//   meet, a triangle remains open.
//
//   |<- upstream ->|<-------- downstream ---------->|  of x = 0; periodic: the two ends are unnamed
//
// The leaflets are faces inside the blood, not part of the tube's surface: the blood fills the whole tube.

SetFactory("OpenCASCADE");

DefineConstant[
  radius     = {5e-3,  Name "radius"},
  upstream   = {10e-3, Name "upstream"},
  downstream = {20e-3, Name "downstream"},
  height     = {6e-3,  Name "height"},       // x at which the three planes meet on the axis
  gap        = {1e-3,  Name "gap"}
];

If (radius <= 0 || upstream <= 0 || height <= 0 || gap <= 0)
  Error("radius, upstream, height and gap must be positive");
  Abort;
EndIf
If (downstream <= height)
  Error("downstream must exceed height");
  Abort;
EndIf
If (gap >= radius)
  Error("gap must be less than radius");
  Abort;
EndIf

// Two slits meet at this distance from the axis, in the middle of a third.
corner = gap / 2 / Sin(Pi / 3);
leaflets[] = {};
far = 2 * radius;  // beyond the tube
reach = corner + far;
For k In {0:2}
  // Constructed in the third about +y, then rotated about x.
  a = newp; Point(a) = {height * (1 - corner / radius), corner, 0};
  b = newp; Point(b) = {height * (1 - reach / radius), reach, far * Tan(Pi / 3)};
  c = newp; Point(c) = {height * (1 - reach / radius), reach, -far * Tan(Pi / 3)};
  ab = newl; Line(ab) = {a, b};
  bc = newl; Line(bc) = {b, c};
  ca = newl; Line(ca) = {c, a};
  loop = newll; Curve Loop(loop) = {ab, bc, ca};
  wedge = news; Plane Surface(wedge) = {loop};
  tube = newv; Cylinder(tube) = {-100 * radius, 0, 0, 200 * radius, 0, 0, radius};
  leaflet[] = BooleanIntersection{ Surface{wedge}; Delete; }{ Volume{tube}; Delete; };
  Rotate{{1, 0, 0}, {0, 0, 0}, k * 2 * Pi / 3} { Surface{leaflet[]}; }
  leaflets[] += leaflet[];
EndFor

blood = newv;
Cylinder(blood) = {-upstream, 0, 0, upstream + downstream, 0, 0, radius};
around[] = Abs(Boundary{ Volume{blood}; });

Physical Volume("blood") = {blood};
Physical Surface("wall") = {around[0]};  // the curved one
Physical Surface("leaflets") = {leaflets[]};
