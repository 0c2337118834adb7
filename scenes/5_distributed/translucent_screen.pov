// A plate of ground glass, rough in front and smooth behind: what touches it is seen well, what is far from it dissolves.
// Catches refraction by the untilted normal.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 5 adc_bailout 0 }
#include "frame.inc"
View(<0, 1.7, -6>, <0, 1.25, 0>, 38)
camera { #ifdef (Frame) Frame_pinhole() #else location Eye direction Ahead right Across up Above #end }
background { rgb <0.65, 0.7, 0.75> }
light_source { <-4, 7, -4>, rgb 0.9 }
#declare Matt = finish { ambient 0.25 diffuse 0.7 }
#declare Clear = pigment { rgbt <0.95, 0.98, 0.97, 1> }
#declare Roughness = 0.01;
union {
    #ifdef (Frame)
        Frame_facet(<-1.6, 0.2, 0>, <1.2, 0.2, 0>, <1.2, 2.4, 0>, <-1.6, 2.4, 0>, Frame_tilt(Frame_u11, Frame_u12, Roughness, -z))
    #else
        polygon {
            5, <-1.6, 0.2, 0>, <1.2, 0.2, 0>, <1.2, 2.4, 0>, <-1.6, 2.4, 0>, <-1.6, 0.2, 0>
            texture { pigment { Clear } finish { ambient 0 diffuse 0 #ifdef (Raysteps) glossy Roughness #end } }
        }
    #end
    polygon { 5, <-1.6, 0.2, 0.1>, <1.2, 0.2, 0.1>, <1.2, 2.4, 0.1>, <-1.6, 2.4, 0.1>, <-1.6, 0.2, 0.1> }
    texture { pigment { Clear } finish { ambient 0 diffuse 0 } }
    interior { ior 1.5 }
}
union {
    box { <-1.75, 0, -0.05>, <-1.6, 2.55, 0.15> }
    box { <1.2, 0, -0.05>, <1.35, 2.55, 0.15> }
    box { <-1.6, 2.4, -0.05>, <1.2, 2.55, 0.15> }
    box { <-1.6, 0, -0.05>, <1.2, 0.2, 0.15> }
    pigment { rgb <0.5, 0.33, 0.18> } finish { Matt }
}
plane { y, 0 pigment { checker rgb <0.85, 0.83, 0.78>, rgb <0.62, 0.66, 0.7> scale 1.5 } finish { Matt } }
sphere { <-0.9, 0.7, 0.7>, 0.5 pigment { rgb <0.9, 0.25, 0.15> } finish { Matt } }
sphere { <0.1, 1.5, 2>, 0.5 pigment { rgb <0.95, 0.8, 0.2> } finish { Matt } }
sphere { <1.2, 0.9, 4.5>, 0.8 pigment { rgb <0.2, 0.4, 0.85> } finish { Matt } }
