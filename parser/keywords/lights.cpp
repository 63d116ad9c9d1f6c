// Light sources.
#include "parser/keywords/keywords.h"
#include "tracer/scene/light.h"

namespace verisim::parser {
namespace {

constexpr Keyword kLightWords[] = {
    {"adaptive", "light_source", "adaptive N", "",
     "Only as many lamps of an area light are asked as shadows need; larger numbers ask more."},
    {"area_illumination", "light_source", "area_illumination [BOOL]", "off",
     "An area light lights from all its lamps, not from its middle; shadows always do."},
    {"area_light", "light_source", "area_light AXIS, AXIS, N, M [adaptive A] [jitter] [circular] [orient]", "",
     "A grid of N by M lamps that throws soft shadows."},
    {"area_light", "light_photons", "photons { area_light }", "off", "Photons start from all over the area light."},
    {"circular", "light_source", "circular", "off", "The lamps of an area light lie on a disc instead of a square."},
    {"cylinder", "light_source", "cylinder radius R falloff F tightness T point_at P", "", "A beam of parallel sides."},
    {"fade_distance", "light_source", "fade_distance D", "0",
     "Where the light has its full strength when it fades; in the units of the scene."},
    {"fade_power", "light_source", "fade_power P", "0", "How the light fades with distance: 2 as in nature."},
    {"falloff", "light_source", "falloff A", "45 degrees, 1 in cylinder",
     "Where the beam is dark: half an angle, of cylinder a radius."},
    {"global_lights", "light_group", "global_lights [BOOL]", "off",
     "Lights outside the group shine on its objects, too."},
    {"jitter", "light_source", "jitter", "off", "Shakes the lamps of an area light, which turns stripes into grain."},
    {"light_source", "@object", "light_source { PLACE, COLOR ITEM ... }", "",
     "A lamp: a point, a spot, a beam, parallel light or an area."},
    {"looks_like", "light_source", "looks_like { OBJECT }", "",
     "Gives the lamp a shape; it throws no shadow of its own light."},
    {"media_attenuation", "light_source", "media_attenuation [BOOL]", "off",
     "The atmosphere's media weaken the light on its way."},
    {"media_interaction", "light_source", "media_interaction [BOOL]", "on", "Whether media scatter this light."},
    {"orient", "light_source", "orient", "off",
     "Turns the area light towards each point that it lights; needs circular."},
    {"parallel", "light_source", "parallel point_at P", "", "All rays run the same way, as those of the sun."},
    {"photons", "light_source light_group", "photons { reflection BOOL refraction BOOL [area_light] }", "",
     "Which photons this light sends out."},
    {"point_at", "light_source", "point_at P", "<0, 0, 1>", "Where a spot or beam points."},
    {"projected_through", "light_source", "projected_through { OBJECT }", "",
     "Only light that passes this object counts, and things between the two throw no shadow."},
    {"radius", "light_source", "radius A", "30 degrees, 0.75 in cylinder",
     "Where the beam begins to darken: half an angle, of cylinder a radius."},
    {"shadowless", "light_source", "shadowless", "", "The light passes through everything and makes no highlights."},
    {"spotlight", "light_source", "spotlight radius A falloff B tightness T point_at P", "", "A cone of light."},
    {"tightness", "light_source", "tightness A", "0", "How much the light of a beam gathers in its middle."},
};

#define VERISIM_LIGHT(name, words, beam)                                                            \
  static_assert(scene::LightKind::name == scene::LightKind::point || describes(kLightWords, #name), \
                "a light without description");
VERISIM_LIGHTS(VERISIM_LIGHT)
#undef VERISIM_LIGHT

}  // namespace

const KeywordSection kLights{
    "Lights", "lights", "Without a light_source only what shines by itself (ambient, emission, radiosity) is seen.",
    kLightWords};

}  // namespace verisim::parser
