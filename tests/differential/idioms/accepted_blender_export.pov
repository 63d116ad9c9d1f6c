//==================================================
//POV-Ray file exported by a modeller's script
//==================================================
#version 3.7; //Switches on the new formulas
global_settings{
    assumed_gamma 1.0
    max_trace_level 5
}
background {rgbft<0.05, 0.05, 0.05, 0, 0>}
#declare camLocation  = <7.48113155, 5.34366512, -6.50763988>;
#declare camLookAt = <-27.0, 27.0, 46.7>;
camera {
    location <0,0,0>
    look_at <0,0,-1>
    right <-1.7777777777777777, 0, 0>
    up <0, 1, 0>
    angle  49.134343
    rotate  <-26.4407, 46.6919, -0.0>
    translate <7.48113155, 5.34366512, 6.50763988>
}
light_source{ //  LALamp
    < 0,0,0 >
    color rgb<1, 1, 1>
    fade_distance 29.99998
    fade_power 2
    matrix <-0.29086, -0.05519, 0.95517, 0.9552, -0.19988, 0.27910, 0.17573, 0.97827, 0.11003, 4.07625, 5.90386, -1.00545>
}
#declare MATNone = finish { ambient 0 diffuse 0.8 }
#declare shader_MAMaterial = texture {
    pigment {rgbft<0.8, 0.2, 0.1, 0, 0.0>}
    finish { brilliance 0.9 diffuse albedo 0.8 specular albedo 0.3 roughness 0.0392 ambient 0.0 emission 0.0 conserve_energy }
}
#declare shader_MAGlass = texture {
    pigment {rgbf<0.9, 0.95, 1, 0.8>}
    finish { specular 0.7 roughness 0.003 diffuse 0.2 reflection { 0.05, 0.5 fresnel on falloff 1 } conserve_energy }
}
#declare DATAOBCube =
mesh2 {
    vertex_vectors {
        8,
        <1, 1, -1>, <1, -1, -1>, <-1, -1, -1>, <-1, 1, -1>, <1, 1, 1>, <1, -1, 1>, <-1, -1, 1>, <-1, 1, 1>
    }
    normal_vectors {
        6,
        <0, 0, -1>, <0, 0, 1>, <1, 0, 0>, <0, -1, 0>, <-1, 0, 0>, <0, 1, 0>
    }
    uv_vectors {
        4,
        <0.0, 0.0>, <1.0, 0.0>, <1.0, 1.0>, <0.0, 1.0>
    }
    texture_list {
        2, texture{shader_MAMaterial}, texture{pigment{uv_mapping checker rgb 1 rgb <.2,.4,.8> scale .25}finish{ambient .2}}
    }
    face_indices {
        12,
        <0,1,2>, 0, <0,2,3>, 0, <4,7,6>, 1, <4,6,5>, 1, <0,4,5>, 0, <0,5,1>, 0,
        <1,5,6>, 0,0,0, <1,6,2>, 0, <2,6,7>, 1, <2,7,3>, 1, <4,0,3>, 0, <4,3,7>, 0
    }
    normal_indices {
        12,
        <0,0,0>, <0,0,0>, <1,1,1>, <1,1,1>, <2,2,2>, <2,2,2>, <3,3,3>, <3,3,3>, <4,4,4>, <4,4,4>, <5,5,5>, <5,5,5>
    }
    uv_indices {
        12,
        <0,1,2>, <0,2,3>, <0,1,2>, <0,2,3>, <0,1,2>, <0,2,3>, <0,1,2>, <0,2,3>, <0,1,2>, <0,2,3>, <0,1,2>, <0,2,3>
    }
    inside_vector <0,0,1>
}
object {
    DATAOBCube
    interior { ior 1.0 }
    matrix <1,0,0, 0,1,0, 0,0,1, 0,0,0>
}
object {
    DATAOBCube
    texture { shader_MAGlass }
    interior { ior 1.5 fade_distance 2 fade_power 1001 fade_color rgb <.8,.9,1> caustics 0.2 }
    hollow
    matrix <.5,0,0, 0,.5,0, 0,0,.5, 2.5,-.5,1.5>
    photons { target reflection on refraction on collect off }
}
plane { <0,1,0>, -1.01 texture { shader_MAMaterial pigment { rgb .6 } } }
