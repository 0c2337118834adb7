// A floor of tiles that lie in one plane, edge to edge: their boxes are flat, and rays pass through common corners.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 4, -6> right x*image_width/image_height up y angle 45 look_at <0, 0, 0> }
background { rgb <0.4, 0.5, 0.7> }
light_source { <-4, 7, -6>, rgb 1 }
#declare X = -8;
#while (X < 8)
    #declare Z = -8;
    #while (Z < 8)
        polygon {
            5, <X, 0, Z>, <X + 1, 0, Z>, <X + 1, 0, Z + 1>, <X, 0, Z + 1>, <X, 0, Z>
            pigment { rgb <0.55 + 0.35*sin(5*X + 3*Z), 0.5 + 0.3*cos(3*X - 4*Z), 0.45> } finish { ambient 0.2 diffuse 0.7 }
        }
        #declare Z = Z + 1;
    #end
    #declare X = X + 1;
#end
sphere { <0, 1, 0>, 0.7 pigment { rgb <0.9, 0.3, 0.2> } finish { ambient 0.1 diffuse 0.7 phong 0.6 } }
box { <2, 0, 1>, <3, 1, 2> pigment { rgb <0.3, 0.5, 0.9> } finish { ambient 0.1 diffuse 0.7 } }
