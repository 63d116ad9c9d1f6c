#version 3.1;
global_settings { assumed_gamma 1.8 adc_bailout 1/255 irid_wavelength color rgb <0.7,.52,.48> hf_gray_16 off number_of_waves 8
 radiosity { brightness 3.3 count 20 distance_maximum 4 error_bound 0.6 gray_threshold 0.4 low_error_factor 0.75 minimum_reuse 0.02 nearest_count 3 recursion_limit 1 } }
camera { location <0,1,-5> look_at 0 angle 40 }
light_source { <4,5,-5> color rgb 1 media_interaction off media_attenuation on }
sphere { 0, 1 pigment { rgbf 1 } interior { ior 1.5 caustics 1.0 fade_distance 2 fade_power 2 media { absorption .3 scattering { 1, rgb .2 extinction .7 } intervals 3 samples 1,4 method 2 } } hollow }
plane { y,-1 pigment { checker rgb 1 rgb 0 } }
