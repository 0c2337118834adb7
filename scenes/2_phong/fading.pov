// Fading: two lamps between white balls, seen from above. On the left light falls as 2 / (1 + (d/D)^1), on the right as
// 2 / (1 + (d/D)^2), the inverse square of the distance once d is much larger than D. Ambient light does not fade.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.6, 9, -5.5> right x*image_width/image_height up y angle 46 look_at <0.1, 0, 0.3> }
light_source { <-2.7, 1.1, -1>, rgb <0.7, 0.48, 0.26> fade_distance 0.9 fade_power 1 }
light_source { < 2.7, 1.1, -1>, rgb <0.4, 0.55, 0.8> fade_distance 0.9 fade_power 2 }

plane { y, 0
    pigment { rgb 0.9 }
    finish { ambient 0.03 diffuse 0.7 }
}
box { <-0.1, 0, -9>, <0.1, 2.4, 9>
    pigment { rgb 0.6 }
    finish { ambient 0.05 diffuse 0.6 }
}
#macro Ring(X)
    #local I = 0;
    #while (I < 7)
        #local Angle = radians(50*I + 12);
        sphere { <X + (0.8 + 0.17*I)*cos(Angle), 0.3, -0.6 + (0.8 + 0.17*I)*sin(Angle)>, 0.3
            pigment { rgb 1 }
            finish { ambient 0.03 diffuse 0.7 phong 0.3 phong_size 30 }
        }
        #local I = I + 1;
    #end
#end
Ring(-2.5)
Ring(2.5)
