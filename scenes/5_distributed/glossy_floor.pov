// A mirror floor in four strips, rougher from left to right. What stands on it is mirrored sharply at its foot and blurs
// with its height. Catches lobes of the wrong width, and one tilt for all rays.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 2 adc_bailout 0 }
#include "frame.inc"
View(<0, 7, -4.2>, <0, 0.2, 0.55>, 36)
camera { #ifdef (Frame) Frame_pinhole() #else location Eye direction Ahead right Across up Above #end }
background { rgb <0.35, 0.45, 0.6> }
light_source { <-3, 9, -3>, rgb 1 }
#declare Matt = finish { ambient 0.2 diffuse 0.75 }
#declare Mirror = finish { ambient 0.02 diffuse 0.15 reflection 0.75 }
#macro Strip(Left, Right, Roughness)
    #ifdef (Frame)
        union {
            Frame_facet(<Left, 0, -2.5>, <Right, 0, -2.5>, <Right, 0, 3>, <Left, 0, 3>, Frame_tilt(Frame_u11, Frame_u12, Roughness, y))
            pigment { rgb <0.6, 0.65, 0.7> } finish { Mirror }
        }
    #else
        polygon {
            5, <Left, 0, -2.5>, <Right, 0, -2.5>, <Right, 0, 3>, <Left, 0, 3>, <Left, 0, -2.5>
            pigment { rgb <0.6, 0.65, 0.7> } finish { Mirror #ifdef (Raysteps) glossy Roughness #end }
        }
    #end
#end
Strip(-2, -1, 0.0003)
Strip(-1, 0, 0.0015)
Strip(0, 1, 0.005)
Strip(1, 2, 0.01)
#for (I, 0, 3)
    box { <-1.75 + I, 0, 1.2>, <-1.25 + I, 2, 1.4> pigment { checker rgb <0.95, 0.9, 0.7>, rgb <0.7, 0.15 + 0.15*I, 0.1> scale 0.25 translate <0.01, 0.02, 0.03> } finish { Matt } }
    sphere { <-1.5 + I, 0.6, -0.2>, 0.22 pigment { rgb <0.15, 0.5, 0.9 - 0.2*I> } finish { Matt } }
#end
box { <-9, -0.6, -9>, <9, -0.5, 9> pigment { rgb <0.3, 0.28, 0.25> } finish { Matt } }
