// Between two mirrors, 0 reflections deep (max_trace_level 1): the camera's ray and no other, mirrors show nothing.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 1 adc_bailout 0 }
#include "mirrors.inc"
