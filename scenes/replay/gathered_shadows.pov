// Where radiosity gathers without media and fog, light loses nothing to them on its way to what is gathered either:
// not in the air, though the light asks for it, and not in what it shines through.
#version 3.7;
global_settings { radiosity { count 10 pretrace_start 0.08 pretrace_end 0.04 recursion_limit 1 } }
camera { location <0, 1, -6> }
light_source { <-4, 6, -5>, rgb <1, 0.9, 0.7> media_attenuation on }
light_source { <5, 6, -5>, rgb <0.2, 0.5, 0.9> }
media { absorption 0.1 }
fog { distance 30 rgb <0.1, 0.3, 0.2> }
#default { pigment { rgb 0.7 } }
sphere { 0, 1 }
sphere { <1, 1, 0>, 0.7 }
torus { 1.5, 0.3 rotate 20*x }
sphere { <1.5, 2.5, -2>, 1.2 hollow pigment { rgbt 1 } interior { media { absorption 0.5 } } }
