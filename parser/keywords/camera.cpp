// Cameras.
#include "parser/keywords/keywords.h"

namespace verisim::parser {
namespace {

constexpr Keyword kCameraWords[] = {
    {"angle", "camera", "angle A [, B]", "about 67.4",
     "How wide the view is, in degrees; of ultra_wide_angle and spherical also how high."},
    {"aperture", "camera", "aperture A", "0",
     "The width of the lens: larger blurs more of what is not at focal_point."},
    {"blur_samples", "camera", "blur_samples [MIN,] MAX", "0", "How many rays a pixel with focal blur has."},
    {"bokeh", "camera", "bokeh { pigment { ... } }", "a disc",
     "The shape and colours of blurred lights, as a pigment over the unit square."},
    {"camera", "scene value #default", "camera { [KIND] location P look_at P angle A }", "at the origin, along z",
     "Where the picture is seen from."},
    {"confidence", "camera", "confidence A", "0.9",
     "How sure the mean of a blurred pixel must be before sampling ends."},
    {"cylinder", "camera", "cylinder 1|2|3|4", "",
     "A view onto a cylinder; 1 and 3 have an upright axis, 2 and 4 a level one."},
    {"direction", "camera", "direction V", "z",
     "Where the camera looks before look_at turns it; its length is the focal length where no angle is set."},
    {"fisheye", "camera", "fisheye", "", "A round picture of up to 360 degrees."},
    {"focal_point", "camera", "focal_point P", "<0, 0, 0>", "What is as far away as this point is sharp."},
    {"location", "camera", "location P", "<0, 0, 0>", "Where the camera is."},
    {"look_at", "camera", "look_at P", "", "What is in the middle of the picture."},
    {"mesh_camera", "camera", "mesh_camera { RAYS, DISTRIBUTION OBJECT ... [smooth] }", "",
     "Rays start on the faces of meshes: for baking."},
    {"omnimax", "camera", "omnimax", "", "A view for dome projections."},
    {"orthographic", "camera", "orthographic", "", "Parallel rays: no perspective."},
    {"panoramic", "camera", "panoramic", "", "A wide picture that keeps upright lines upright."},
    {"perspective", "camera", "perspective", "perspective", "The usual view through a pinhole."},
    {"right", "camera", "right V", "1.33*x",
     "Which way is right; its length is the shape of the picture: right x*image_width/image_height."},
    {"sky", "camera", "sky V", "y", "Which way is up for look_at; write it before."},
    {"smooth", "mesh_camera", "smooth", "off", "Rays follow the smooth normals of the mesh."},
    {"spherical", "camera", "spherical", "", "A view all around: longitude and latitude."},
    {"ultra_wide_angle", "camera", "ultra_wide_angle", "",
     "A view of up to 360 degrees across without the distortion of perspective."},
    {"up", "camera", "up V", "y", "Which way is up in the picture; its length is the shape of the picture."},
    {"variance", "camera", "variance A", "1/10000",
     "How much samples of a blurred pixel may differ before sampling ends."},
};

}  // namespace

const KeywordSection kCamera{"Cameras", "camera",
                             "One camera makes the picture; the last one counts. Items act in a fixed order, whatever "
                             "order they are written in, except transformations.",
                             kCameraWords};

}  // namespace verisim::parser
