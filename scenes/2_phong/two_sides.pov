// Both sides of thin things: the normal is turned to the viewer, and light from the other side does not come through. The
// lamp hangs above and behind: the yellow screen is seen on its lit side, disc, triangle and bowl on their dark ones.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.4, 2.7, -9> right x*image_width/image_height up y angle 46 look_at <0.1, 0.9, 0> }
background { rgb <0.1, 0.1, 0.12> }
light_source { <-3, 5, 3.5>, rgb 0.95 }

plane { y, 0
    pigment { rgb <0.6, 0.62, 0.6> }
    finish { ambient 0.1 diffuse 0.7 }
}
polygon { 5, <-1, 0>, <1, 0>, <0.8, 1.9>, <-0.6, 1.6>, <-1, 0>
    rotate 62*y
    translate <2.3, 0, -0.2>
    pigment { rgb <0.85, 0.75, 0.3> }
    finish { ambient 0.1 diffuse 0.7 phong 0.5 phong_size 20 }
}
triangle { <-1.2, 0, 0>, <1.1, 0, 0.3>, <0.1, 2, 0.5>
    translate <-0.2, 0, 0.6>
    pigment { rgb <0.35, 0.65, 0.8> }
    finish { ambient 0.1 diffuse 0.7 phong 0.5 phong_size 20 }
}
disc { <-2.6, 1, 0.2>, <0.8, 0.35, 0.6>, 0.95, 0.35
    pigment { rgb <0.8, 0.4, 0.45> }
    finish { ambient 0.1 diffuse 0.7 phong 0.5 phong_size 20 }
}
sphere { <0.9, 0.45, -1.6>, 0.45
    clipped_by { plane { <0.35, 0.8, -0.35>, 1.3 } }
    pigment { rgb <0.6, 0.8, 0.45> }
    finish { ambient 0.1 diffuse 0.7 }
}
