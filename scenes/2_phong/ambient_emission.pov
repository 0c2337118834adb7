// Light without a lamp: ambient light is flat, tinted by the scene's ambient_light; emission is not. From left to right:
// ambient only, emission only, both, and both with some diffuse light that makes the ball look round.
#version 3.7;
global_settings { assumed_gamma 1.0 ambient_light rgb <1, 0.6, 0.4> }
camera { location <0.5, 3, -9> right x*image_width/image_height up y angle 48 look_at <0.1, 0.7, 0> }
background { rgb <0.02, 0.02, 0.04> }
light_source { <3, 6, -5>, rgb 0.8 }

plane { y, 0
    pigment { rgb <0.5, 0.5, 0.6> }
    finish { ambient 0.1 diffuse 0.5 }
}
sphere { <-2.7, 0.8, 0.3>, 0.8
    pigment { rgb <0.9, 0.9, 0.9> }
    finish { ambient 0.5 diffuse 0 }
}
sphere { <-0.9, 0.8, -0.2>, 0.8
    pigment { rgb <0.3, 0.7, 0.9> }
    finish { ambient 0 emission 0.6 diffuse 0 }
}
sphere { <0.9, 0.8, 0.3>, 0.8
    pigment { rgb <0.6, 0.85, 0.4> }
    finish { ambient rgb <0.2, 0.4, 0.6> emission rgb <0.3, 0.1, 0.05> diffuse 0 }
}
sphere { <2.7, 0.8, -0.2>, 0.8
    pigment { rgb <0.85, 0.5, 0.75> }
    finish { ambient 0.25 emission 0.1 diffuse 0.6 }
}
