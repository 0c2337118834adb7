// POV-Ray's axes: x to the right in red, y up in green, z away in blue, and the letter R. No mirrored or turned picture
// matches. Catches flipped x or y, swapped handedness, and rotation the wrong way round.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb <0.92, 0.93, 0.95> }

camera { location <2.6, 2.1, -5.2> right x*4/3 up y look_at <0.9, 0.75, 0.4> angle 38 }
light_source { <5, 8, -7>, rgb 0.9 shadowless }

#declare Plain = finish { ambient 0.2 diffuse 0.8 }

#macro Arrow(Direction, Length, Tint)
    cylinder { 0, Length*Direction, 0.07 pigment { rgb Tint } finish { Plain } }
    cone { Length*Direction, 0.17, (Length + 0.4)*Direction, 0 pigment { rgb Tint } finish { Plain } }
#end
Arrow(x, 2.0, <0.85, 0.20, 0.18>)
Arrow(y, 1.5, <0.25, 0.65, 0.25>)
Arrow(z, 2.8, <0.20, 0.35, 0.85>)
sphere { 0, 0.16 pigment { rgb 0.25 } finish { Plain } }

// The letter R with its eye, turned by 20 degrees about y (POV-Ray turns clockwise seen from above).
polygon {
    17,
    <0, 0>, <0, 1.4>, <0.65, 1.4>, <0.95, 1.2>, <0.95, 0.85>, <0.7, 0.62>, <0.45, 0.58>, <1.0, 0>, <0.7, 0>, <0.25, 0.5>,
    <0.25, 0>, <0, 0>,
    <0.25, 0.78>, <0.25, 1.18>, <0.68, 1.12>, <0.68, 0.85>, <0.25, 0.78>
    rotate 20*y
    translate <0.55, 0.25, 0.5>
    pigment { rgb <0.95, 0.70, 0.15> } finish { Plain }
}
