// The gallery's picture of step 4: 82 430 spheres. A golden flake of five generations above a sea of 16 000 balls, which stand
// as the seeds of a sunflower do.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 4 }
camera { location <0, 4.4, -12> right x*image_width/image_height up y angle 50 look_at <0, 1.75, 0> }
background { rgb <0.02, 0.03, 0.085> }
disc { <2.6, -0.3, 24>, z, 5.7 pigment { rgb <0.95, 0.5, 0.22> } finish { ambient 1 diffuse 0 } no_shadow }
light_source { <-30, 24, 6>, rgb <1.35, 0.95, 0.6> }
light_source { <12, 14, -16>, rgb <0.62, 0.6, 0.62> }
light_source { <0, 6, -12>, rgb <0.1, 0.1, 0.12> shadowless }

#declare Gold = texture { pigment { rgb <1, 0.7, 0.3> } finish { ambient 0.03 diffuse 0.45 specular 0.8 roughness 0.03 metallic reflection { 0.42 metallic } } }
#macro Flake(Radius, Generation)
    sphere { 0, Radius }
    #if (Generation > 0)
        #local I = 0;
        #while (I < 9)
            #local Around = (I < 6 ? 60*I : 120*(I - 6) + 30);
            #local Down = (I < 6 ? 90 : 35);
            #if (Generation = 1)
                sphere { 4/3*Radius*y, Radius/3 rotate Down*x rotate Around*y }
            #else
                union { Flake(Radius/3, Generation - 1) translate 4/3*Radius*y rotate Down*x rotate Around*y }
            #end
            #local I = I + 1;
        #end
    #end
#end
union { Flake(1, 5) rotate <-14, 22, 6> translate <0, 2.9, 0> texture { Gold } }

// Seed n lies at the root of n and turned by the golden angle from the one before it; it floats on the waves of two stones.
#declare N = 16000;
#for (I, 1, N)
    #local R = 0.1165*sqrt(I);
    #local A = 2.399963229728653*I;
    #local X = R*cos(A);
    #local Z = R*sin(A);
    #local Wave = cos(2.1*R)*exp(-0.13*R) + 0.35*cos(2.6*vlength(<X - 7, 0, Z - 5>));
    #local T = 0.5 + 0.37*Wave;
    sphere { <X, -0.6 + 0.34*Wave, Z>, 0.095
        pigment { rgb <0.01 + 0.9*pow(T, 4), 0.04 + 0.5*T*T, 0.14 + 0.42*T*(1.4 - T)> }
        finish { ambient 0.07 diffuse 0.75 phong 0.35 phong_size 25 } }
#end
