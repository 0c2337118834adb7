// Small spheres ten thousand radii away through a telescope: the discriminant is the small difference of large
// numbers. Catches b^2 - c computed plainly in float, which makes their edges ragged or loses them.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb <0.02, 0.03, 0.07> }

camera { location <0, 0, -5000> right x*4/3 up y direction z*1400 }
light_source { <-3000, 2500, -4000>, rgb 1 shadowless }

#declare Planet = finish { ambient 0.04 diffuse 0.95 }

sphere { <-0.55, 0.25, 0>, 0.80 pigment { rgb <0.85, 0.62, 0.40> } finish { Planet } }
sphere { < 0.85, 0.60, 3>, 0.25 pigment { rgb <0.75, 0.80, 0.85> } finish { Planet } }
sphere { < 1.25, -0.55, -2>, 0.50 pigment { rgb <0.35, 0.55, 0.90> } finish { Planet } }
sphere { < 0.45, -1.10, 5>, 0.12 pigment { rgb <0.90, 0.35, 0.25> } finish { Planet } }
sphere { <-1.70, -1.00, 1>, 0.06 pigment { rgb <0.95, 0.95, 0.70> } finish { Planet } }
