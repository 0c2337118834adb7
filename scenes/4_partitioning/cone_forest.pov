// A forest of open cones, one inside another: slanted and hollow, so that most boxes are met in vain.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 5, -14> right x*image_width/image_height up y angle 40 look_at <0, 1, 0> }
background { rgb <0.6, 0.75, 0.9> }
light_source { <-20, 30, -20>, rgb 0.9 }
plane { y, 0 pigment { rgb <0.4, 0.35, 0.25> } finish { ambient 0.2 diffuse 0.6 } }
#declare R = seed(4);
#declare I = 0;
#while (I < 150)
    #declare P = <16*rand(R) - 8, 0, 14*rand(R) - 6>;
    #declare H = 0.8 + 1.2*rand(R);
    #declare Green = rgb <0.15 + 0.2*rand(R), 0.45 + 0.3*rand(R), 0.2>;
    union {
        cylinder { 0, 0.4*H*y, 0.07*H open pigment { rgb <0.4, 0.25, 0.15> } finish { ambient 0.15 diffuse 0.7 } }
        #declare K = 0;
        #while (K < 4)
            cone { (0.3 + 0.3*K)*H*y, (0.5 - 0.1*K)*H, (0.8 + 0.35*K)*H*y, 0.02 open pigment { Green } finish { ambient 0.15 diffuse 0.7 } }
            #declare K = K + 1;
        #end
        rotate <8*rand(R) - 4, 0, 8*rand(R) - 4> translate P
    }
    #declare I = I + 1;
#end
