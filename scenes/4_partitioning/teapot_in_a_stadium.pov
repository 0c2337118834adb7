// A teapot of a few thousand triangles in a stadium of a kilometre: in a grid over everything, all of it is in one cell.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "teapot.inc"
camera { location <4, 4.5, -9> right x*image_width/image_height up y angle 40 look_at <0, 1.4, 0> }
background { rgb <0.6, 0.75, 0.95> }
light_source { <-300, 500, -400>, rgb 1 }
#declare Stone = texture { pigment { rgb <0.7, 0.68, 0.62> } finish { ambient 0.2 diffuse 0.7 } }
box { <-500, -1, -500>, <500, 0, 500> pigment { checker rgb <0.35, 0.6, 0.3>, rgb <0.3, 0.5, 0.25> scale 5 } finish { ambient 0.2 diffuse 0.7 } }
#declare I = 0;
#while (I < 36)
    cylinder { <0, 0, 400>, <0, 120, 400>, 12 texture { Stone } rotate 10*I*y }
    box { <-36, 120, 385>, <36, 135, 415> texture { Stone } rotate 10*I*y }
    #declare I = I + 1;
#end
object { Teapot(8) rotate -90*x rotate 30*y pigment { rgb <0.9, 0.9, 0.85> } finish { ambient 0.15 diffuse 0.7 phong 0.4 phong_size 50 } }
