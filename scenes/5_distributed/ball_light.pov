// A glowing ball among columns: from every side the light is the same disc. Catches lights that are flat.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 2 adc_bailout 0 }
#include "frame.inc"
View(<0, 5, -6.5>, <0, 0.3, -0.1>, 42)
camera { #ifdef (Frame) Frame_pinhole() #else location Eye direction Ahead right Across up Above #end }
background { rgb <0.03, 0.03, 0.06> }
light_source {
    <0, 1.3, 0>, rgb <1, 0.85, 0.6>
    #ifdef (Frame) translate Frame_ball(Frame_u5, Frame_u6, Frame_u7, 0.4)
    #else area_light 0.8*x, 0.8*y, 9, 9 circular orient area_illumination on #end
}
#declare Matt = finish { ambient 0.06 diffuse 0.85 }
plane { y, 0 pigment { rgb <0.8, 0.8, 0.85> } finish { Matt } }
sphere { <0, 1.3, 0>, 0.4 no_shadow pigment { rgb <1, 0.85, 0.6> } finish { emission 1 ambient 0 diffuse 0 } }
cylinder { <0, 0, 0>, <0, 0.5, 0>, 0.25 pigment { rgb 0.4 } finish { Matt } }
#for (I, 0, 5)
    cylinder { <1.7, 0, 0>, <1.7, 1.6, 0>, 0.2 rotate (60*I + 20)*y pigment { rgb <0.4 + 0.1*I, 0.5, 0.9 - 0.1*I> } finish { Matt phong 0.5 phong_size 30 } }
#end
sphere { <0.8, 0.25, -1.9>, 0.25 pigment { rgb <0.9, 0.3, 0.2> } finish { Matt phong 0.5 phong_size 30 } }
