// Inside the tube: the eye stands in a torus and looks along it, with the walls all around. Catches roots behind the
// eye and an inside that is treated as empty.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb <1, 0, 1> }  // must not be seen

camera { location <4.1, 0.1, -0.2> right x*4/3 up y look_at <3.2, 0, 2.8> angle 80 }
light_source { <4.1, 0.6, 0.4>, rgb 1 shadowless }

torus {
    4, 1
    pigment { checker rgb <0.90, 0.80, 0.60>, rgb <0.35, 0.45, 0.60> scale 0.61 translate <0.13, 0.29, 0.07> }
    finish { ambient 0.15 diffuse 0.8 }
}
sphere { <3.55, -0.35, 1.7>, 0.35 pigment { rgb <0.90, 0.35, 0.25> } finish { ambient 0.15 diffuse 0.8 } }
