// Glass that overlaps glass: the medium entered last counts; leaving the other one bends nothing. Straws in drinks, a
// ball half in a block, three shells.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 7 adc_bailout 0 }
camera { location <0.3, 2, -7> right x*image_width/image_height up y angle 40 look_at <0, 0.9, 0> }
background { rgb <0.75, 0.8, 0.85> }
light_source { <-5, 9, -6>, rgb 1 }
plane { y, -0.01 pigment { checker rgb <0.9, 0.85, 0.8>, rgb <0.4, 0.45, 0.5> scale 0.7 } finish { ambient 0.2 diffuse 0.7 } }
#declare Clear = texture { pigment { rgbt <1, 1, 1, 1> } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel on } conserve_energy } }
cylinder { <-2, 0.0, 0>, <-2, 2, 0>, 0.7 texture { Clear } interior { ior 1.5 } }
cylinder { <-2, 0.1, 0>, <-2, 1.6, 0>, 0.62 texture { Clear } interior { ior 1.333 } }
cylinder { <-2.2, 0.2, 0>, <-1.3, 2.7, 0.2>, 0.12 pigment { rgb <0.9, 0.2, 0.2> } finish { ambient 0.2 diffuse 0.7 } }
box { <-0.7, 0, -0.5>, <0.7, 1, 0.5> texture { Clear } interior { ior 1.3 } rotate 25*y }
sphere { <0.3, 1, -0.1>, 0.6 texture { Clear } interior { ior 1.6 } }
union {
    sphere { <2.1, 0.9, 0>, 0.9 }
    sphere { <2.1, 0.9, 0>, 0.6 }
    sphere { <2.1, 0.9, 0>, 0.3 }
    texture { Clear } interior { ior 1.4 }
}
sphere { <1.1, 0.35, -1.3>, 0.35 texture { Clear } interior { ior 1.7 } }
sphere { <1.45, 0.35, -1.3>, 0.3 texture { Clear } interior { ior 1.2 } }
