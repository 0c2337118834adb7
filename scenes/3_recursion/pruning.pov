// adc_bailout 0.08 cuts every branch that carries less than 8 % of its pixel: visible steps in the mirrors, and the
// reason why the default is 1/255.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 20 adc_bailout 0.08 }
camera { location <-0.4, 1.5, -4.4> right x*image_width/image_height up y angle 50 look_at <0, 0.8, 0> }
background { rgb <0.3, 0.4, 0.6> }
light_source { <-3, 7, -4>, rgb 1 }
#declare Half = finish { ambient 0.1 diffuse 0.5 reflection { 0.5 } }
plane { y, 0 pigment { checker rgb <0.9, 0.9, 0.8>, rgb <0.2, 0.3, 0.2> } finish { Half } }
sphere { <-0.85, 0.8, 0>, 0.8 pigment { rgb <0.8, 0.3, 0.2> } finish { Half } }
sphere { <0.85, 0.8, 0>, 0.8 pigment { rgb <0.2, 0.4, 0.8> } finish { Half } }
sphere { <0, 2.1, 0.2>, 0.7 pigment { rgbt <0.8, 0.9, 0.8, 0.5> } finish { ambient 0.1 diffuse 0.4 reflection { 0.2 } } interior { ior 1.4 } }
