// Built-in functions of floats, vectors and strings.
#version 3.7;
#macro F(Name, A) #debug concat(Name, " ", str(A, 0, 12), "\n") #end
#macro V(Name, A) #debug concat(Name, " ", vstr(3, A, " ", 0, 12), "\n") #end
F("abs", abs(-1.5))
F("acos", acos(0.3))
F("acosh", acosh(1.3))
F("asin", asin(0.3))
F("asinh", asinh(0.3))
F("atan", atan(0.3))
F("atan2", atan2(-1, -2))
F("atanh", atanh(0.3))
F("ceil", ceil(-1.5))
F("cos", cos(1))
F("cosh", cosh(1))
F("degrees", degrees(1))
F("div", div(-7, 2))
F("div 2", div(7.9, 2.1))
F("exp", exp(1.5))
F("floor", floor(-1.5))
F("int", int(-1.7))
F("int 2", int(1.7))
F("ln", ln(5))
F("log", log(5))
F("max", max(1, 3, 2))
F("min", min(4, 3, 5))
F("mod", mod(7.5, 2))
F("mod negative", mod(-7.5, 2))
F("pow", pow(2, 0.5))
F("pow negative", pow(-2, 3))
F("radians", radians(45))
F("select 2", select(-1, 10, 20) + select(1, 10, 20))
F("select 3", select(-1, 10, 20, 30) + 100*select(0, 10, 20, 30) + 10000*select(1, 10, 20, 30))
F("sin", sin(1))
F("sinh", sinh(1))
F("sqrt", sqrt(2))
F("tan", tan(1))
F("tanh", tanh(1))
F("pi", pi)
F("true", true + on + yes + false + off + no)
F("bitwise", bitwise_and(12, 10) + 100*bitwise_or(12, 10) + 10000*bitwise_xor(12, 10))
F("version", version)
F("vdot", vdot(<1,2,3>, <4,5,6>))
F("vlength", vlength(<1,2,3>))
V("vcross", vcross(<1,2,3>, <4,5,6>))
V("vnormalize", vnormalize(<1,2,3>))
V("vrotate", vrotate(<1,2,3>, <20,30,40>))
V("vrotate z", vrotate(x, 90*z))
V("vaxis_rotate", vaxis_rotate(<1,2,3>, <1,1,0>, 40))
F("strlen", strlen("abc"))
F("asc", asc("A"))
F("val", val("12.5"))
F("strcmp", strcmp("a", "b"))
F("nested call", sin(cos(tan(0.5))))
F("defined", defined(Nothing) + 10*defined(F))
#debug concat("str ", str(3.14159, 0, 3), " [", str(2, 6, 1), "] [", str(2, -6, 1), "] ", str(1/3, 0, -1), "\n")
#debug concat("vstr ", vstr(2, <1,2>, ";", 0, 1), " ", vstr(5, <1,2,3,4,5>, ",", 4, 1), "\n")
#debug concat("substr ", substr("abcdef", 2, 3), " ", strupr("aBc"), " ", strlwr("aBc"), " ", chr(65), "\n")
#declare R1 = seed(1);
#declare R2 = seed(123456);
F("rand 1", rand(R1))
F("rand 2", rand(R1))
F("rand 3", rand(R2))
F("rand 4", rand(R1))
F("rand 5", rand(R2))
#declare I = 0;
#declare Sum = 0;
#while (I < 1000)
  #declare Sum = Sum + rand(R1)*(1 + I);
  #declare I = I + 1;
#end
F("rand sum", Sum)
#declare Rn = seed(-5);
F("rand negative seed", rand(Rn))
#declare Square = function(x) { x*x + 1 };
#declare Two = function(x, y) { Square(x) + sin(y) };
#declare K = 3;
#declare Captured = function(x) { K*x };
#declare K = 4;
F("function", Square(3))
F("function of two", Two(2, 0.5))
F("function captures", Captured(2))
