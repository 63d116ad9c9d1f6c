#declare Lamp = light_source { 0, color rgb <1,.9,.7>*1.3 spotlight radius 12 falloff 22 tightness 3 point_at -y
  area_light <.4,0,0>,<0,0,.4>, 3, 3 adaptive 1
  looks_like { cone { .2*y,.1, -.1*y,.3 open pigment { rgb 1 } finish { ambient 1 } } } }
light_source { Lamp translate <-1.5,4,0> }
light_source { Lamp translate <1.5,4,.5> rotate 3*x }
light_group { light_source { <0,2,-6> rgb z*.8 } torus { .6, .2 translate <0,.3,-1> pigment { rgb 1 } } global_lights on }
box { <-4,-.2,-4>,<4,0,4> pigment { rgb .9 } }
cylinder { 0, y, .3 pigment { rgb <1,.2,.2> } }
camera { location <0,4,-7> look_at 0.8*y }
