// Loops, conditions, switches, macros, scopes, arrays.
#version 3.7;
#macro F(Name, A) #debug concat(Name, " ", str(A, 0, 12), "\n") #end
#declare I = 0;
#while (I < 3) F("while", I) #declare I = I + 1; #end
#for (K, 1, 2) F("for", K) #end
#for (K, 5, 1, -2) F("for down", K) #end
#for (K, 0, 1, 0.1) #end
F("for leaves", K)
#for (K, 5, 1) F("never", K) #end
#if (0) F("never", 1) #elseif (1) F("elseif", 2) #else F("never", 3) #end
#if (0) F("never", 1) #elseif (0) F("never", 2) #else F("else", 3) #end
#ifdef (I) F("ifdef", 1) #else F("ifdef", 0) #end
#ifndef (Nope) F("ifndef", 1) #end
#macro Case(N)
  #switch (N)
    #case (1) F("case one", N) #break
    #case (2) F("case two falls", N)
    #range (3, 5) F("range", N) #break
    #else F("otherwise", N)
  #end
#end
Case(1) Case(2) Case(4) Case(9)
#declare I = 0;
#while (1)
  #if (I = 2) #break #end
  #declare I = I + 1;
#end
F("break", I)
#macro Fact(N) #if (N <= 1) #local Result = 1; #else #local Result = N*Fact(N - 1); #end (Result) #end
F("recursion", Fact(10))
#macro Set(A, B) #declare A = B; #end
#declare X1 = 1;
Set(X1, 42)
F("by reference", X1)
#macro Twice(A) #declare A = A + A; #end
#macro Nested(A) Twice(A) Twice(A) #end
Nested(X1)
F("reference of reference", X1)
#declare L = 5;
#macro LocalTest() #local L = 6; #declare G = 7; F("local inside", L) #end
LocalTest()
F("local outside", L)
F("global from macro", G)
#macro Value(A) (A*A) #end
F("macro as value", Value(3) + 1)
F("macro in macro", Value(Value(2)))
#declare Arr = array[3] { 10, 20, 30 };
F("array", Arr[0] + Arr[1]*2 + Arr[2]*3)
#declare Arr[1] = 99;
F("array element", Arr[1])
#declare Copy = Arr;
#declare Copy[1] = 1;
F("array copied", Arr[1])
#declare M = array[2][3] { {1, 2, 3}, {4, 5, 6} }
F("two dimensions", M[1][2] + 10*M[0][1])
F("sizes", dimensions(M) + 10*dimension_size(M, 1) + 100*dimension_size(M, 2))
#macro Change(E) #declare E = E + 1; #end
Change(Arr[2])
F("element by reference", Arr[2])
#declare Un = array[2];
#declare Un[0] = 3;
#ifdef (Un[0]) F("element declared", 1) #end
#ifdef (Un[1]) F("element declared", 0) #else F("element undeclared", 1) #end
#declare Vs = array[2] { <1,2,3>, <4,5,6> }
F("vector element", Vs[1].y)
#declare S = "text";
#declare S2 = concat(S, "!", str(1, 0, 0));
#debug concat(S2, "\n")
#declare Z = 1; #undef Z
#ifdef (Z) F("undef", 0) #else F("undef", 1) #end
#local AtTop = 8;
F("local at the top", AtTop)
#macro ByElement(A) #local J = 0; #while (J < dimension_size(A, 1)) #declare A[J] = J*J; #local J = J + 1; #end #end
ByElement(Arr)
F("array by reference", Arr[2])
/* nested /* comment */ still */
// "quotes" and #if in a comment
#if (0) "a string with #end in it" /* #end */ // #end
#end
F("skipped", 1)
#macro Vec(A, B, C) <A, B, C> #end
F("macro makes a vector", Vec(1, 2, 3).z)
#macro Empty() #end
Empty()
F("default parameter name reuse", Value(L))
#for (A, 1, 2) #for (B, 1, 2) F("nested for", A*10 + B) #end #end
#macro Early(A) #if (A) F("early", 1) #break #end F("late", 2) #end
Early(0)
