// 820 spheres: a sphereflake of generation 3. Each generation has nine times as many; a ray that is well led meets a few.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "flake.inc"
camera { location <2.2, 1.8, -4.6> right x*image_width/image_height up y angle 36 look_at <0, 0.05, 0> }
background { rgb <0.2, 0.3, 0.5> }
light_source { <-4, 7, -6>, rgb 0.8 }
light_source { <6, 4, -3>, rgb 0.3 }
plane { y, -1.7 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.4, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.6 } }
union { Flake(1, 3) rotate <10, 15, 0> pigment { rgb <0.9, 0.75, 0.4> } finish { ambient 0.1 diffuse 0.6 phong 0.5 phong_size 60 } }
