// A square light, a lens, a ball that flies and a rough mirror in one picture. Catches numbers that are drawn twice: light,
// lens, time and tilt must know nothing of each other.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 2 adc_bailout 0 }
#include "frame.inc"
View(<0, 4.6, -4.4>, <0.05, 0.45, 0>, 38)
#declare Focus = <0, 0.5, -0.4>;
camera {
    #ifdef (Frame) Frame_lens(0.5, Focus)
    #else location Eye direction Ahead right Across up Above aperture 0.5 focal_point Focus blur_samples 200 confidence 0.999 variance 0 #end
}
background { rgb <0.5, 0.6, 0.75> }
light_source {
    <-2.5, 6, -1>, rgb 1
    #ifdef (Frame) translate Frame_square(Frame_u5, Frame_u6, 1.2*x, 1.2*z) #else area_light 1.2*x, 1.2*z, 17, 17 area_illumination on #end
}
#declare Matt = finish { ambient 0.15 diffuse 0.8 }
#declare Floor = pigment { rgb <0.75, 0.7, 0.65> }
#declare Mirror = finish { ambient 0.05 diffuse 0.45 reflection 0.4 }
#ifdef (Frame)
    union {
        Frame_facet(<-8, 0, -8>, <8, 0, -8>, <8, 0, 8>, <-8, 0, 8>, Frame_tilt(Frame_u11, Frame_u12, 0.004, y))
        pigment { Floor } finish { Mirror }
    }
#else
    polygon {
        5, <-8, 0, -8>, <8, 0, -8>, <8, 0, 8>, <-8, 0, 8>, <-8, 0, -8>
        pigment { Floor } finish { Mirror #ifdef (Raysteps) glossy 0.004 #end }
    }
#end
sphere { <-1.1, 0.5, 0.2>, 0.5 pigment { rgb <0.2, 0.45, 0.8> } finish { Matt phong 0.5 phong_size 40 } }
sphere { <0.3 + 0.9*Time, 0.9 + 0.3*Time, -0.2>, 0.35 pigment { rgb <0.9, 0.45, 0.1> } finish { Matt phong 0.5 phong_size 40 } }
box { <0.3, 0, 0.9>, <1.3, 1.1, 1.4> pigment { checker rgb <0.9, 0.9, 0.8>, rgb <0.5, 0.7, 0.55> scale 0.25 translate 0.03 } finish { Matt } }
cylinder { <-0.5, 0, -1.3>, <-0.5, 0.7, -1.3>, 0.1 pigment { rgb <0.7, 0.2, 0.3> } finish { Matt } }
