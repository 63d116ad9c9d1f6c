// Finishes and normals of the reference, each on a ball over a floor of tiles.
// verisim render docs/language/textures.pov +W704 +H330 +A0.1 +Odocs/language/textures.png
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 subsurface { samples 60, 30 } mm_per_unit 12 }

#declare Columns = 8;
#declare Rows = 3;
camera { orthographic location <Columns/2, -Rows*1.25/2, -20> right (Columns + 0.2)*x up (Rows*1.25 + 0.2)*y direction z }
light_source { <-12, 30, -60>, rgb 1.1 }
sky_sphere { pigment { gradient y color_map { [0 srgb <0.50, 0.45, 0.40>] [0.5 srgb <0.93, 0.93, 0.92>] [1 srgb <0.45, 0.60, 0.80>] } translate -0.5*y scale 2 } }
#declare Base = srgb <0.80, 0.42, 0.24>;
#default { finish { ambient 0.08 diffuse 0.75 } }

#declare Names = array[24] {
  "ambient", "emission", "diffuse", "brilliance", "phong", "specular", "metallic", "crand",
  "reflection", "fresnel", "ior", "fade_color", "irid", "subsurface", "filter", "transmit",
  "bumps", "dents", "ripples", "waves", "wrinkles", "facets", "normal_map", "slope_map" }
#declare Look = array[24] {
  texture { pigment { Base } finish { ambient 0.6 diffuse 0.3 } },
  texture { pigment { Base } finish { ambient 0 diffuse 0 emission 1 } },
  texture { pigment { Base } },
  texture { pigment { Base } finish { brilliance 5 } },
  texture { pigment { Base } finish { phong 0.9 phong_size 25 } },
  texture { pigment { Base } finish { specular 0.9 roughness 0.01 } },
  texture { pigment { Base } finish { diffuse 0.4 specular 1 roughness 0.03 metallic reflection { 0.35 metallic } } },
  texture { pigment { Base } finish { crand 0.35 } },
  texture { pigment { srgb 0.05 } finish { diffuse 0.1 reflection 0.85 specular 0.6 roughness 0.005 } },
  texture { pigment { Base } finish { diffuse 0.6 reflection { 0, 1 fresnel on } specular 0.6 roughness 0.005 } },
  texture { pigment { rgbt <1, 1, 1, 0.96> } finish { diffuse 0 ambient 0 reflection { 0, 1 fresnel on } conserve_energy specular 0.6 roughness 0.005 } },
  texture { pigment { rgbt 1 } finish { diffuse 0 ambient 0 reflection { 0, 1 fresnel on } conserve_energy specular 0.6 roughness 0.005 } },
  texture { pigment { srgb 0.25 } finish { diffuse 0.4 irid { 0.6 thickness 0.6 turbulence 0.4 } specular 0.5 reflection 0.15 } },
  texture { pigment { srgb <0.95, 0.85, 0.75> } finish { diffuse 0.7 subsurface { translucency <0.9, 0.5, 0.3> } specular 0.4 roughness 0.02 } },
  texture { pigment { rgbf <0.9, 0.5, 0.2, 0.85> } finish { diffuse 0.3 specular 0.5 } },
  texture { pigment { rgbt <0.9, 0.5, 0.2, 0.75> } finish { diffuse 0.6 } },
  texture { pigment { Base } normal { bumps 0.7 scale 0.15 } finish { specular 0.4 roughness 0.03 } },
  texture { pigment { Base } normal { dents 1.2 scale 0.3 } finish { specular 0.4 roughness 0.03 } },
  texture { pigment { Base } normal { ripples 0.7 scale 0.25 } finish { specular 0.4 roughness 0.03 } },
  texture { pigment { Base } normal { waves 0.7 scale 0.2 } finish { specular 0.4 roughness 0.03 } },
  texture { pigment { Base } normal { wrinkles 1.2 scale 0.3 } finish { specular 0.4 roughness 0.03 } },
  texture { pigment { Base } normal { facets coords 0.4 } finish { specular 0.5 roughness 0.03 } },
  texture { pigment { Base } normal { gradient y normal_map { [0.4 bumps 0 ] [0.6 bumps 1.2 scale 0.12] } translate -0.5*y scale 2.2 } finish { specular 0.4 roughness 0.03 } },
  texture { pigment { Base } normal { gradient x 0.8 slope_map { [0 <0, 1>] [0.5 <1, 1>] [0.5 <1, -1>] [1 <0, -1>] } scale 0.25 } finish { specular 0.4 roughness 0.03 } } }

#for (I, 0, 23)
  #local Middle = <mod(I, Columns) + 0.5, -div(I, Columns)*1.25 - 0.5, 0>;
  union {
    sphere { 0, 0.95 texture { Look[I] }
      #if (I = 10 | I = 11) interior { ior 1.5 #if (I = 11) fade_color <0.2, 0.7, 0.45> fade_distance 0.7 fade_power 1001 #end } #end }
    box { <-1.05, -1.1, -1.2>, <1.05, -0.98, 1.2> pigment { checker srgb <0.16, 0.47, 0.58> srgb 0.92 scale 0.35 translate 0.01 } }
    box { <-1.05, -1.1, 1.15>, <1.05, 1.1, 1.2> pigment { checker srgb <0.75, 0.78, 0.80> srgb 0.92 scale 0.35 translate 0.01 } }
    rotate -12*x scale 0.41 translate Middle
  }
  text { internal 2 Names[I] 0.01, 0 scale 0.13 translate Middle + <-0.4, -0.7, -3>
    pigment { srgb <0.1, 0.12, 0.16> } finish { ambient 0 diffuse 0 emission 1 } no_shadow }
#end
