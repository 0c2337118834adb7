// Between two mirrors, 1 reflections deep (max_trace_level 2): mirrors show things, mirrors in mirrors are black.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 2 adc_bailout 0 }
#include "mirrors.inc"
