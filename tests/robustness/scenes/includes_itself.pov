#include "includes_itself.pov"
