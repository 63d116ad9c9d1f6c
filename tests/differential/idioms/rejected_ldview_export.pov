// In the manner of LDView: declarations guarded by #ifndef, parts as macros of colours, seams by scaling about a centre.
#version 3.6;
#ifndef (LDXShads) #declare LDXShads = on; #end
#ifndef (LDXFloor) #declare LDXFloor = off; #end
#ifndef (LDXQual) #declare LDXQual = 3; #end
#ifndef (LDXSW) #declare LDXSW = 0.5; #end
#ifndef (LDXStuds) #declare LDXStuds = 1; #end
#ifndef (LDXOpaqueNormal) #declare LDXOpaqueNormal = normal { bumps 0.001 scale 0.5 } #end
#declare L3Logo = false;
#macro LDXSeamMatrix(Width, Height, Depth, CX, CY, CZ)
#local aw = 0; #local ah = 0; #local ad = 0; #local ax = 0; #local ay = 0; #local az = 0;
#if (Width != 0) #local aw = 1-LDXSW/Width; #local ax = LDXSW/(Width/CX); #end
#if (Height != 0) #local ah = 1-LDXSW/Height; #if (CY != 0) #local ay = LDXSW/(Height/CY); #end #end
#if (Depth != 0) #local ad = 1-LDXSW/Depth; #if (CZ != 0) #local az = LDXSW/(Depth/CZ); #end #end
#if (aw <= 0) #local aw = 1; #local ax = 0; #end
matrix <aw,0,0,0,ah,0,0,0,ad,ax,ay,az>
#end
#macro LDXOpaqueColor(r, g, b)
#if (LDXQual > 1)
material { texture { pigment { rgb <r,g,b> } #if (version >= 3.1) finish { ambient 0.4 diffuse 0.4 } #end finish { phong 0.5 phong_size 40 reflection { 0.05 } } normal { LDXOpaqueNormal } } }
#else
material { texture { pigment { rgb <r,g,b> filter 0 } finish { ambient 0.6 } } }
#end
#end
#ifndef (LDXColor4) // Red
#declare LDXColor4 = #if (1) material { texture { pigment { rgb <0.788235,0.101961,0.035294> } finish { ambient 0.4 diffuse 0.4 } } } #end
#end
#declare stud_dot_dat =
#if (LDXStuds)
union {
	cylinder { <0,0,0>, <0,-4,0>, 6 }
	#if (L3Logo) torus { 4, 0.5 translate -4*y } #end
}
#else
sphere { <0,-2,0>, 0.0001 }
#end
#declare p3005_dot_dat = union {
	box { <-10,0,-10>, <10,24,10> }
	object { stud_dot_dat }
}
#macro Brick(c, tx, ty, tz)
object {
	p3005_dot_dat
	LDXSeamMatrix(20, 28, 20, 0.001, 10, 0)
	matrix <1,0,0,0,1,0,0,0,1,tx,ty,tz>
	c
}
#end
#declare TheModel = union {
	object { p3005_dot_dat LDXSeamMatrix(20,28,20,1e-5,10,0) matrix <1,0,0,0,1,0,0,0,1,0,-24,0> material { LDXColor4 } }
	Brick(LDXOpaqueColor(0,0.333333,0.74902), 20, -24, 0)
	Brick(LDXOpaqueColor(0.9,0.8,0.1), 10, -48, 0)
}
#declare TheModel = object { TheModel #if (!LDXShads) no_shadow #end }
object { TheModel }
#if (LDXFloor) plane { y, 0 hollow pigment { rgb 0.8 } } #end
background { color rgb <1,1,1> }
camera {
	#declare LDXPersp = 1;
	#if (LDXPersp) perspective #else orthographic #end
	location < -70,-100,-120 > sky < 0,-1,0 > right -4/3 * x up y look_at < 8,-28,0 > angle 40
}
light_source { <-150,-250,-200> color rgb <1,1,1> #if (!LDXShads) shadowless #end }
light_source { <150,-100,-250> color rgb <.4,.4,.5> shadowless }
