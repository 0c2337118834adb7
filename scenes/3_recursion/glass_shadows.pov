// Shadows of clear things: straight, tinted by filter, untinted by transmit, deeper where two overlap, none from what
// has no_shadow.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 8 adc_bailout 0 }
camera { location <0, 6, -8> right x*image_width/image_height up y angle 40 look_at <0, 0.2, 0.6> }
background { rgb <0.6, 0.7, 0.8> }
light_source { <-3, 8, -4>, rgb <1, 0.95, 0.9> }
light_source { <7, 5, -3>, rgb <0.25, 0.3, 0.4> }
plane { y, 0 pigment { rgb 0.9 } finish { ambient 0.15 diffuse 0.75 } }
sphere { <-2.2, 0.9, 0>, 0.8 pigment { rgbf <0.9, 0.3, 0.2, 0.9> } finish { ambient 0 diffuse 0.1 phong 0.5 } interior { ior 1.5 } }
box { <-0.7, 0.1, -0.5>, <0.4, 1.5, 0.4> pigment { rgbt <0.2, 0.6, 0.9, 0.7> } finish { ambient 0.1 diffuse 0.4 } rotate 30*y }
disc { <1.8, 1.5, 0>, <-0.3, 1, 0.1>, 0.9 pigment { rgbf <0.3, 0.9, 0.4, 0.8> } finish { ambient 0.1 diffuse 0.5 } }
disc { <2.1, 0.8, 0.3>, y, 0.8 pigment { rgbf <0.9, 0.85, 0.2, 0.8> } finish { ambient 0.1 diffuse 0.5 } }
torus { 0.6, 0.2 translate <0.1, 0.25, 2.3> pigment { checker rgbf <1, 1, 1, 0.9>, rgb <0.6, 0.1, 0.5> scale 0.25 translate 0.013 } finish { ambient 0.1 diffuse 0.6 } }
sphere { <-1.8, 0.6, 2.4>, 0.6 no_shadow pigment { rgbf <0.5, 0.7, 1, 0.6> } finish { ambient 0.1 diffuse 0.4 } interior { ior 1.2 } }
cylinder { <2.6, 0, 2>, <2.6, 1.6, 2>, 0.35 pigment { rgb <0.7, 0.4, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
