// A floor under a wide light, and nothing between them: what a pixel is the mean of has no edge.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { orthographic location 5*y direction -y right 4*x up 4*z }
background { rgb 0 }
light_source { <0, 1, 0>, rgb 1 area_light 2*x, 2*z, 9, 9 area_illumination on }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
