// Pixels so large that the place on the floor matters as much as the place on the light: four numbers.
#declare Width = 6;
#include "smooth.inc"
