// A slab moves the stripes behind it sideways by t sin(a) (1 - cos(a) / sqrt(n^2 - sin(a)^2)); a prism bends them, and
// beyond the critical angle it is a mirror.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 12 adc_bailout 0 }
camera { orthographic location <0, 1, -10> right 8*x*image_width/image_height/1.3333333 up 6*y direction z }
background { rgb <0.1, 0.12, 0.16> }
light_source { <-4, 8, -10>, rgb 1 shadowless }
box { <-9, -9, 6>, <9, 9, 6.2> pigment { checker rgb <0.95, 0.9, 0.8>, rgb <0.15, 0.3, 0.5> scale <0.5, 1, 1> translate <0.01, 0.02, 0.1> } finish { ambient 0.5 diffuse 0.5 } }
#declare Clear = texture { pigment { rgbt <1, 1, 1, 1> } finish { ambient 0 diffuse 0 } }
box { <-1.2, -1, -0.75>, <1.2, 1, 0.75> texture { Clear } interior { ior 1.5 } rotate 40*y translate <-1.9, 1.9, 0> }
mesh2 {
    vertex_vectors { 6, <-1, 0, -0.9>, <1, 0, -0.9>, <0, 0, 0.9>, <-1, 1.8, -0.9>, <1, 1.8, -0.9>, <0, 1.8, 0.9> }
    face_indices { 8, <0, 2, 1>, <3, 4, 5>, <0, 1, 4>, <0, 4, 3>, <1, 2, 5>, <1, 5, 4>, <2, 0, 3>, <2, 3, 5> }
    texture { Clear } interior { ior 1.5168 } rotate 18*y translate <1.9, 1.2, 0>
}
cylinder { <-3.4, -0.6, 0>, <3.4, -0.6, 0>, 0.7 texture { Clear } interior { ior 1.45 } }
