// A shutter that is open from 0.2 to 0.6 only. The ball moves by ten stripes; it may be seen on four of them.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 2 adc_bailout 0 }
#include "frame.inc"
#ifdef (Frame) Frame_shutter(0.2, 0.6) #end
View(<0, 3.2, -6.5>, <0, 0.6, 0>, 42)
camera {
    #ifdef (Frame) Frame_pinhole() #else location Eye direction Ahead right Across up Above #end
    #ifdef (Raysteps) shutter 0.2, 0.6 #end
}
background { rgb <0.5, 0.52, 0.6> }
light_source { <-3, 9, -4>, rgb 1 }
#declare Matt = finish { ambient 0.15 diffuse 0.8 }
plane { y, 0 pigment { checker rgb <0.8, 0.8, 0.82>, rgb <0.6, 0.63, 0.7> scale <0.4, 100, 100> translate <0, 50, 50> } finish { Matt } }
sphere { <-2 + 4*Time, 0.5, -0.4>, 0.4 pigment { rgb <0.95, 0.75, 0.15> } finish { Matt phong 0.5 phong_size 40 } }
box { <-2.2, 0, 1.2>, <2.2, 0.5, 1.6> pigment { rgb <0.7, 0.25, 0.3> } finish { Matt } }
