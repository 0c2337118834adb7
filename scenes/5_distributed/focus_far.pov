// Focus far away: only the last balls are sharp.
#version 3.7;
#declare Focus = <3.25, 0.45, 6.2>;
#include "focus.inc"
