// Parallel light: the sun of a garden. The same fence under a nearby lamp would throw shadows that spread; these stay
// parallel, wherever the light's own place is.
#version 3.7;
global_settings { assumed_gamma 1.0 ambient_light rgb <0.7, 0.85, 1.1> }
camera { location <3.1, 3.4, -7.5> right x*image_width/image_height up y angle 46 look_at <0.2, 0.75, 0.6> }
background { rgb <0.45, 0.62, 0.85> }
light_source { <-4.1, 4.3, -2.8>, rgb <0.95, 0.85, 0.65> parallel point_at <-0.3, 0.9, 0> }

plane { y, 0
    pigment { rgb <0.45, 0.6, 0.3> }
    finish { ambient 0.15 diffuse 0.8 }
}
#declare I = 0;
#while (I < 9)
    box { <-3 + 0.7*I, 0, 0.3>, <-2.75 + 0.7*I, 1.15 + 0.12*mod(I, 3), 0.4>
        pigment { rgb <0.85, 0.75, 0.6> }
        finish { ambient 0.15 diffuse 0.7 }
    }
    #declare I = I + 1;
#end
box { <-3.1, 0.5, 0.42>, <3.1, 0.65, 0.5>
    pigment { rgb <0.8, 0.7, 0.55> }
    finish { ambient 0.15 diffuse 0.7 }
}
sphere { <-1.3, 0.45, -1.3>, 0.45
    pigment { rgb <0.85, 0.25, 0.15> }
    finish { ambient 0.15 diffuse 0.7 phong 0.5 phong_size 40 }
}
