#version 3.5;
global_settings { radiosity { brightness 3.3 count 100 error_bound .4 gray_threshold .5 low_error_factor .8 minimum_reuse .01 nearest_count 6 recursion_limit 1 } }
sphere{0,1}
