#version 3.1 ;
global_settings { adc_bailout 0.003922 ambient_light <1.0,1.0,1.0> assumed_gamma 1.9 hf_gray_16 off irid_wavelength <0.247059,0.176471,0.137255> max_intersections 64 max_trace_level 10 number_of_waves 10 radiosity { brightness 3.3 count 100 distance_maximum 0.0 error_bound 0.4 gray_threshold 0.5 low_error_factor 0.8 minimum_reuse 0.015 nearest_count 6 recursion_limit 1 } }
background { color <0.000,0.000,0.000> }
camera { location <-10, -20, 8> direction <0, 0, 1.5> sky <0,0,1> up <0,0,1> right <1.33, 0, 0> look_at <0,0,0> }
light_source { <0,0,0> color rgb <1.0,1.0,1.0> translate <-10,-10,10> }
