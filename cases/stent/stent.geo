// A coronary artery along x with a stent: a row of rings at its wall, joined by two bars on opposite sides.
// All lengths in metres.
//
//   wall  ----------------[=]====[=]====[=]====[=]-----------   [=] strut: size `width` along x, `strut` into the blood,
//                         [=]    [=]    [=]    [=]                  `embedded` into the wall
//                        |<---->|  pitch
//   axis  ..............|<- first: position of the first strut
//
//   |<------------------------- length --------------------->|     periodic: the two ends are unnamed
//
// The blood is the whole lumen, including the volume of the stent: solids take precedence. In the cross-section, share = 1
// is the whole artery, 2 the half z > 0, 4 the quarter y, z > 0; the stent is always complete, also beyond the planes of
// symmetry. The bars lie at y = 0, so the plane z = 0 cuts only rings: the stent of two-dimensional models.

SetFactory("OpenCASCADE");

DefineConstant[
  radius   = {1.5e-3, Name "radius"},
  length   = {24e-3,  Name "length"},
  struts   = {4,      Name "struts"},
  strut    = {3e-4,   Name "strut"},
  width    = {3e-4,   Name "width"},
  embedded = {1.5e-4, Name "embedded"},
  pitch    = {1.2e-3, Name "pitch"},
  first    = {16e-3,  Name "first"},
  share    = {1,      Name "share"}
];

If (radius <= 0 || strut <= 0 || width <= 0 || embedded <= 0)
  Error("radius, strut, width and embedded must be positive");
  Abort;
EndIf
If (strut >= radius)
  Error("strut must be less than radius");
  Abort;
EndIf
If (struts < 1 || struts != Floor(struts))
  Error("struts must be a whole number of 1 or more");
  Abort;
EndIf
If (struts > 1 && pitch <= width)
  Error("pitch must exceed width");
  Abort;
EndIf
last = first + (struts - 1) * pitch + width;  // end of the stent
If (first < 0 || last > length)
  Error("the stent does not fit between 0 and length");
  Abort;
EndIf
If (share != 1 && share != 2 && share != 4)
  Error("share must be 1, 2 or 4");
  Abort;
EndIf

outer = radius + embedded;
inner = radius - strut;

// Constructed along z, then rotated: z becomes x, x becomes y, y becomes z.
rings[] = {};
For k In {0:struts - 1}
  disc = newv;
  Cylinder(disc) = {0, 0, first + k * pitch, 0, 0, width, outer};
  hole = newv;
  Cylinder(hole) = {0, 0, first + k * pitch, 0, 0, width, inner};
  rings[] += BooleanDifference{ Volume{disc}; Delete; }{ Volume{hole}; Delete; };
EndFor
stent[] = rings[];
If (struts > 1)
  disc = newv;
  Cylinder(disc) = {0, 0, first, 0, 0, last - first, outer};
  hole = newv;
  Cylinder(hole) = {0, 0, first, 0, 0, last - first, inner};
  slice = newv;
  Box(slice) = {-width / 2, -2 * outer, first, width, 4 * outer, last - first};
  tube[] = BooleanDifference{ Volume{disc}; Delete; }{ Volume{hole}; Delete; };
  bars[] = BooleanIntersection{ Volume{tube[]}; Delete; }{ Volume{slice}; Delete; };
  stent[] = BooleanUnion{ Volume{rings[]}; Delete; }{ Volume{bars[]}; Delete; };
EndIf
blood = newv;
Cylinder(blood) = {0, 0, 0, 0, 0, length, radius, 2 * Pi / share};
Rotate{{1, 1, 1}, {0, 0, 0}, 2 * Pi / 3} { Volume{blood, stent[]}; }
around[] = Abs(Boundary{ Volume{blood}; });

Physical Volume("blood") = {blood};
Physical Volume("stent") = {stent[]};
Physical Surface("wall") = {around[0]};  // the curved one
