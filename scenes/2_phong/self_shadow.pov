// Bodies in their own way: a torus, a cup and a spiral stair shade themselves. A shadow test that leaves out the body on
// which the point lies loses all of this.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <-1.6, 5.4, -8> right x*image_width/image_height up y angle 44 look_at <0.05, 0.5, 0> }
background { rgb <0.07, 0.06, 0.05> }
light_source { <7, 5, -3.5>, rgb <0.95, 0.9, 0.8> }

plane { y, 0
    pigment { rgb <0.55, 0.5, 0.45> }
    finish { ambient 0.12 diffuse 0.7 }
}
torus { 1.05, 0.42
    rotate <-28, 0, 14>
    translate <-2.1, 0.95, 0.6>
    pigment { rgb <0.9, 0.45, 0.2> }
    finish { ambient 0.12 diffuse 0.65 phong 0.5 phong_size 40 }
}
cone { <0.4, 0.02, -1.7>, 0.5, <0.4, 1.2, -1.7>, 0.8 open
    pigment { rgb <0.45, 0.65, 0.75> }
    finish { ambient 0.12 diffuse 0.65 }
}
#declare I = 0;
#while (I < 10)
    box { <0, 0.17*I, -0.16>, <1, 0.17*I + 0.1, 0.16>
        rotate (150 - 34*I)*y
        translate <2.1, 0, 0.9>
        pigment { rgb <0.6, 0.55, 0.75> }
        finish { ambient 0.12 diffuse 0.65 }
    }
    #declare I = I + 1;
#end
