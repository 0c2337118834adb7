// Pixels so small that only the light's two numbers matter.
#declare Width = 0.001;
#include "smooth.inc"
