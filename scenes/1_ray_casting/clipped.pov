// clipped_by takes away what lies outside of a box, a ball or a half-space, and what is behind shows: the inner walls
// and other objects. Catches clipping that hides the rest of the ray, and inverse ignored.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb <0.09, 0.10, 0.15> }

camera { location <0.5, 2.6, -8> right x*4/3 up y look_at <0.25, -0.1, 0> angle 50 }
light_source { <-5, 9, -8>, rgb 1 shadowless }

#declare Plain = finish { ambient 0.15 diffuse 0.8 }

// A bowl: the lower part of a ball, with a smaller ball in it.
sphere { 0, 1.2 clipped_by { plane { <0.15, 1, -0.1>, 0.25 } } translate <-2.2, 0.6, 0> pigment { rgb <0.90, 0.55, 0.30> } finish { Plain } }
sphere { <-2.2, 0.1, 0>, 0.5 pigment { rgb <0.95, 0.90, 0.75> } finish { Plain } }
// A ball with windows: two clips in a row.
sphere { 0, 1.15 clipped_by { box { <-2, -0.85, -2>, <2, 0.85, 2> } } clipped_by { box { <-0.85, -2, -2>, <0.85, 2, 2> } } rotate <20, 30, 10> translate <0.4, 0.9, 0> pigment { rgb <0.40, 0.65, 0.90> } finish { Plain } }
// A box from which a ball is taken away: inverse.
box { -0.9, 0.9 clipped_by { sphere { <0, 0, 0>, 1.15 inverse } } rotate <-15, 35, 0> translate <2.7, 0.4, 0.3> pigment { rgb <0.85, 0.75, 0.35> } finish { Plain } }
// A torus cut open, and a tube cut slanting.
torus { 0.85, 0.3 clipped_by { plane { x, 0.2 } } rotate <-50, 25, 0> translate <-0.9, -1.5, -0.8> pigment { rgb <0.50, 0.80, 0.55> } finish { Plain } }
cylinder { -1.2*x, 1.2*x, 0.45 open clipped_by { plane { <1, 0.8, -0.3>, 0.3 } } rotate 25*y translate <1.9, -1.5, -0.8> pigment { rgb <0.80, 0.50, 0.80> } finish { Plain } }
