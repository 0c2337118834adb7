// Small lamps out of focus show the shape of the aperture: six blades, the first corner up. The lamp in the plane of focus
// is a point. Catches lenses that are squares or whose points crowd in the middle.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 2 adc_bailout 0 }
#include "frame.inc"
View(<0, 1.5, -6>, <0, 1.3, 0>, 42)
#declare Focus = Eye + 4*Ahead;
camera {
    #ifdef (Frame) Frame_blades(1.6, 6, Focus)
    #else location Eye direction Ahead right Across up Above aperture 1.6 focal_point Focus blur_samples 200 confidence 0.999 variance 0 #end
    #ifdef (Raysteps) aperture_blades 6 #end
}
background { rgb <0.2, 0.22, 0.32> }
light_source { <-4, 6, -6>, rgb 1.1 }
#declare Matt = finish { ambient 0.1 diffuse 0.8 }
#declare Lamp = finish { emission 1 ambient 0 diffuse 0 }
plane { y, 0 pigment { rgb <0.5, 0.5, 0.55> } finish { Matt } }
sphere { <-0.9, 0.45, -2>, 0.45 pigment { rgb <0.7, 0.6, 0.5> } finish { Matt phong 0.5 phong_size 40 } }
sphere { <0.15, 0.8, -2>, 0.12 pigment { rgb 1 } finish { Lamp } }
cylinder { <0.15, 0, -2>, <0.15, 0.7, -2>, 0.05 pigment { rgb 0.3 } finish { Matt } }
#for (I, 0, 5)
    sphere { <-4.2 + 1.7*I, 1.9 + 0.9*sin(2.2*I), 4 + 0.5*mod(I*3, 5)>, 0.3
        pigment { rgb <1.5 - 0.15*I, 0.8 + 0.1*mod(I, 3), 0.5 + 0.2*I> } finish { Lamp } }
#end
