// A carpet of cilia on a membrane, with periciliary liquid between them and mucus above. All lengths in metres.
//
//   ____________________________________________  y = pcl + mucus: a plane of symmetry, unnamed
//                     mucus
//   ____________________________________________  pcl
//     |   |   |   |   |   |   |   |   |   |   |     cilia, pitch = length / cilia; the first is half a pitch from the end
//     |   |   |   |  pcl  |   |   |   |   |   |
//   __|___|___|___|___|___|___|___|___|___|___|_  membrane, y = 0
//
//   |<---------------- length ---------------->|    periodic: the two end lines are unnamed

DefineConstant[
  length        = {20e-6, Name "length"},
  pcl           = {5e-6,  Name "pcl"},            // depth of the periciliary liquid
  mucus         = {2e-6,  Name "mucus"},          // depth of the mucus
  cilia         = {36,    Name "cilia"},          // number of cilia
  cilium_length = {5e-6,  Name "cilium_length"}
];

If (length <= 0 || pcl <= 0 || mucus <= 0 || cilium_length <= 0)
  Error("length, pcl, mucus and cilium_length must be positive");
  Abort;
EndIf
If (cilia < 1 || cilia != Floor(cilia))
  Error("cilia must be a whole number, at least 1");
  Abort;
EndIf
If (cilium_length >= pcl + mucus)
  Error("cilium_length must be below pcl + mucus");
  Abort;
EndIf

Point(1) = {0, 0, 0};
Point(2) = {length, 0, 0};
Point(3) = {length, pcl, 0};
Point(4) = {length, pcl + mucus, 0};
Point(5) = {0, pcl + mucus, 0};
Point(6) = {0, pcl, 0};
Line(1) = {1, 2};  // membrane
Line(2) = {2, 3};
Line(3) = {3, 6};  // interface of the two fluids
Line(4) = {6, 1};
Line(5) = {3, 4};
Line(6) = {4, 5};
Line(7) = {5, 6};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Curve Loop(2) = {-3, 5, 6, 7};
Plane Surface(2) = {2};

// Cilia, from root to tip.
For k In {0:cilia - 1}
  x = (k + 0.5) * length / cilia;
  Point(1000 + k) = {x, 0, 0};
  Point(2000 + k) = {x, cilium_length, 0};
  Line(1000 + k) = {1000 + k, 2000 + k};
EndFor

Physical Surface("pcl") = {1};
Physical Surface("mucus") = {2};
Physical Curve("membrane") = {1};
Physical Curve("cilia") = {1000:999 + cilia};
Physical Point("roots") = {1000:999 + cilia};
