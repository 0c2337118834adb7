// The sphereflake of generation 3, each sphere 1008 triangles: 826560 in all. For measurements.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <2.2, 1.8, -4.6> right x*image_width/image_height up y angle 36 look_at <0, 0.05, 0> }
background { rgb <0.2, 0.3, 0.5> }
light_source { <-4, 7, -6>, rgb 0.8 }
light_source { <6, 4, -3>, rgb 0.3 }
plane { y, -1.7 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.4, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.6 } }

// 28 meridians, 19 parallels: 2*28*18 triangles with those at the poles.
#macro Ball(Center, Radius)
    #local I = 0;
    #while (I < 28)
        #local A = 2*pi*I/28;
        #local B = 2*pi*(I + 1)/28;
        #local J = 0;
        #while (J < 19)
            #local U = pi*J/19;
            #local V = pi*(J + 1)/19;
            #local P = Center + Radius*<sin(U)*cos(A), cos(U), sin(U)*sin(A)>;
            #local Q = Center + Radius*<sin(V)*cos(A), cos(V), sin(V)*sin(A)>;
            #local S = Center + Radius*<sin(V)*cos(B), cos(V), sin(V)*sin(B)>;
            #local T = Center + Radius*<sin(U)*cos(B), cos(U), sin(U)*sin(B)>;
            #if (J < 18) triangle { P, Q, S } #end
            #if (J > 0) triangle { P, S, T } #end
            #local J = J + 1;
        #end
        #local I = I + 1;
    #end
#end
// Axes X, Y, Z of this sphere's own space.
#macro Flake(Center, X, Y, Z, Radius, Generation)
    Ball(Center, Radius)
    #if (Generation > 0)
        #local K = 0;
        #while (K < 9)
            #local Around = radians(K < 6 ? 60*K : 120*(K - 6) + 30);
            #local Down = radians(K < 6 ? 90 : 35);
            #local Out = sin(Down)*sin(Around)*X + cos(Down)*Y + sin(Down)*cos(Around)*Z;
            #local Side = cos(Around)*X - sin(Around)*Z;
            Flake(Center + 4/3*Radius*Out, Side, Out, vcross(Side, Out), Radius/3, Generation - 1)
            #local K = K + 1;
        #end
    #end
#end
mesh { Flake(0, x, y, z, 1, 3) rotate <10, 15, 0> pigment { rgb <0.9, 0.75, 0.4> } finish { ambient 0.1 diffuse 0.6 phong 0.5 phong_size 60 } }
