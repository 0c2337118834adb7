// A round light behind a grille: the shadow of every bar is the light's disc cut by two lines. Catches discs whose points
// crowd in the middle.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 2 adc_bailout 0 }
#include "frame.inc"
View(<0.8, 4.6, -6.5>, <0.5, 0.5, 0.4>, 44)
camera { #ifdef (Frame) Frame_pinhole() #else location Eye direction Ahead right Across up Above #end }
background { rgb <0.3, 0.3, 0.35> }
light_source {
    <-2, 5, 4.5>, rgb <1, 0.95, 0.85>
    #ifdef (Frame) translate Frame_ellipse(Frame_u5, Frame_u6, 1.4*x, 1.4*vnormalize(<0, 0.7, 0.7>))
    #else area_light 1.4*x, 1.4*vnormalize(<0, 0.7, 0.7>), 17, 17 circular area_illumination on #end
}
#declare Matt = finish { ambient 0.1 diffuse 0.85 }
plane { y, 0 pigment { checker rgb <0.95, 0.9, 0.8>, rgb <0.75, 0.68, 0.6> scale 1.5 } finish { Matt } }
union {
    #for (I, -3, 3)
        cylinder { <0.7*I, 0, 1.8>, <0.7*I, 2.4, 1.8>, 0.12 }
    #end
    cylinder { <-2.4, 2.4, 1.8>, <2.4, 2.4, 1.8>, 0.14 }
    pigment { rgb <0.6, 0.42, 0.25> } finish { Matt }
}
sphere { <1.4, 0.5, -0.6>, 0.5 pigment { rgb <0.2, 0.5, 0.6> } finish { Matt phong 0.5 phong_size 40 } }
