// Pictures in scenes: image_map and its like.
#include "parser/keywords/keywords.h"

namespace verisim::parser {
namespace {

constexpr Keyword kImageWords[] = {
    {"all", "+transmit +filter", "image_map { ... transmit all A | filter all A }", "",
     "All colours of the picture's palette become transparent."},
    {"bmp", "@image", "bmp \"file.bmp\"", "", "The picture is a BMP file."},
    {"bump_map", "normal", "bump_map { [TYPE] \"picture\" ITEM ... }", "",
     "Bumps by the brightness of a picture, laid on the unit square in x and y."},
    {"exr", "@image", "exr \"file.exr\"", "", "The picture is an OpenEXR file: linear, with high range."},
    {"function", "@image", "function WIDTH, HEIGHT { EXPRESSION }", "",
     "The picture is computed from a function, pigment or pattern."},
    {"gamma", "+png +jpeg +tga +bmp +tiff +gif", "png \"file.png\" gamma A|srgb", "what the file says",
     "How the numbers of the file turn into light."},
    {"gif", "@image", "gif \"file.gif\"", "", "The picture is a GIF file."},
    {"hdr", "@image", "hdr \"file.hdr\"", "", "The picture is a Radiance file: linear, with high range."},
    {"iff", "@image", "iff \"file.iff\"", "", "An old format of pictures; not supported."},
    {"image_map", "pigment", "image_map { [TYPE] \"picture\" ITEM ... }", "",
     "The colours of a picture, laid on the unit square in x and y and repeated."},
    {"interpolate", "@texel", "interpolate 0|2|3|4", "0",
     "Blends between pixels: 2 bilinear, 3 bicubic, 4 normalised distance."},
    {"jpeg", "@image", "jpeg \"file.jpg\"", "", "The picture is a JPEG file."},
    {"map_type", "@texel", "map_type 0|1|2|5|7", "0",
     "What the picture is laid around: 0 a plane, 1 a ball, 2 a cylinder, 5 a ring, 7 a mirror ball."},
    {"material_map", "texture", "material_map { [TYPE] \"picture\" ITEM ... TEXTURE ... }", "",
     "A picture whose numbers choose among textures."},
    {"offset", "@texel", "offset <U, V>", "0", "Moves the picture on the unit square."},
    {"once", "@texel", "once", "repeated", "The picture is laid once; around it nothing is drawn."},
    {"pgm", "@image", "pgm \"file.pgm\"", "", "The picture is a PGM file (grey)."},
    {"png", "@image", "png \"file.png\"", "", "The picture is a PNG file."},
    {"pot", "@image", "pot \"file.pot\"", "", "A picture of fractint, a GIF file with 16 bits: for height fields."},
    {"ppm", "@image", "ppm \"file.ppm\"", "", "The picture is a PPM file."},
    {"premultiplied", "+png +jpeg +tga +bmp +tiff +gif", "png \"file.png\" premultiplied BOOL", "what the format says",
     "Whether the colours of transparent pixels are already dimmed."},
    {"repeat", "@texel", "repeat <U, V>", "1", "How often the picture is repeated on the unit square."},
    {"sys", "@image", "sys \"file\"", "BMP", "The picture is of the kind that the system likes best; BMP."},
    {"tga", "@image", "tga \"file.tga\"", "", "The picture is a TGA file."},
    {"tiff", "@image", "tiff \"file.tif\"", "", "The picture is a TIFF file."},
    {"use_alpha", "image_pattern", "use_alpha", "", "The pattern is the transparency of the picture."},
    {"use_color", "@texel", "use_color", "",
     "Bumps and choices follow the colour of a pixel, not its number in the palette."},
    {"use_colour", "@texel", "use_colour", "", "The same as use_color."},
    {"use_index", "@texel", "use_index", "", "Bumps and choices follow the number of the colour in the palette."},
};

}  // namespace

const KeywordSection kImages{
    "Pictures in scenes", "images",
    "Pictures colour surfaces, bend normals, choose textures and make heights. The type before the file name may be "
    "left out where the extension says it.",
    kImageWords};

}  // namespace verisim::parser
