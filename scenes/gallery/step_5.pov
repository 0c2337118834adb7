// The gallery's picture of step 5: billiards under a long lamp. Soft shadows, a lens, a ball that has just been played, a rough
// mirror of lacquer, and lights that are out of focus. (R. Cook, T. Porter and L. Carpenter showed billiard balls, too, in 1984.)
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 5 adc_bailout 0.002 }
#ifndef (Time) #declare Time = 0.5; #end
camera {
    location <-0.6, 1.75, -7.6> right x*image_width/image_height up y angle 37 look_at <0.1, 0.85, 0>
    aperture 0.55 focal_point <-0.75, 0.5, -0.95> blur_samples 200
    #ifdef (Raysteps) aperture_blades 7 #end
}
background { rgb <0.006, 0.007, 0.013> }
light_source { <-1.0, 6.5, 1.2>, rgb <1.05, 0.95, 0.78> area_light 5*x, 1.3*z, 17, 17 area_illumination on }
light_source { <6, 5, -8>, rgb <0.07, 0.09, 0.14> area_light 2*x, 2*y, 9, 9 area_illumination on }

// The cloth, and a rim of lacquered wood around it.
plane { y, 0 pigment { rgb <0.03, 0.28, 0.17> } finish { ambient 0.04 diffuse 0.8 } clipped_by { box { <-7, -1, -9>, <7, 1, 5> } } }
box { <-9, -0.4, 5>, <9, 0.5, 5.8> pigment { rgb <0.32, 0.11, 0.04> }
    finish { ambient 0.03 diffuse 0.5 reflection { 0.05, 0.5 falloff 3 } #ifdef (Raysteps) glossy 0.004 #end } }
box { <-9, -0.4, 4.6>, <9, 0.36, 5> pigment { rgb <0.02, 0.2, 0.12> } finish { ambient 0.04 diffuse 0.8 } }

// The lamp, which the balls mirror.
box { <-3.5, 6.7, 0.55>, <1.5, 6.8, 1.85> no_shadow pigment { rgb <1, 0.92, 0.75> } finish { ambient 0 diffuse 0 emission 3 } }

#declare Lacquer = finish { ambient 0.035 diffuse 0.78 reflection { 0.035, 0.85 falloff 5 } }
#macro Ball(X, Z, Colour)
    sphere { <X, 0.5, Z>, 0.5 pigment { rgb Colour } finish { Lacquer } }
#end
// A triangle of ten, opened, and the one that is in focus.
Ball(-0.75, -0.95, <0.85, 0.05, 0.04>)
Ball(0.55, 0.25, <0.95, 0.62, 0.05>)
Ball(-0.9, 1.15, <0.05, 0.16, 0.55>)
Ball(1.75, 1.3, <0.36, 0.07, 0.35>)
Ball(0.35, 2.05, <0.9, 0.3, 0.04>)
Ball(-2.3, 2.4, <0.04, 0.33, 0.2>)
Ball(2.9, 2.9, <0.42, 0.06, 0.07>)
Ball(-0.85, 3.4, <0.06, 0.06, 0.07>)
Ball(1.35, 3.7, <0.85, 0.05, 0.04>)
Ball(-3.1, -0.1, <0.95, 0.62, 0.05>)
// The cue ball comes from the right; it slows down.
sphere { <2.1 - 0.5*Time*(1.35 - 0.35*Time), 0.5, -1.65 + 0.2*Time*(1.35 - 0.35*Time)>, 0.5 pigment { rgb <0.93, 0.9, 0.82> } finish { Lacquer } }
// Lights of the town, far behind.
#declare S = seed(11);
#for (I, 0, 33)
    #local C = rand(S);
    sphere { <-11 + 22*rand(S), 0.7 + 5*rand(S), 17 + 6*rand(S)>, 0.2 + 0.1*rand(S) no_shadow
        pigment { rgb <1, 0.3 + 0.6*C, 0.08 + 0.9*C*C> } finish { ambient 0 diffuse 0 emission 1.6 } }
#end
