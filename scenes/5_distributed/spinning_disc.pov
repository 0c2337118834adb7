// A checkered disc that turns by a right angle: still at its middle, blurred to arcs at its rim. Catches turns that are
// straight lines between two matrices (the disc would shrink), and patterns that stay behind.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 2 adc_bailout 0 }
#include "frame.inc"
View(<0.4, 2.2, -6>, <0, 1.5, 0>, 40)
camera { #ifdef (Frame) Frame_pinhole() #else location Eye direction Ahead right Across up Above #end }
background { rgb <0.7, 0.75, 0.8> }
light_source { <-4, 7, -6>, rgb 1 }
#declare Matt = finish { ambient 0.15 diffuse 0.8 }
plane { y, 0 pigment { rgb <0.7, 0.75, 0.65> } finish { Matt } }
disc { 0, z, 1.4 pigment { checker rgb <0.95, 0.9, 0.7>, rgb <0.7, 0.3, 0.3> scale 0.7 translate 0.35*z } finish { Matt }
    rotate 90*Time*z rotate -15*y translate 1.6*y }
cylinder { <0, 1.6, -0.1>, <0, 1.6, 0.4>, 0.12 pigment { rgb 0.2 } finish { Matt } }
box { <-0.12, 0, 0.4>, <0.12, 1.8, 0.6> pigment { rgb <0.35, 0.3, 0.3> } finish { Matt } }
