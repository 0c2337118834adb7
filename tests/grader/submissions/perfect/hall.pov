// A scene of the student's own: a red ball between two mirrors that are not quite perfect.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 8 adc_bailout 0 }
camera { location <0, 1, -3.5> right x*image_width/image_height up y angle 60 look_at <0.6, 0.9, 0> }
background { rgb <0.4, 0.5, 0.7> }
light_source { <1, 4, -3>, rgb 1 }
plane { y, 0 pigment { checker rgb 0.9, rgb 0.2 } finish { ambient 0.1 diffuse 0.8 } }
sphere { <0, 0.7, 0>, 0.7 pigment { rgb <0.9, 0.1, 0.1> } finish { ambient 0.1 diffuse 0.7 phong 0.8 phong_size 30 } }
box { <-3, 0, 2>, <3, 3, 2.1> pigment { rgb 0.1 } finish { ambient 0 diffuse 0.1 reflection { 0.85 } } }
box { <-3, 0, -5.1>, <3, 3, -5> pigment { rgb 0.1 } finish { ambient 0 diffuse 0.1 reflection { 0.85 } } }
