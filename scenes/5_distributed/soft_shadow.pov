// A square light: the shadow of the plate just above the floor is sharp, that of the ball far above it is soft. The edge
// of a penumbra is as wide as the light times (occluder to floor) / (light to occluder).
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 2 adc_bailout 0 }
#include "frame.inc"
View(<0, 4.2, -7.5>, <0, 0.7, 0.2>, 42)
camera { #ifdef (Frame) Frame_pinhole() #else location Eye direction Ahead right Across up Above #end }
background { rgb <0.55, 0.7, 0.9> }
light_source {
    <-2.4, 6, -2>, rgb 1
    #ifdef (Frame) translate Frame_square(Frame_u5, Frame_u6, 1.6*x, 1.6*z) #else area_light 1.6*x, 1.6*z, 17, 17 area_illumination on #end
}
#declare Matt = finish { ambient 0.12 diffuse 0.85 }
plane { y, 0 pigment { rgb <0.9, 0.87, 0.8> } finish { Matt } }
box { <-2.6, 0.25, -1.6>, <-0.8, 0.35, 0.2> pigment { rgb <0.25, 0.5, 0.35> } finish { Matt } }
sphere { <0.1, 2.6, 0.3>, 0.6 pigment { rgb <0.85, 0.35, 0.2> } finish { Matt phong 0.4 phong_size 30 } }
cylinder { <2.2, 0, -0.6>, <2.2, 1.8, -0.6>, 0.18 pigment { rgb <0.3, 0.4, 0.75> } finish { Matt } }
