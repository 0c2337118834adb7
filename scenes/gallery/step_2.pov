// The gallery's picture of step 2: three lamps, red, green and blue, make white together. Where one of them is missing
// the shadow has the colour of the other two.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3.6, -12> right x*image_width/image_height up y angle 52 look_at <0, 2.45, 0> }
background { rgb 0 }
#macro Lamp(Where, Colour)
    light_source { Where, Colour spotlight radius 21 falloff 31 tightness 1 point_at <0, 1.5, 1.6> }
#end
Lamp(<-8.2, 8.0, -8.5>, rgb <0.95, 0.06, 0.05>)
Lamp(<0, 9.6, -9.5>, rgb <0.05, 0.85, 0.1>)
Lamp(<8.2, 8.0, -8.5>, rgb <0.08, 0.12, 1.05>)
light_source { <0, 8, 4>, rgb 0.06 shadowless }

// The stage.
#declare Wall = texture { pigment { rgb <0.95, 0.94, 0.92> } finish { ambient 0.012 diffuse 0.85 } }
plane { y, 0 texture { Wall } }
plane { -z, -5.2 texture { Wall } }
cylinder { <0, 0, 1.2>, <0, 0.35, 1.2>, 3.7 pigment { rgb <0.95, 0.94, 0.92> } finish { ambient 0.012 diffuse 0.75 specular 0.25 roughness 0.01 } }

#declare Porcelain = texture { pigment { rgb 0.92 } finish { ambient 0.012 diffuse 0.72 specular 0.85 roughness 0.004 } }
#declare Brass = texture { pigment { rgb <1, 0.78, 0.42> } finish { ambient 0.015 diffuse 0.42 phong 1.1 phong_size 45 metallic } }
#declare Satin = texture { pigment { rgb <0.85, 0.87, 0.9> } finish { ambient 0.012 diffuse 0.5 phong 0.7 phong_size 9 metallic } }

// A dancer of balls and rings.
union {
    sphere { <0, 1.35, 1.2>, 1 texture { Porcelain } }
    torus { 1.45, 0.09 rotate <18, 0, 24> translate <0, 1.5, 1.2> texture { Brass } }
    torus { 0.62, 0.08 translate <0, 2.28, 1.2> texture { Brass } }
    sphere { <0, 2.86, 1.2>, 0.62 texture { Porcelain } }
    torus { 0.34, 0.06 translate <0, 3.44, 1.2> texture { Brass } }
    sphere { <0, 3.78, 1.2>, 0.36 texture { Porcelain } }
    cone { <0, 4.1, 1.2>, 0.12, <0, 4.95, 1.2>, 0 texture { Brass } }
}
// Her audience.
#for (I, 0, 10)
    #local Angle = radians(-100 + 20*I);
    union {
        cone { 0, 0.3, <0, 0.72, 0>, 0.1 }
        sphere { <0, 0.86, 0>, 0.2 }
        #if (mod(I, 2) = 0) texture { Satin } #else texture { Brass } #end
        translate <4.3*sin(Angle), 0, 1.2 - 3.5*cos(Angle)>
    }
#end
