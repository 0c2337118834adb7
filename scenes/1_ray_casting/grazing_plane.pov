// An endless floor seen from a hand's breadth above it and a wall almost edge-on: the rays nearly lie in the planes.
// Catches division by u . n near zero, planes seen behind the eye, and a horizon in the wrong row.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb <0.55, 0.70, 0.90> }

camera { location <0, 0.25, -3> right x*4/3 up y direction <0.03, 0.07, 1.1> }
light_source { <-40, 60, -30>, rgb 1 shadowless }

plane {
    y, 0
    pigment { checker rgb <0.85, 0.80, 0.70>, rgb <0.35, 0.40, 0.35> scale 1.3 translate <0.21, 0.5, 0.33> }
    finish { ambient 0.10 diffuse 0.8 }
}
plane {
    <1, 0, -0.02>, 2.2
    inverse
    pigment { checker rgb <0.80, 0.45, 0.35>, rgb <0.60, 0.25, 0.20> scale 0.9 translate <0.37, 0.41, 0.17> }
    finish { ambient 0.25 diffuse 0.7 }
}
sphere { <-0.9, 0.3, 1>, 0.3 pigment { rgb <0.95, 0.80, 0.20> } finish { ambient 0.1 diffuse 0.8 } }
