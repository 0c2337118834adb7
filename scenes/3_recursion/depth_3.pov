// Between two mirrors, 3 reflections deep (max_trace_level 4): the assignment's depth.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 4 adc_bailout 0 }
#include "mirrors.inc"
