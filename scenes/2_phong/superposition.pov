// Light adds up: red, green and blue lamps make white where all three arrive, and six colours where one or two are
// blocked. A renderer that keeps only the last lamp shows one colour.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.7, 5.2, -6.5> right x*image_width/image_height up y angle 45 look_at <0, 0.35, 0.3> }
light_source { <-2.4, 6, -1.5>, rgb <0.85, 0, 0> }
light_source { < 2.4, 6, -1.5>, rgb <0, 0.85, 0> }
light_source { < 0,   6,  3.2>, rgb <0, 0, 0.85> }

plane { y, 0
    pigment { rgb 1 }
    finish { ambient 0.02 diffuse 0.8 }
}
sphere { <0.1, 1.4, 0.2>, 0.75
    pigment { rgb 1 }
    finish { ambient 0.02 diffuse 0.7 phong 0.4 phong_size 60 }
}
box { <-2.6, 0, 1.4>, <-1.9, 1.1, 1.9>
    pigment { rgb <1, 0.95, 0.8> }
    finish { ambient 0.02 diffuse 0.8 }
}
