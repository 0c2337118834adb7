// The furnace: everything around is 1, glass loses nothing, so every pixel must be 1. Energy that a Fresnel term, a
// total reflection or a pruned branch loses or makes is seen at once.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 20 adc_bailout 0 }
camera { location <0, 1, -6> right x*image_width/image_height up y angle 42 look_at <0, 0, 0> }
background { rgb 1 }
#declare Lossless = texture { pigment { rgbt <0, 0, 0, 1> } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel on } conserve_energy } }
sphere { <-1.3, 0, 0>, 1 texture { Lossless } interior { ior 1.5 } }
box { -0.7, 0.7 texture { Lossless } interior { ior 1.5 } rotate <20, 35, 0> translate <1.1, 0.1, 0> }
sphere { <0.2, -1.1, -0.6>, 0.45 texture { Lossless } interior { ior 2.4 } }
torus { 0.5, 0.15 texture { Lossless } interior { ior 1.333 } rotate 40*x translate <0, 1.3, 0> }
