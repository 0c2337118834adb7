// The gallery's picture of step 3: clear, coloured and hollow glass, mirrors, and the two bright panels of a studio, which are
// seen in all of them.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 12 adc_bailout 0.002 }
camera { location <0, 2.6, -10> right x*image_width/image_height up y angle 50 look_at <0, 1.45, 0> }
background { rgb <0.035, 0.045, 0.07> }
light_source { <-6, 9, -5>, rgb 0.85 }
light_source { <7, 6, -6>, rgb <0.2, 0.24, 0.3> shadowless }
#declare Panel = texture { pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1.15 } }
box { <-9, 2, -4>, <-8.9, 9, 3> texture { Panel } no_shadow }
box { <8.9, 1, -2>, <9, 7, 1> texture { Panel } no_shadow }
box { <-3, 9.6, -3>, <3, 9.7, 4> texture { Panel } no_shadow }

// A dark, polished floor and a far wall in the light of the panels.
plane { y, 0 pigment { checker rgb <0.62, 0.57, 0.5>, rgb <0.05, 0.06, 0.085> rotate 45*y } finish { ambient 0.04 diffuse 0.62 reflection { 0.04, 0.45 falloff 4 } } }
plane { -z, -13 pigment { rgb <0.05, 0.13, 0.22> } finish { ambient 0.3 diffuse 0.7 } }

#declare Polish = finish { ambient 0 diffuse 0 specular 0.8 roughness 0.001 reflection { 0, 1 fresnel on } conserve_energy }
#declare Clear = texture { pigment { rgbt <1, 1, 1, 1> } finish { Polish } }
#declare Chrome = texture { pigment { rgb <0.85, 0.87, 0.9> } finish { ambient 0 diffuse 0.06 specular 0.7 roughness 0.001 reflection { 0.82 } } }
#declare Gold = texture { pigment { rgb <1, 0.68, 0.26> } finish { ambient 0.02 diffuse 0.12 specular 0.7 roughness 0.003 metallic reflection { 0.72 metallic } } }
#macro Tinted(Colour) material { texture { Clear } interior { ior 1.5 fade_distance 0.4 fade_power 1001 fade_color Colour } } #end

// In the middle a ball of clear glass with a ruby in it, on a ring of gold.
union {
    sphere { <0, 1.55, 0>, 1.4 material { texture { Clear } interior { ior 1.5 } } }
    sphere { <0, 1.55, 0>, 0.5 Tinted(rgb <0.95, 0.03, 0.06>) }
}
torus { 0.8, 0.16 translate <0, 0.14, 0> texture { Gold } }
// Mirrors on either side.
sphere { <-2.75, 1.2, 1.7>, 1.2 texture { Chrome } }
sphere { <2.8, 1.0, 1.5>, 1.0 texture { Gold } }
// Coloured glass in front of them, and a bubble.
sphere { <-2.15, 0.55, -1.9>, 0.55 Tinted(rgb <0.12, 0.5, 0.95>) }
sphere { <2.1, 0.6, -1.6>, 0.6 Tinted(rgb <0.2, 0.85, 0.4>) }
sphere { <0.95, 0.34, -2.6>, 0.34 Tinted(rgb <0.98, 0.55, 0.08>) }
union {
    sphere { <-0.75, 0.42, -2.65>, 0.42 material { texture { Clear } interior { ior 1.5 } } }
    sphere { <-0.75, 0.42, -2.65>, 0.38 material { texture { Clear } interior { ior 1 } } }
}
// A block of green glass that stands behind, and a rod.
box { <-0.55, 0, -0.16>, <0.55, 2.9, 0.16> rotate 24*y translate <4.15, 0, 0.9> Tinted(rgb <0.35, 0.8, 0.75>) }
cylinder { <-4.35, 0, 0.9>, <-4.35, 2.7, 0.9>, 0.34 Tinted(rgb <0.85, 0.55, 0.95>) }
// Matt things, so that the mirrors have something to show.
#for (I, 0, 6)
    sphere { <-6 + 2*I, 0.6 + 0.35*mod(I, 3), 5.5 + 0.8*mod(I, 2)>, 0.6 + 0.35*mod(I, 3)
        pigment { rgb <0.85 - 0.13*I, 0.1 + 0.05*mod(2*I, 5), 0.06 + 0.1*I> } finish { ambient 0.08 diffuse 0.75 } }
#end
