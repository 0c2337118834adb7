// Shells within shells, open in front: every box contains all smaller ones, so an octree that splits as long as there
// is something to split never ends.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <3.5, 3, -5> right x*image_width/image_height up y angle 40 look_at <0, 0, 0> }
background { rgb <0.15, 0.2, 0.3> }
light_source { <-3, 8, -9>, rgb 1 }
#declare I = 1;
#while (I <= 300)
    sphere {
        0, 0.4 + 1.3*I/300
        clipped_by { plane { <1, 0.2, -0.4>, 0.3 - I/300 } }
        pigment { rgb <0.5 + 0.5*sin(I/3), 0.5 + 0.5*sin(I/3 + 2), 0.5 + 0.5*sin(I/3 + 4)> } finish { ambient 0.2 diffuse 0.7 }
    }
    #declare I = I + 1;
#end
