// A straight channel, periodic in x, of two layers that meet at y = lower. All lengths in metres.

SetFactory("OpenCASCADE");

DefineConstant[
  lower  = {0.5e-3, Name "lower"},
  upper  = {0.5e-3, Name "upper"},
  length = {4e-4, Name "length"}
];

If (lower <= 0 || upper <= 0 || length <= 0)
  Error("lower, upper and length must be positive");
  Abort;
EndIf

Rectangle(1) = {0, 0, 0, length, lower};
Rectangle(2) = {0, lower, 0, length, upper};
Coherence;

tiny = 1e-3 * length;
bottom() = Curve In BoundingBox{-tiny, -tiny, -1, length + tiny, tiny, 1};
top() = Curve In BoundingBox{-tiny, lower + upper - tiny, -1, length + tiny, lower + upper + tiny, 1};
Physical Surface("lower") = {1};
Physical Surface("upper") = {2};
Physical Curve("wall") = {bottom(), top()};
