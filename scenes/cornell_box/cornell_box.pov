// The Cornell box from its measured data (cornell_box.json in this folder): geometry in millimetres, spectra integrated to linear sRGB.
// README.md explains every number. Without radiosity, so that any renderer draws it the same way, pixel by pixel; the other forms (cornell_box_*.pov) declare what is
// different and include this file.
#version 3.7;

#ifndef (Interreflection) #declare Interreflection = "ambient"; #end  // or "none", "radiosity"
#ifndef (Spheres) #declare Spheres = false; #end                     // glass and mirror spheres in the place of the blocks
#ifndef (Max_Trace_Level) #declare Max_Trace_Level = 5; #end

global_settings {
  assumed_gamma 1
  max_trace_level Max_Trace_Level
  #if (strcmp(Interreflection, "radiosity") = 0)
    radiosity {
      pretrace_start 0.08 pretrace_end 0.01
      count 200 nearest_count 8 error_bound 0.4 recursion_limit 3 minimum_reuse 0.01 brightness 1
    }
  #end
}

// ---- Printed by `spectra cornell_box.json` -------------------------------------------------------------------------------------------
#declare Green_Reflectance = rgb <0.06885, 0.39811, 0.08673>;
#declare Red_Reflectance = rgb <0.49382, 0.04907, 0.05113>;
#declare White_Reflectance = rgb <0.73821, 0.73602, 0.73846>;
#declare Light_Color = rgb <1.67957, 0.87635, 0.22380>;
#declare Mean_Reflectance = rgb <0.46404, 0.44368, 0.39330>;
#declare Light_Reflectance = 0.78;
#declare Light_Area = 13650;
#declare Room_Area = 1.83969e+06;
// ---------------------------------------------------------------------------------------------------------------------------------------

// The form of wavelength bands: red, green and blue of the picture are bands 3 k, 3 k + 1 and 3 k + 2 of bands.inc.
#ifdef (Bands)
  #declare Green_Reflectance = rgb <Band_Green[3*Bands], Band_Green[3*Bands+1], Band_Green[3*Bands+2]>;
  #declare Red_Reflectance = rgb <Band_Red[3*Bands], Band_Red[3*Bands+1], Band_Red[3*Bands+2]>;
  #declare White_Reflectance = rgb <Band_White[3*Bands], Band_White[3*Bands+1], Band_White[3*Bands+2]>;
  #declare Light_Color = rgb <Band_Light[3*Bands], Band_Light[3*Bands+1], Band_Light[3*Bands+2]>;
#end

// Luminance of the light's surface. It sets the exposure; only ratios were measured.
#declare Luminance = 30;

// A Lambertian patch of radiance L and area A gives the irradiance L A cos cos' / r^2; a white Lambertian surface there has 1/pi of it as radiance.
// POV-Ray's light fades as 2 / (1 + (r/d)^2), nearly 2 d^2 / r^2 for r much larger than d = Fade; a spotlight of tightness 1 gives cos'.
#declare Fade = 10;
#declare Light_Strength = Light_Color * Luminance * Light_Area / (2 * pi * Fade * Fade);

// What the walls throw at each other, spread evenly: flux pi L A, of which the share m (the mean reflectance) goes on at every bounce,
// m + m^2 + ... = m / (1 - m), over the area of the room; again 1/pi of it as radiance.
#macro Bounced(M) (M / (1 - M)) #end
#declare Ambient = (strcmp(Interreflection, "ambient") = 0) * Luminance * Light_Area / Room_Area
                 * <Light_Color.red * Bounced(Mean_Reflectance.red), Light_Color.green * Bounced(Mean_Reflectance.green),
                    Light_Color.blue * Bounced(Mean_Reflectance.blue)>;

camera {  // 35 mm behind a film of 25 mm by 25 mm. The data is right-handed, the scene language left-handed: right is mirrored.
  location <278, 273, -800>
  direction 35 * z
  up 25 * y
  right -25 * x
}

light_source {  // the middle of the patch, 0.2 mm below it
  <278, 548.6, 279.5> color Light_Strength
  spotlight point_at <278, 0, 279.5> radius 90 falloff 90 tightness 1
  area_light 130 * x, 105 * z, 9, 9
  area_illumination on
  fade_distance Fade fade_power 2
}

#macro Quad(A, B, C, D)
  triangle { A, B, C }
  triangle { A, C, D }
#end

#macro Lambertian(Reflectance)
  texture { pigment { color Reflectance } finish { ambient rgb Ambient diffuse 1 } }
#end

mesh {  // floor, ceiling, back
  Quad(<552.8, 0, 0>, <0, 0, 0>, <0, 0, 559.2>, <549.6, 0, 559.2>)
  Quad(<556, 548.8, 0>, <556, 548.8, 559.2>, <0, 548.8, 559.2>, <0, 548.8, 0>)
  Quad(<549.6, 0, 559.2>, <0, 0, 559.2>, <0, 548.8, 559.2>, <556, 548.8, 559.2>)
  Lambertian(White_Reflectance)
}

mesh {  // right
  Quad(<0, 0, 559.2>, <0, 0, 0>, <0, 548.8, 0>, <0, 548.8, 559.2>)
  Lambertian(Green_Reflectance)
}

mesh {  // left
  Quad(<552.8, 0, 0>, <549.6, 0, 559.2>, <556, 548.8, 559.2>, <556, 548.8, 0>)
  Lambertian(Red_Reflectance)
}

mesh {  // the light: measured in the plane of the ceiling, here 0.1 mm below it, or the two would share their place
  Quad(<343, 548.8, 227>, <343, 548.8, 332>, <213, 548.8, 332>, <213, 548.8, 227>)
  translate -0.1 * y
  texture { pigment { color rgb Light_Reflectance } finish { ambient 0 diffuse 1 emission Light_Color * Luminance } }
  no_radiosity  // its light is that of the light source
}

#if (Spheres)
  sphere {
    <186, 100, 169>, 100
    pigment { rgbt 1 }
    finish { ambient 0 diffuse 0 reflection { rgb 0, rgb 1 fresnel on } conserve_energy }
    interior { ior 1.5 }
  }
  sphere {
    <368, 120, 351>, 120
    pigment { rgb 0 }
    finish { ambient 0 diffuse 0 reflection { rgb 0.95 } }
  }
#else
mesh {  // short block
  Quad(<130, 165, 65>, <82, 165, 225>, <240, 165, 272>, <290, 165, 114>)
  Quad(<290, 0, 114>, <290, 165, 114>, <240, 165, 272>, <240, 0, 272>)
  Quad(<130, 0, 65>, <130, 165, 65>, <290, 165, 114>, <290, 0, 114>)
  Quad(<82, 0, 225>, <82, 165, 225>, <130, 165, 65>, <130, 0, 65>)
  Quad(<240, 0, 272>, <240, 165, 272>, <82, 165, 225>, <82, 0, 225>)
  Lambertian(White_Reflectance)
}

mesh {  // tall block
  Quad(<423, 330, 247>, <265, 330, 296>, <314, 330, 456>, <472, 330, 406>)
  Quad(<423, 0, 247>, <423, 330, 247>, <472, 330, 406>, <472, 0, 406>)
  Quad(<472, 0, 406>, <472, 330, 406>, <314, 330, 456>, <314, 0, 456>)
  Quad(<314, 0, 456>, <314, 330, 456>, <265, 330, 296>, <265, 0, 296>)
  Quad(<265, 0, 296>, <265, 330, 296>, <423, 330, 247>, <423, 0, 247>)
  Lambertian(White_Reflectance)
}
#end
