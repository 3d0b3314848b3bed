SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 0, 4, 0, 0, 1};
Physical Volume("blood") = {1};
