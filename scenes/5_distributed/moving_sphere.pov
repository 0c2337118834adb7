// A ball that flies, and its shadow with it. Catches shadow rays of another time than their camera ray's, and one time
// for all rays of a pixel.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 2 adc_bailout 0 }
#include "frame.inc"
View(<0, 2.6, -7.5>, <0, 1.1, 0>, 40)
camera { #ifdef (Frame) Frame_pinhole() #else location Eye direction Ahead right Across up Above #end }
background { rgb <0.55, 0.65, 0.75> }
light_source { <-4, 8, -5>, rgb 1 }
#declare Matt = finish { ambient 0.15 diffuse 0.8 }
plane { y, 0 pigment { checker rgb <0.9, 0.86, 0.8>, rgb <0.66, 0.7, 0.66> scale 1.5 translate 0.75*x } finish { Matt } }
sphere { <-1.3 + 2.6*Time, 1 + 4*Time*(1 - Time), 0>, 0.55 pigment { rgb <0.9, 0.45, 0.1> } finish { Matt phong 0.6 phong_size 40 } }
cylinder { <-2.2, 0, 0.6>, <-2.2, 1.4, 0.6>, 0.25 pigment { rgb <0.3, 0.35, 0.7> } finish { Matt } }
box { <1.9, 0, -0.3>, <2.7, 0.9, 0.5> pigment { rgb <0.35, 0.6, 0.35> } finish { Matt } }
