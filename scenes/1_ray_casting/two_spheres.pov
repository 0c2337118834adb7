// Which is in front? Spheres that cover and pierce each other, the nearer ones neither all first nor all last in the
// file. Catches keeping the last hit instead of the nearest.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb <0.08, 0.10, 0.14> }

camera { location <0, 0, -7> right x*4/3 up y direction z*1.25 }
light_source { <-5, 7, -9>, rgb 1 shadowless }

#declare Plain = finish { ambient 0.12 diffuse 0.85 }

sphere { <-0.90, 0.20, -1.5>, 0.90 pigment { rgb <0.95, 0.35, 0.25> } finish { Plain } }
sphere { < 0.25, 0.00,  1.0>, 1.70 pigment { rgb <0.25, 0.45, 0.85> } finish { Plain } }
sphere { < 1.35, 0.65,  0.2>, 1.00 pigment { rgb <0.95, 0.80, 0.25> } finish { Plain } }
sphere { < 0.55, -0.85, -1.8>, 0.45 pigment { rgb <0.35, 0.75, 0.40> } finish { Plain } }
sphere { <-1.90, -0.95,  2.0>, 0.80 pigment { rgb <0.75, 0.50, 0.85> } finish { Plain } }
