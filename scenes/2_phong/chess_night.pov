// Everything of this step at once: a chess board at night. A warm spotlight that fades, moonlight in parallel rays, a
// shadowless fill, plastic, metal, checkers, shadows, a lamp that glows.
#version 3.7;
global_settings { assumed_gamma 1.0 ambient_light rgb <0.75, 0.85, 1.1> }
camera { location <-3.6, 4.4, -8.4> right x*image_width/image_height up y angle 40 look_at <0.15, 0.95, 0> }
background { rgb <0.012, 0.016, 0.035> }
light_source { <2.4, 3.7, 1.6>, rgb <1.9, 1.4, 0.8> spotlight radius 24 falloff 60 tightness 2 point_at <0.2, 0, -0.3>
    fade_distance 4 fade_power 2 }
light_source { <-8, 7, -3>, rgb <0.12, 0.17, 0.3> parallel point_at <0, 0, 0> }
light_source { <3, 6, -9>, rgb 0.05 shadowless }

#declare Plastic = finish { ambient 0.08 diffuse 0.6 specular 0.55 roughness 0.015 }
#declare Brass = finish { ambient 0.08 diffuse 0.4 phong 0.9 phong_size 35 metallic }

box { <-4, -0.35, -4>, <4, 0, 4>
    pigment { checker rgb <0.85, 0.78, 0.62> rgb <0.22, 0.13, 0.09> translate 0.001*y }
    finish { ambient 0.08 diffuse 0.7 }
}
plane { y, -0.35
    pigment { rgb <0.16, 0.2, 0.22> }
    finish { ambient 0.08 diffuse 0.6 }
}
#macro Pawn(X, Z, Paint, Coat)
    union {
        cylinder { <0, 0, 0>, <0, 0.14, 0>, 0.36 }
        cone { <0, 0.14, 0>, 0.28, <0, 0.78, 0>, 0.12 }
        torus { 0.13, 0.06 translate 0.78*y }
        sphere { <0, 1.0, 0>, 0.22 }
        pigment { rgb Paint }
        finish { Coat }
        translate <X, 0, Z>
    }
#end
#macro King(X, Z, Paint, Coat)
    union {
        cylinder { <0, 0, 0>, <0, 0.2, 0>, 0.44 }
        cone { <0, 0.2, 0>, 0.34, <0, 1.3, 0>, 0.17 }
        torus { 0.2, 0.07 translate 1.3*y }
        cone { <0, 1.3, 0>, 0.17, <0, 1.75, 0>, 0.32 }
        box { <-0.05, 1.75, -0.05>, <0.05, 2.15, 0.05> }
        box { <-0.15, 1.9, -0.05>, <0.15, 2, 0.05> }
        pigment { rgb Paint }
        finish { Coat }
        rotate 25*y
        translate <X, 0, Z>
    }
#end
#declare Ivory = <0.9, 0.86, 0.74>;
#declare Gold = <0.85, 0.55, 0.18>;
King(0.5, 0.5, Gold, Brass)
Pawn(-0.5, -0.5, Ivory, Plastic)
Pawn(1.5, -0.5, Ivory, Plastic)
Pawn(-1.5, 1.5, Gold, Brass)
Pawn(-2.5, -1.5, Ivory, Plastic)
Pawn(2.5, 2.5, Gold, Brass)
King(-1.5, -2.5, Ivory, Plastic)
sphere { <2.4, 3.7, 1.6>, 0.2
    pigment { rgb <1, 0.85, 0.55> }
    finish { ambient 0 diffuse 0 emission 1 }
    no_shadow
}
