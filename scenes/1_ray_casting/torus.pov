// Tori at several angles: a ray may meet one four times, see another through its hole, or graze it along a whole
// circle. Catches lost roots that lie close together and normals of the wrong tube centre.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb <0.09, 0.09, 0.13> }

camera { location <0, 1.2, -8> right x*4/3 up y look_at <0.2, -0.1, 0> angle 48 }
light_source { <-6, 8, -8>, rgb 1 shadowless }

#declare Plain = finish { ambient 0.12 diffuse 0.85 }

torus { 1.3, 0.40 rotate -75*x translate <-1.6, 0.2, 0> pigment { rgb <0.95, 0.60, 0.25> } finish { Plain } }
torus { 0.9, 0.15 rotate <-60, 40, 0> translate <-1.6, 0.3, 1.6> pigment { rgb <0.35, 0.70, 0.90> } finish { Plain } }
torus { 1.0, 0.35 rotate <0, 0, 8> translate <1.8, -1.3, 0> pigment { rgb <0.55, 0.80, 0.45> } finish { Plain } }
torus { 0.75, 0.12 rotate <90, 55, 0> translate <1.5, -0.9, -0.6> pigment { rgb <0.95, 0.85, 0.45> } finish { Plain } }
torus { 0.6, 0.50 rotate <-35, 0, -20> translate <2.0, 1.1, 0.4> pigment { rgb <0.85, 0.45, 0.60> } finish { Plain } }
torus { 0.7, 0.04 rotate <12, 0, 0> translate <-0.1, -1.6, -0.8> pigment { rgb <0.85, 0.85, 0.90> } finish { Plain } }
