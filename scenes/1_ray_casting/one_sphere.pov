// One sphere off the axis: a ray through each pixel's centre meets it or not. The outline is an ellipse, longer away
// from the centre of the picture. Catches tan(angle) for tan(angle / 2), a wrong aspect and half a pixel lost.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb <0.10, 0.13, 0.20> }

camera { location <0, 0, -6> right x*4/3 up y direction z angle 60 }
light_source { <-6, 8, -8>, rgb 1 shadowless }

sphere {
    <-1.1, 0.55, 0>, 1.6
    pigment { rgb <0.95, 0.55, 0.18> }
    finish { ambient 0.12 diffuse 0.85 }
}
