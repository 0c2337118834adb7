// Nothing but edges: tiles up to the horizon and thin rods. A pixel is the mean over its square. Catches samples that are
// half a pixel off, and squares filled unevenly.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 2 adc_bailout 0 }
#include "frame.inc"
View(<0.3, 1.2, -5>, <0, 0.9, 0>, 45)
camera { #ifdef (Frame) Frame_pinhole() #else location Eye direction Ahead right Across up Above #end }
background { rgb <0.45, 0.65, 0.9> }
light_source { <-5, 8, -6>, rgb 1 shadowless }
#declare Matt = finish { ambient 0.2 diffuse 0.8 }
box { <-30, -0.1, -6>, <30, 0, 24> pigment { checker rgb <0.95, 0.93, 0.85>, rgb <0.45, 0.47, 0.55> translate <0.01, 0.5, 0.01> } finish { Matt } }
#for (I, 0, 6)
    cylinder { <-1.8 + 0.55*I, 0.1, 0>, <-1.5 + 0.45*I, 2.2, 0.3*I>, 0.012 + 0.006*I pigment { rgb <0.85, 0.2 + 0.1*I, 0.1> } finish { Matt } }
#end
sphere { <1.9, 0.6, 1>, 0.6 pigment { rgb <0.9, 0.75, 0.3> } finish { Matt } }
