// Fractal hills: octaves of waves at odd angles, 64 x 64 x 2 triangles in one mesh. Flat as a whole, and dense everywhere.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2.2, -5.5> right x*image_width/image_height up y angle 45 look_at <0, 0, 0> }
background { rgb <0.55, 0.7, 0.9> }
light_source { <-40, 25, -10>, rgb 1 }
#declare Height = function(x, y) {
    0.5*sin(1.1*x + 0.4*y)*cos(0.9*y - 0.3*x) + 0.25*sin(2.3*x - 1.9*y + 1)*cos(2.7*y + 0.5) + 0.12*sin(5.1*x + 4.3*y)
    + 0.06*sin(9.7*x - 11.3*y + 2) + 0.03*sin(23*x + 17*y)
}
#declare N = 64;
mesh {
    #declare I = 0;
    #while (I < N)
        #declare J = 0;
        #while (J < N)
            #declare X = 8*I/N - 4;
            #declare Z = 8*J/N - 4;
            #declare S = 8/N;
            triangle { <X, Height(X, Z), Z>, <X + S, Height(X + S, Z), Z>, <X + S, Height(X + S, Z + S), Z + S> }
            triangle { <X, Height(X, Z), Z>, <X + S, Height(X + S, Z + S), Z + S>, <X, Height(X, Z + S), Z + S> }
            #declare J = J + 1;
        #end
        #declare I = I + 1;
    #end
    pigment { rgb <0.5, 0.6, 0.35> } finish { ambient 0.15 diffuse 0.8 }
}
