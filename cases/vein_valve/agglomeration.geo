// The valve of vein_valve.geo, and on the sinus's side of its lower leaflet a seed of an aggregate: a square with
// the leaflet's direction, whose middle is at the distance seed_at from the root along the leaflet.
//
//             root     ....----'' tip
//                  ''' ==              seed_offset from the leaflet's middle line
//
Include "vein_valve.geo";

DefineConstant[
  seed_at     = {0.0095, Name "seed_at"},
  seed_offset = {0.0008, Name "seed_offset"},   // so that rows beside it are one spacing apart
  seed_size   = {0.0008, Name "seed_size"}      // 5 or 6 particles at 0.4 and 0.56 mm
];

along_x = (tip_x + corner) / leaflet_length;    // direction of the lower leaflet, from root to tip
along_y = rise / leaflet_length;
middle_x = -corner + seed_at * along_x + seed_offset * along_y;
middle_y = -half_width + seed_at * along_y - seed_offset * along_x;

ux = seed_size / 2 * along_x;
uy = seed_size / 2 * along_y;
Point(50) = {middle_x - ux + uy, middle_y - uy - ux, 0};
Point(51) = {middle_x + ux + uy, middle_y + uy - ux, 0};
Point(52) = {middle_x + ux - uy, middle_y + uy + ux, 0};
Point(53) = {middle_x - ux - uy, middle_y - uy + ux, 0};
Line(50) = {50, 51};
Line(51) = {51, 52};
Line(52) = {52, 53};
Line(53) = {53, 50};
Curve Loop(50) = {50, 51, 52, 53};
Plane Surface(50) = {50};
Physical Surface("seed") = {50};
