// Precedence, promotion, components. Each line: a label and numbers with 12 digits.
#version 3.7;
#macro F(Name, A) #debug concat(Name, " ", str(A, 0, 12), "\n") #end
#macro V(Name, A) #debug concat(Name, " ", vstr(3, A, " ", 0, 12), "\n") #end
#macro C(Name, A) #debug concat(Name, " ", vstr(5, A, " ", 0, 6), "\n") #end
F("precedence 1", 1+2*3-4/5)
F("precedence 2", -2*3+1)
F("precedence 3", 2-3-4)
F("precedence 4", 2/3/4)
F("precedence 5", 2*-3)
F("precedence 6", (1 < 2) + (2 <= 2) + (3 = 3) + (3 != 3) + (4 > 5) + (5 >= 5))
F("precedence 7", (1 | 0 & 0))
F("precedence 8", (1 + 1 = 2 & 2 + 2 = 5 | 1))
F("precedence 9", (!1 + 1))
F("precedence 10", (1 < 2 ? 3 : 4))
F("precedence 11", (0 ? 1 : 0 ? 2 : 3))
F("precedence 12", -(3) + +4)
F("precedence 13", --3)
F("equal within epsilon", (1 = 1 + 1e-11) + 2*(1 = 1 + 1e-9))
F("less within epsilon", (1 + 1e-11 <= 1) + 2*(1 + 1e-11 > 1))
V("promotion 1", 2*<1,2,3>)
V("promotion 2", <1,2,3>*<4,5,6>)
V("promotion 3", <1,2,3>/2)
V("promotion 4", 1 + <1,2,3>)
V("promotion 5", <1,2> + <1,2,3>)
V("promotion 6", x + 2*y - z/4)
V("promotion 7", -x*3)
V("promotion 8", <1,2,3> + 1)
#declare A = <1, 2>;
#declare B = <1, 2, 3, 4>;
V("promotion 9", A + x)
#declare White = rgb <1,1,1>;
C("promotion 10", B + White)
C("promotion 12", rgb 0.25)
C("promotion 13", rgbf 0.25)
C("promotion 14", rgbt 0.25)
C("promotion 15", rgbf <0.1, 0.2, 0.3, 0.4>)
C("promotion 16", rgbt <0.1, 0.2, 0.3, 0.4>)
C("promotion 17", color red 0.5 blue 0.25)
C("promotion 18", color rgb <0.1,0.2,0.3> filter 0.7)
C("promotion 19", rgb <1,2> * 2)
C("promotion 20", red 1 green 0.5 transmit 0.5)
#declare Tint = rgbft <0.1, 0.2, 0.3, 0.4, 0.5>;
F("component 1", Tint.red + 10*Tint.green + 100*Tint.blue + 1000*Tint.filter + 10000*Tint.transmit)
F("component 2", <1,2,3>.y)
F("component 3", A.u + 10*A.v)
F("component 4", B.x + 10*B.y + 100*B.z + 1000*B.t)
F("component 5", (x + 2*y).y)
F("component 6", Tint.gray)
F("component 7", -<1,2,3>.z)
F("component 8", vcross(x, y).z)
V("color times vector", Tint*<2,3,4>)
#declare Half = Tint*0.5 + White;
C("color sum", Half)
V("comparison of vectors", (<1,5,3> > <2,4,2>))
F("string comparison", ("abc" < "abd") + 2*("abc" = "abc") + 4*("b" > "a"))
F("nested", ((((1+2)*3)-4)/5))
V("five in a vector", <1, 1+1, (1 > 0)*3>)
F("directive inside", (1 + #if (1) 2 #else 3 #end + 4))
F("comparison in a vector", <1, (2 > 1), 3>.y)
#declare P = 0.1;
#declare Q = P;
F("variable", Q*10)
C("filter and transmit words", rgb <0.2, 0.4, 0.6> transmit 0.25)
