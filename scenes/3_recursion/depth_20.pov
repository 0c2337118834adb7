// Between two mirrors, 20 reflections deep (max_trace_level 21): a corridor of pictures of pictures.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 21 adc_bailout 0 }
#include "mirrors.inc"
