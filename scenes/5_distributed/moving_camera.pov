// The camera goes to the side while the shutter is open: what is near is blurred, what is far stands still.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 2 adc_bailout 0 }
#include "frame.inc"
View(<-0.25 + 0.5*Time, 1.6, -6>, <-0.25 + 0.5*Time, 1.1, 0>, 44)
camera { #ifdef (Frame) Frame_pinhole() #else location Eye direction Ahead right Across up Above #end }
background { rgb <0.5, 0.6, 0.75> }
light_source { <-5, 8, -6>, rgb 1 }
#declare Matt = finish { ambient 0.15 diffuse 0.8 }
plane { y, 0 pigment { checker rgb <0.85, 0.85, 0.75>, rgb <0.6, 0.68, 0.6> scale 2 } finish { Matt } }
#for (I, 0, 4)
    cylinder { <-1.6 + 0.9*I, 0, -2.6 + 2.6*I>, <-1.6 + 0.9*I, 2, -2.6 + 2.6*I>, 0.2 pigment { rgb <0.9 - 0.12*I, 0.4 + 0.06*I, 0.35 + 0.12*I> } finish { Matt } }
    sphere { <-1.6 + 0.9*I, 2.1, -2.6 + 2.6*I>, 0.35 pigment { rgb <0.95, 0.8, 0.4> } finish { Matt phong 0.4 phong_size 30 } }
#end
