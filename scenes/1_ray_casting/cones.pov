// Cylinders and cones, with lids and open, from the side, from above, along the axis. Catches a missing lid, the second
// half of the double cone, and the inner wall of an open one that is not drawn.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb <0.08, 0.11, 0.12> }

camera { location <0, 3.4, -7.5> right x*4/3 up y look_at <0, -0.15, 0> angle 56 }
light_source { <-5, 9, -7>, rgb 1 shadowless }

#declare Plain = finish { ambient 0.15 diffuse 0.8 }

cylinder { <-2.9, -1, 0.8>, <-2.9, 0.9, 0.8>, 0.75 pigment { rgb <0.85, 0.40, 0.30> } finish { Plain } }
cylinder { <-0.9, -1, 1.2>, <-0.9, 0.7, 1.2>, 0.80 open pigment { rgb <0.90, 0.70, 0.30> } finish { Plain } }
cone { <1.1, -1, 1>, 0.9, <1.1, 1.1, 1>, 0 pigment { rgb <0.45, 0.75, 0.50> } finish { Plain } }
cone { <3.1, -1, 0.8>, 0.45, <3.1, 0.8, 0.8>, 0.95 open pigment { rgb <0.40, 0.60, 0.90> } finish { Plain } }
// Lying ones: a pencil towards the eye, a tube to look through, a frustum, a needle.
cylinder { <-2.8, -0.55, -1.2>, <-1.9, -0.1, -2.3>, 0.35 pigment { rgb <0.75, 0.55, 0.90> } finish { Plain } }
cone { <-1.9, -0.1, -2.3>, 0.35, <-1.6, 0.05, -2.65>, 0.02 pigment { rgb <0.95, 0.85, 0.70> } finish { Plain } }
cylinder { <0.1, 0.05, -2.4>, <0.05, -0.9, -0.6>, 0.5 open pigment { rgb <0.55, 0.80, 0.85> } finish { Plain } }
cone { <1.3, -0.6, -1.6>, 0.45, <2.3, -0.3, -2.0>, 0.2 pigment { rgb <0.90, 0.60, 0.70> } finish { Plain } }
cone { <2.5, -0.8, -0.9>, 0.12, <3.9, 0.3, -1.2>, 0 pigment { rgb <0.95, 0.95, 0.85> } finish { Plain } }
