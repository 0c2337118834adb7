// Checkers are cut from space: cubes of two colours, moved with the thing that wears them. A floor at a whole height, a
// ball and a box carved out of the grid, a turned and squeezed pattern, and coordinates below zero.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <-1.6, 4, -8.5> right x*image_width/image_height up y angle 46 look_at <0.1, 0.5, 0.3> }
background { rgb <0.5, 0.55, 0.6> }
light_source { <-6, 9, -8>, rgb 0.9 }

box { <-4.4, -1.3, -3>, <4.4, -1, 4>
    pigment { checker rgb <0.9, 0.88, 0.8> rgb <0.2, 0.24, 0.3> }
    finish { ambient 0.15 diffuse 0.75 }
}
sphere { <-2, 0.2, 0.2>, 1.2
    pigment { checker rgb <0.9, 0.3, 0.2> rgb <0.95, 0.9, 0.85> scale 0.6 }
    finish { ambient 0.15 diffuse 0.75 phong 0.3 phong_size 30 }
}
box { -0.9, 0.9
    pigment { checker rgb <0.2, 0.5, 0.75> rgb <0.9, 0.9, 0.95> scale <0.3, 0.9, 0.45> rotate 30*z }
    finish { ambient 0.15 diffuse 0.75 }
    rotate <0, 35, 0>
    translate <1.2, -0.1, 0.6>
}
cylinder { <0, 0, 0>, <0, 1.7, 0>, 0.45
    pigment { checker rgb <0.3, 0.6, 0.25> rgb <0.95, 0.93, 0.7> scale 0.4 translate <0.1, 0.05, 0.2> }
    finish { ambient 0.15 diffuse 0.75 }
    rotate 12*z
    translate <2.9, -1, -0.9>
}
