// A shadowless lamp fills shadows: the lamp on the right goes through everything and makes no highlight. The one on the
// left throws shadows, and its white highlights are the only ones.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <1, 3.4, -8> right x*image_width/image_height up y angle 42 look_at <0.1, 0.9, 0> }
background { rgb <0.05, 0.04, 0.06> }
light_source { <-5, 6, -4>, rgb <0.8, 0.75, 0.65> }
light_source { <6, 4, -3>, rgb <0.2, 0.28, 0.4> shadowless }

plane { y, 0
    pigment { rgb <0.8, 0.8, 0.82> }
    finish { ambient 0.05 diffuse 0.8 }
}
sphere { <-0.9, 1, 0.4>, 1
    pigment { rgb <0.25, 0.55, 0.4> }
    finish { ambient 0.05 diffuse 0.7 phong 0.9 phong_size 60 }
}
cone { <1.5, 0, -0.4>, 0.8, <1.5, 2, -0.4>, 0.15
    pigment { rgb <0.75, 0.5, 0.25> }
    finish { ambient 0.05 diffuse 0.7 specular 0.7 roughness 0.03 }
}
