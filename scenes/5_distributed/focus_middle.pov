// Focus on the third ball: blur on both sides. Catches lenses that are sharp on a sphere around the eye.
#version 3.7;
#declare Focus = <1, 0.45, 0.8>;
#include "focus.inc"
