// One oblique edge: most pixels are all white or all black, those on the edge are a share of both.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { orthographic location -5*z direction z right 2*x up 2*y }
background { rgb 0 }
box { <-9, -9, 0>, <9, 0, 1> rotate 30*z pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } }
