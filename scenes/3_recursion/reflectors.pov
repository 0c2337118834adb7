// Finishes that reflect: constant, by angle (falloff), by Fresnel, metallic, with an exponent, and with energy
// conserved or not.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 8 adc_bailout 0 }
camera { location <0, 3.2, -9> right x*image_width/image_height up y angle 38 look_at <0, 0.9, 0> }
background { rgb <0.45, 0.6, 0.8> }
light_source { <-6, 9, -8>, rgb 0.9 }
plane { y, 0 pigment { checker rgb <0.95, 0.9, 0.8>, rgb <0.35, 0.1, 0.1> } finish { ambient 0.15 diffuse 0.7 reflection { 0.02, 0.4 falloff 3 } } }
#macro Ball(At, Paint) sphere { At, 0.8 pigment { color Paint } interior { ior 1.5 } finish { ambient 0.1 diffuse 0.4 #end
Ball(<-2.7, 0.8, 0>, rgb <0.9, 0.6, 0.2>) reflection { 0.7 metallic } } }
Ball(<-0.9, 0.8, 0>, rgb <0.2, 0.4, 0.8>) reflection { 0.05, 0.9 falloff 4 } } }
Ball(<0.9, 0.8, 0>, rgb <0.15, 0.5, 0.2>) reflection { 0.0, 1.0 fresnel on } conserve_energy } }
Ball(<2.7, 0.8, 0>, rgb <0.7, 0.7, 0.7>) reflection { rgb <0.3, 0.6, 0.9>, rgb <0.9, 0.6, 0.3> exponent 1.6 } } }
Ball(<-1.8, 0.8, 2.4>, rgbt <0.9, 0.9, 0.9, 0.6>) reflection { 0.5 } conserve_energy } }
Ball(<0, 2.3, 1.6>, rgb <0.8, 0.7, 0.3>) reflection { 0.3, 0.8 metallic 0.6 } } }
Ball(<1.8, 0.8, 2.4>, rgbt <0.9, 0.9, 0.9, 0.6>) reflection { 0.5 } } }
