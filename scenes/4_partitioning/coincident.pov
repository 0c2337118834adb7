// A thousand spheres in one place: no cut tells them apart, and the first of them is seen.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1.5, -5> right x*image_width/image_height up y angle 40 look_at <0, 0, 0> }
background { rgb <0.2, 0.25, 0.35> }
light_source { <-4, 7, -6>, rgb 1 }
#declare I = 0;
#while (I < 1000)
    sphere { <0.1, 0.05, 0>, 1 pigment { rgb <1 - I/1000, 0.3, I/1000> } finish { ambient 0.1 diffuse 0.7 phong 0.5 } }
    #declare I = I + 1;
#end
