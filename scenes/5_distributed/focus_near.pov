// The lens is focused on the second ball: all behind it blurs, the front one as well.
#version 3.7;
#declare Focus = <0.25, 0.45, -1>;
#include "focus.inc"
