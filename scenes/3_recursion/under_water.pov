// A fish's view: the camera is in the water. Above, all of the sky is within 48.6 degrees of the zenith; beyond, the
// surface is a perfect mirror of what lies below.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 12 adc_bailout 0 }
camera { location <0, -2, -4> right x*image_width/image_height up y angle 75 look_at <0, -0.6, 0> }
background { rgb <0.55, 0.7, 0.95> }
light_source { <-4, 10, -2>, rgb 1 }
box { <-12, -4, -12>, <12, 0, 12>
    pigment { rgbt <1, 1, 1, 1> } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel on } conserve_energy }
    interior { ior 1.333 fade_distance 6 fade_power 1001 fade_color rgb <0.5, 0.85, 0.95> }
}
plane { y, -3.5 pigment { checker rgb <0.9, 0.8, 0.55>, rgb <0.5, 0.4, 0.25> } finish { ambient 0.4 diffuse 0.6 } }
sphere { <-1.6, -2.2, 1.5>, 0.8 pigment { rgb <0.9, 0.3, 0.1> } finish { ambient 0.2 diffuse 0.7 phong 0.4 } }
cylinder { <1.4, -3.5, 1>, <1.4, 3, 1.5>, 0.3 pigment { rgb <0.2, 0.5, 0.25> } finish { ambient 0.2 diffuse 0.7 } }
torus { 0.7, 0.22 rotate 70*x translate <0.3, -1.4, 0> pigment { rgb <0.7, 0.65, 0.9> } finish { ambient 0.2 diffuse 0.5 reflection { 0.3 } } }
sphere { <-2.5, 2.2, 6>, 1.4 pigment { rgb <0.95, 0.9, 0.3> } finish { ambient 0.3 diffuse 0.7 } }
