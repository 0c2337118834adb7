// Triangles in bulk: a faceted octahedron (mesh), an icosahedron (mesh2), the same with the normals of its sphere, and a
// smooth hill. Catches normals not interpolated, weights given to the wrong corners, and indices off by one.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb <0.11, 0.11, 0.15> }

camera { location <0, 3.2, -7> right x*4/3 up y look_at <0, 0.2, 0> angle 56 }
light_source { <-5, 8, -6>, rgb 1 shadowless }

#declare Plain = finish { ambient 0.15 diffuse 0.8 }
#declare G = (1 + sqrt(5))/2;
#declare N = 1/sqrt(1 + G*G);

mesh {
    #for (I, 0, 3)
        #declare A = <cos(pi/2*I), 0, sin(pi/2*I)>;
        #declare B = <cos(pi/2*(I + 1)), 0, sin(pi/2*(I + 1))>;
        triangle { A, B, 1.3*y }
        triangle { B, A, -1.3*y }
    #end
    rotate <20, 15, 0> translate <-2.5, 1.0, 0.3>
    pigment { rgb <0.90, 0.50, 0.35> } finish { Plain }
}
mesh2 {
    vertex_vectors { 12, <0,1,G>, <0,1,-G>, <0,-1,G>, <0,-1,-G>, <1,G,0>, <1,-G,0>, <-1,G,0>, <-1,-G,0>, <G,0,1>, <-G,0,1>, <G,0,-1>, <-G,0,-1> }
    face_indices { 20,
        <0,2,8>, <0,8,4>, <0,4,6>, <0,6,9>, <0,9,2>, <3,1,10>, <3,10,5>, <3,5,7>, <3,7,11>, <3,11,1>,
        <2,5,8>, <8,5,10>, <8,10,4>, <4,10,1>, <4,1,6>, <6,1,11>, <6,11,9>, <9,11,7>, <9,7,2>, <2,7,5>
    }
    scale 0.55 rotate <15, 10, 20> translate <0, 1.3, 0.3>
    pigment { rgb <0.95, 0.80, 0.35> } finish { Plain }
}
mesh2 {
    vertex_vectors { 12, <0,1,G>, <0,1,-G>, <0,-1,G>, <0,-1,-G>, <1,G,0>, <1,-G,0>, <-1,G,0>, <-1,-G,0>, <G,0,1>, <-G,0,1>, <G,0,-1>, <-G,0,-1> }
    normal_vectors { 12, <0,N,G*N>, <0,N,-G*N>, <0,-N,G*N>, <0,-N,-G*N>, <N,G*N,0>, <N,-G*N,0>, <-N,G*N,0>, <-N,-G*N,0>, <G*N,0,N>, <-G*N,0,N>, <G*N,0,-N>, <-G*N,0,-N> }
    face_indices { 20,
        <0,2,8>, <0,8,4>, <0,4,6>, <0,6,9>, <0,9,2>, <3,1,10>, <3,10,5>, <3,5,7>, <3,7,11>, <3,11,1>,
        <2,5,8>, <8,5,10>, <8,10,4>, <4,10,1>, <4,1,6>, <6,1,11>, <6,11,9>, <9,11,7>, <9,7,2>, <2,7,5>
    }
    scale 0.55 rotate <15, 10, 20> translate <2.5, 1.2, 0.3>
    pigment { rgb <0.50, 0.75, 0.90> } finish { Plain }
}

// The hill y = 0.5 cos(2r) on a grid of 12 x 8 cells, each of two triangles with the true normals.
#macro Height(X, Z) 0.5*cos(2*sqrt(X*X + Z*Z)) #end
#macro Point(X, Z) <X, Height(X, Z), Z> #end
#macro Normal(X, Z) vnormalize(<sin(2*sqrt(X*X + Z*Z))*X/sqrt(X*X + Z*Z), 1, sin(2*sqrt(X*X + Z*Z))*Z/sqrt(X*X + Z*Z)>) #end
mesh {
    #for (I, 0, 11)
        #for (K, 0, 7)
            #declare X0 = -3 + 0.5*I + 0.03;
            #declare Z0 = -2 + 0.5*K + 0.02;
            #declare X1 = X0 + 0.5;
            #declare Z1 = Z0 + 0.5;
            smooth_triangle { Point(X0, Z0), Normal(X0, Z0), Point(X1, Z0), Normal(X1, Z0), Point(X1, Z1), Normal(X1, Z1) }
            smooth_triangle { Point(X0, Z0), Normal(X0, Z0), Point(X1, Z1), Normal(X1, Z1), Point(X0, Z1), Normal(X0, Z1) }
        #end
    #end
    translate <0, -1.4, -0.8>
    pigment { rgb <0.50, 0.75, 0.45> } finish { Plain }
}
