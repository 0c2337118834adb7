// Glass: a ball, a ball with an air bubble in it, a ball in a ball of water, and two that touch. Whoever turns the
// index over, or forgets to flip the normal on the way out, sees the world the wrong way up.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 7 adc_bailout 0 }
camera { location <0, 2.2, -7.5> right x*image_width/image_height up y angle 40 look_at <0, 0.85, 0> }
background { rgb <0.35, 0.5, 0.75> }
light_source { <-5, 8, -6>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.9, 0.9, 0.85>, rgb <0.25, 0.3, 0.35> } finish { ambient 0.15 diffuse 0.7 } }
box { <-6, 0, 5>, <6, 1.2, 6> pigment { checker rgb <0.8, 0.3, 0.15>, rgb <0.9, 0.75, 0.3> scale 0.6 } finish { ambient 0.2 diffuse 0.7 } }

#declare Clear = texture {
    pigment { rgbt <1, 1, 1, 1> }
    finish { ambient 0 diffuse 0 specular 0.5 roughness 0.01 reflection { 0, 1 fresnel on } conserve_energy }
}
sphere { <-2.3, 0.85, 0>, 0.85 texture { Clear } interior { ior 1.5 } }
sphere { <-0.2, 1.0, 0.4>, 1.0 texture { Clear } interior { ior 1.5 } }
sphere { <-0.2, 1.0, 0.4>, 0.7 texture { Clear } interior { ior 1.0 } }
sphere { <2.0, 1.0, 0.3>, 1.0 texture { Clear } interior { ior 1.333 } }
sphere { <2.0, 1.0, 0.3>, 0.5 texture { Clear } interior { ior 1.7 } }
sphere { <0.75, 0.4, -1.6>, 0.4 texture { Clear } interior { ior 1.5 } }
sphere { <1.55, 0.4, -1.6>, 0.4 texture { Clear } interior { ior 1.333 } }
