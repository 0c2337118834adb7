// Coloured glass: the longer the way, the deeper the colour. Left by Beer's law (fade_power 1001), right by POV-Ray's
// rational law (fade_power 2). White fade_color must take nothing away.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 10 adc_bailout 0 }
camera { location <0, 2.6, -8> right x*image_width/image_height up y angle 43 look_at <0, 0.7, 0> }
background { rgb 0.9 }
light_source { <3, 9, -5>, rgb 1 }
plane { y, 0 pigment { checker rgb 0.95, rgb 0.6 } finish { ambient 0.2 diffuse 0.8 } }
#declare Clear = texture { pigment { rgbt <1, 1, 1, 1> } finish { ambient 0 diffuse 0 specular 0.4 roughness 0.02 reflection { 0, 1 fresnel on } conserve_energy } }
#macro Glass(Power, Distance, Tint) interior { ior 1.3 fade_distance Distance fade_power Power fade_color rgb Tint } #end
sphere { <-2.4, 0.8, 0>, 0.8 texture { Clear } Glass(1001, 0.5, <0.9, 0.35, 0.2>) }
box { <-1.5, 0.02, -0.3>, <-0.4, 1.6, 0.3> texture { Clear } Glass(1001, 0.4, <0.2, 0.6, 0.9>) rotate 20*y }
sphere { <1.0, 0.8, 0.2>, 0.8 texture { Clear } Glass(2, 0.5, <0.3, 0.8, 0.3>) }
cone { <2.3, 0.02, 0>, 0.7, <2.3, 1.8, 0>, 0.1 texture { Clear } Glass(1, 0.8, <0.8, 0.2, 0.6>) }
sphere { <0.1, 0.3, -1.4>, 0.3 texture { Clear } Glass(1001, 0.1, <1, 1, 1>) }
