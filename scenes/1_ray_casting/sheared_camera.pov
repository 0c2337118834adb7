// A camera whose vectors are not at right angles, as for an off-axis stereo view: direction, right and up are used as
// they are. Catches a camera that rebuilds a right-angled frame of its own.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb <0.10, 0.12, 0.18> }

camera { location <1.5, 1.6, -5> direction <-0.35, -0.28, 1.15> right <1.30, 0.15, 0.20> up <-0.25, 1.0, 0.10> }
light_source { <-5, 8, -6>, rgb 1 shadowless }

#declare Plain = finish { ambient 0.15 diffuse 0.8 }

#for (I, -1, 1)
    #for (K, -1, 1)
        #if (I*I + K*K > 0)
            sphere { <1.15*I, 1.15*K, 0>, 0.42 pigment { rgb <0.55 + 0.35*I, 0.60, 0.55 + 0.35*K> } finish { Plain } }
        #end
    #end
#end
box { -0.45, 0.45 pigment { rgb <0.95, 0.85, 0.40> } finish { Plain } }
plane { z, 1.5 pigment { checker rgb 0.55, rgb 0.40 scale 0.7 translate <0.11, 0.23, 0.37> } finish { Plain } }
