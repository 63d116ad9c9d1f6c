// The one table of reserved words.
#include "parser/lexer/words.h"

#include <array>

namespace verisim::parser {
namespace {

using enum WordClass;
constexpr WordEntry kWords[] = {
    {"aa_level", Word::aa_level, keyword}, {"aa_threshold", Word::aa_threshold, keyword}, {"abs", Word::abs, float_function},
    {"absorption", Word::absorption, keyword}, {"accuracy", Word::accuracy, keyword}, {"acos", Word::acos, float_function},
    {"acosh", Word::acosh, float_function}, {"adaptive", Word::adaptive, keyword}, {"adc_bailout", Word::adc_bailout, keyword},
    {"agate", Word::agate, keyword}, {"agate_turb", Word::agate_turb, keyword}, {"albedo", Word::albedo, keyword}, {"all", Word::all, keyword},
    {"all_intersections", Word::all_intersections, keyword}, {"alpha", Word::alpha, color}, {"altitude", Word::altitude, keyword},
    {"always_sample", Word::always_sample, keyword}, {"ambient", Word::ambient, keyword}, {"ambient_light", Word::ambient_light, keyword},
    {"angle", Word::angle, keyword}, {"anisotropy", Word::anisotropy, keyword}, {"aoi", Word::aoi, keyword}, {"aperture", Word::aperture, keyword},
    {"append", Word::append, keyword}, {"arc_angle", Word::arc_angle, keyword}, {"area_illumination", Word::area_illumination, keyword},
    {"area_light", Word::area_light, keyword}, {"array", Word::array, keyword}, {"asc", Word::asc, float_function}, {"ascii", Word::ascii, keyword},
    {"asin", Word::asin, float_function}, {"asinh", Word::asinh, float_function}, {"assumed_gamma", Word::assumed_gamma, keyword},
    {"atan", Word::atan, float_function}, {"atan2", Word::atan2, float_function}, {"atanh", Word::atanh, float_function},
    {"autostop", Word::autostop, keyword}, {"average", Word::average, keyword}, {"b_spline", Word::b_spline, keyword},
    {"background", Word::background, keyword}, {"bezier_spline", Word::bezier_spline, keyword}, {"bicubic_patch", Word::bicubic_patch, keyword},
    {"bitwise_and", Word::bitwise_and, float_function}, {"bitwise_or", Word::bitwise_or, float_function},
    {"bitwise_xor", Word::bitwise_xor, float_function}, {"black_hole", Word::black_hole, keyword}, {"blob", Word::blob, keyword},
    {"blue", Word::blue, color}, {"blur_samples", Word::blur_samples, keyword}, {"bmp", Word::bmp, keyword}, {"bokeh", Word::bokeh, keyword},
    {"bounded_by", Word::bounded_by, keyword}, {"box", Word::box, keyword}, {"boxed", Word::boxed, keyword}, {"bozo", Word::bozo, keyword},
    {"break", Word::break_, keyword}, {"brick", Word::brick, keyword}, {"brick_size", Word::brick_size, keyword},
    {"brightness", Word::brightness, keyword}, {"brilliance", Word::brilliance, keyword}, {"bump_map", Word::bump_map, keyword},
    {"bump_size", Word::bump_size, keyword}, {"bumps", Word::bumps, keyword}, {"camera", Word::camera, keyword}, {"case", Word::case_, keyword},
    {"caustics", Word::caustics, keyword}, {"ceil", Word::ceil, float_function}, {"cells", Word::cells, keyword},
    {"charset", Word::charset, keyword}, {"checker", Word::checker, keyword}, {"chr", Word::chr, string_function},
    {"circular", Word::circular, keyword}, {"clipped_by", Word::clipped_by, keyword}, {"clock", Word::clock, float_function},
    {"clock_on", Word::clock_on, float_function}, {"collect", Word::collect, keyword}, {"color", Word::color, color},
    {"color_map", Word::color_map, keyword}, {"colour", Word::color, color}, {"colour_map", Word::color_map, keyword},
    {"component", Word::component, keyword}, {"composite", Word::composite, keyword}, {"concat", Word::concat, string_function},
    {"cone", Word::cone, keyword}, {"confidence", Word::confidence, keyword}, {"conic_sweep", Word::conic_sweep, keyword},
    {"conserve_energy", Word::conserve_energy, keyword}, {"contained_by", Word::contained_by, keyword}, {"control0", Word::control0, keyword},
    {"control1", Word::control1, keyword}, {"coords", Word::coords, keyword}, {"cos", Word::cos, float_function},
    {"cosh", Word::cosh, float_function}, {"count", Word::count, keyword}, {"crackle", Word::crackle, keyword}, {"crand", Word::crand, keyword},
    {"cube", Word::cube, keyword}, {"cubic", Word::cubic, keyword}, {"cubic_spline", Word::cubic_spline, keyword},
    {"cubic_wave", Word::cubic_wave, keyword}, {"cutaway_textures", Word::cutaway_textures, keyword}, {"cylinder", Word::cylinder, keyword},
    {"cylindrical", Word::cylindrical, keyword}, {"datetime", Word::datetime, string_function}, {"debug", Word::debug, keyword},
    {"declare", Word::declare, keyword}, {"default", Word::default_, keyword}, {"defined", Word::defined, float_function},
    {"degrees", Word::degrees, float_function}, {"density", Word::density, keyword}, {"density_file", Word::density_file, keyword},
    {"density_map", Word::density_map, keyword}, {"dents", Word::dents, keyword}, {"deprecated", Word::deprecated, keyword},
    {"df3", Word::df3, keyword}, {"difference", Word::difference, keyword}, {"diffuse", Word::diffuse, keyword},
    {"dimension_size", Word::dimension_size, float_function}, {"dimensions", Word::dimensions, float_function},
    {"direction", Word::direction, keyword}, {"disc", Word::disc, keyword}, {"dispersion", Word::dispersion, keyword},
    {"dispersion_samples", Word::dispersion_samples, keyword}, {"dist_exp", Word::dist_exp, keyword}, {"distance", Word::distance, keyword},
    {"div", Word::div, float_function}, {"double_illuminate", Word::double_illuminate, keyword}, {"dtag", Word::dtag, keyword},
    {"eccentricity", Word::eccentricity, keyword}, {"else", Word::else_, keyword}, {"elseif", Word::elseif, keyword},
    {"emission", Word::emission, keyword}, {"end", Word::end, keyword}, {"error", Word::error, keyword}, {"error_bound", Word::error_bound, keyword},
    {"evaluate", Word::evaluate, keyword}, {"exp", Word::exp, float_function}, {"expand_thresholds", Word::expand_thresholds, keyword},
    {"exponent", Word::exponent, keyword}, {"exr", Word::exr, keyword}, {"exterior", Word::exterior, keyword},
    {"extinction", Word::extinction, keyword}, {"face_indices", Word::face_indices, keyword}, {"facets", Word::facets, keyword},
    {"fade_color", Word::fade_color, keyword}, {"fade_colour", Word::fade_color, keyword}, {"fade_distance", Word::fade_distance, keyword},
    {"fade_power", Word::fade_power, keyword}, {"falloff", Word::falloff, keyword}, {"falloff_angle", Word::falloff_angle, keyword},
    {"false", Word::false_, float_function}, {"fclose", Word::fclose, keyword}, {"file_exists", Word::file_exists, float_function},
    {"filter", Word::filter, color}, {"finish", Word::finish, keyword}, {"fisheye", Word::fisheye, keyword}, {"flatness", Word::flatness, keyword},
    {"flip", Word::flip, keyword}, {"floor", Word::floor, float_function}, {"focal_point", Word::focal_point, keyword}, {"fog", Word::fog, keyword},
    {"fog_alt", Word::fog_alt, keyword}, {"fog_offset", Word::fog_offset, keyword}, {"fog_type", Word::fog_type, keyword},
    {"fopen", Word::fopen, keyword}, {"for", Word::for_, keyword}, {"form", Word::form, keyword}, {"frequency", Word::frequency, keyword},
    {"fresnel", Word::fresnel, keyword}, {"function", Word::function, keyword}, {"gamma", Word::gamma, keyword}, {"gather", Word::gather, keyword},
    {"gif", Word::gif, keyword}, {"global_lights", Word::global_lights, keyword}, {"global_settings", Word::global_settings, keyword},
    {"gradient", Word::gradient, keyword}, {"granite", Word::granite, keyword}, {"gray", Word::gray, color},
    {"gray_threshold", Word::gray_threshold, keyword}, {"green", Word::green, color}, {"hdr", Word::hdr, keyword},
    {"height_field", Word::height_field, keyword}, {"hexagon", Word::hexagon, keyword}, {"hf_gray_16", Word::hf_gray_16, keyword},
    {"hierarchy", Word::hierarchy, keyword}, {"hollow", Word::hollow, keyword}, {"hypercomplex", Word::hypercomplex, keyword},
    {"if", Word::if_, keyword}, {"ifdef", Word::ifdef, keyword}, {"iff", Word::iff, keyword}, {"ifndef", Word::ifndef, keyword},
    {"image_map", Word::image_map, keyword}, {"image_pattern", Word::image_pattern, keyword}, {"importance", Word::importance, keyword},
    {"include", Word::include, keyword}, {"inside", Word::inside, float_function}, {"inside_vector", Word::inside_vector, keyword},
    {"int", Word::int_, float_function}, {"interior", Word::interior, keyword}, {"interior_texture", Word::interior_texture, keyword},
    {"internal", Word::internal, keyword}, {"interpolate", Word::interpolate, keyword}, {"intersection", Word::intersection, keyword},
    {"intervals", Word::intervals, keyword}, {"inverse", Word::inverse, keyword}, {"ior", Word::ior, keyword}, {"irid", Word::irid, keyword},
    {"irid_wavelength", Word::irid_wavelength, keyword}, {"isosurface", Word::isosurface, keyword}, {"jitter", Word::jitter, keyword},
    {"jpeg", Word::jpeg, keyword}, {"julia", Word::julia, keyword}, {"julia_fractal", Word::julia_fractal, keyword},
    {"lambda", Word::lambda, keyword}, {"lathe", Word::lathe, keyword}, {"leopard", Word::leopard, keyword},
    {"light_group", Word::light_group, keyword}, {"light_source", Word::light_source, keyword}, {"linear_spline", Word::linear_spline, keyword},
    {"linear_sweep", Word::linear_sweep, keyword}, {"ln", Word::ln, float_function}, {"load_file", Word::load_file, keyword},
    {"local", Word::local, keyword}, {"location", Word::location, keyword}, {"log", Word::log, float_function}, {"look_at", Word::look_at, keyword},
    {"looks_like", Word::looks_like, keyword}, {"low_error_factor", Word::low_error_factor, keyword}, {"macro", Word::macro, keyword},
    {"magnet", Word::magnet, keyword}, {"major_radius", Word::major_radius, keyword}, {"mandel", Word::mandel, keyword},
    {"map_type", Word::map_type, keyword}, {"marble", Word::marble, keyword}, {"material", Word::material, keyword},
    {"material_map", Word::material_map, keyword}, {"matrix", Word::matrix, keyword}, {"max", Word::max, float_function},
    {"max_extent", Word::max_extent, vector_function}, {"max_gradient", Word::max_gradient, keyword},
    {"max_intersections", Word::max_intersections, keyword}, {"max_iteration", Word::max_iteration, keyword},
    {"max_sample", Word::max_sample, keyword}, {"max_trace", Word::max_trace, keyword}, {"max_trace_level", Word::max_trace_level, keyword},
    {"maximum_reuse", Word::maximum_reuse, keyword}, {"media", Word::media, keyword}, {"media_attenuation", Word::media_attenuation, keyword},
    {"media_interaction", Word::media_interaction, keyword}, {"merge", Word::merge, keyword}, {"mesh", Word::mesh, keyword},
    {"mesh2", Word::mesh2, keyword}, {"mesh_camera", Word::mesh_camera, keyword}, {"metallic", Word::metallic, keyword},
    {"method", Word::method, keyword}, {"metric", Word::metric, keyword}, {"min", Word::min, float_function},
    {"min_extent", Word::min_extent, vector_function}, {"minimum_reuse", Word::minimum_reuse, keyword}, {"mm_per_unit", Word::mm_per_unit, keyword},
    {"mod", Word::mod, float_function}, {"mortar", Word::mortar, keyword}, {"natural_spline", Word::natural_spline, keyword},
    {"nearest_count", Word::nearest_count, keyword}, {"no", Word::no, float_function}, {"no_bump_scale", Word::no_bump_scale, keyword},
    {"no_image", Word::no_image, keyword}, {"no_radiosity", Word::no_radiosity, keyword}, {"no_reflection", Word::no_reflection, keyword},
    {"no_shadow", Word::no_shadow, keyword}, {"noise_generator", Word::noise_generator, keyword}, {"normal", Word::normal, keyword},
    {"normal_indices", Word::normal_indices, keyword}, {"normal_map", Word::normal_map, keyword}, {"normal_vectors", Word::normal_vectors, keyword},
    {"now", Word::now, float_function}, {"number_of_sides", Word::number_of_sides, keyword}, {"number_of_tiles", Word::number_of_tiles, keyword},
    {"number_of_waves", Word::number_of_waves, keyword}, {"object", Word::object, keyword}, {"octaves", Word::octaves, keyword},
    {"off", Word::off, float_function}, {"offset", Word::offset, keyword}, {"omega", Word::omega, keyword}, {"omnimax", Word::omnimax, keyword},
    {"on", Word::on, float_function}, {"once", Word::once, keyword}, {"onion", Word::onion, keyword}, {"open", Word::open, keyword},
    {"orient", Word::orient, keyword}, {"orientation", Word::orientation, keyword}, {"orthographic", Word::orthographic, keyword},
    {"ovus", Word::ovus, keyword}, {"panoramic", Word::panoramic, keyword}, {"parallel", Word::parallel, keyword},
    {"parametric", Word::parametric, keyword}, {"pass_through", Word::pass_through, keyword}, {"pattern", Word::pattern, keyword},
    {"pavement", Word::pavement, keyword}, {"perspective", Word::perspective, keyword}, {"pgm", Word::pgm, keyword}, {"phase", Word::phase, keyword},
    {"phong", Word::phong, keyword}, {"phong_size", Word::phong_size, keyword}, {"photons", Word::photons, keyword},
    {"pi", Word::pi, float_function}, {"pigment", Word::pigment, keyword}, {"pigment_map", Word::pigment_map, keyword},
    {"pigment_pattern", Word::pigment_pattern, keyword}, {"planar", Word::planar, keyword}, {"plane", Word::plane, keyword},
    {"png", Word::png, keyword}, {"point_at", Word::point_at, keyword}, {"poly", Word::poly, keyword}, {"poly_wave", Word::poly_wave, keyword},
    {"polygon", Word::polygon, keyword}, {"polynomial", Word::polynomial, keyword}, {"pot", Word::pot, keyword}, {"pow", Word::pow, float_function},
    {"ppm", Word::ppm, keyword}, {"precision", Word::precision, keyword}, {"precompute", Word::precompute, keyword},
    {"premultiplied", Word::premultiplied, keyword}, {"pretrace_end", Word::pretrace_end, keyword},
    {"pretrace_start", Word::pretrace_start, keyword}, {"prism", Word::prism, keyword}, {"prod", Word::prod, float_function},
    {"projected_through", Word::projected_through, keyword}, {"pwr", Word::pwr, keyword}, {"quadratic_spline", Word::quadratic_spline, keyword},
    {"quadric", Word::quadric, keyword}, {"quartic", Word::quartic, keyword}, {"quaternion", Word::quaternion, keyword},
    {"quick_color", Word::quick_color, keyword}, {"quick_colour", Word::quick_color, keyword}, {"quilted", Word::quilted, keyword},
    {"radial", Word::radial, keyword}, {"radians", Word::radians, float_function}, {"radiosity", Word::radiosity, keyword},
    {"radius", Word::radius, keyword}, {"rainbow", Word::rainbow, keyword}, {"ramp_wave", Word::ramp_wave, keyword},
    {"rand", Word::rand, float_function}, {"range", Word::range, keyword}, {"ratio", Word::ratio, keyword}, {"read", Word::read, keyword},
    {"reciprocal", Word::reciprocal, keyword}, {"recursion_limit", Word::recursion_limit, keyword}, {"red", Word::red, color},
    {"reflection", Word::reflection, keyword}, {"reflection_exponent", Word::reflection_exponent, keyword},
    {"refraction", Word::refraction, keyword}, {"render", Word::render, keyword}, {"repeat", Word::repeat, keyword}, {"rgb", Word::rgb, color},
    {"rgbf", Word::rgbf, color}, {"rgbft", Word::rgbft, color}, {"rgbt", Word::rgbt, color}, {"right", Word::right, keyword},
    {"ripples", Word::ripples, keyword}, {"rotate", Word::rotate, keyword}, {"roughness", Word::roughness, keyword},
    {"samples", Word::samples, keyword}, {"save_file", Word::save_file, keyword}, {"scale", Word::scale, keyword},
    {"scallop_wave", Word::scallop_wave, keyword}, {"scattering", Word::scattering, keyword}, {"seed", Word::seed, float_function},
    {"select", Word::select, float_function}, {"shadowless", Word::shadowless, keyword}, {"sin", Word::sin, float_function},
    {"sine_wave", Word::sine_wave, keyword}, {"sinh", Word::sinh, float_function}, {"sint16be", Word::sint16be, keyword},
    {"sint16le", Word::sint16le, keyword}, {"sint32be", Word::sint32be, keyword}, {"sint32le", Word::sint32le, keyword},
    {"sint8", Word::sint8, keyword}, {"size", Word::size, keyword}, {"sky", Word::sky, keyword}, {"sky_sphere", Word::sky_sphere, keyword},
    {"slice", Word::slice, keyword}, {"slope", Word::slope, keyword}, {"slope_map", Word::slope_map, keyword}, {"smooth", Word::smooth, keyword},
    {"smooth_triangle", Word::smooth_triangle, keyword}, {"solid", Word::solid, keyword}, {"sor", Word::sor, keyword},
    {"spacing", Word::spacing, keyword}, {"specular", Word::specular, keyword}, {"sphere", Word::sphere, keyword},
    {"sphere_sweep", Word::sphere_sweep, keyword}, {"spherical", Word::spherical, keyword}, {"spiral1", Word::spiral1, keyword},
    {"spiral2", Word::spiral2, keyword}, {"spline", Word::spline, keyword}, {"split_union", Word::split_union, keyword},
    {"spotlight", Word::spotlight, keyword}, {"spotted", Word::spotted, keyword}, {"sqr", Word::sqr, keyword}, {"sqrt", Word::sqrt, float_function},
    {"square", Word::square, keyword}, {"srgb", Word::srgb, color}, {"srgbf", Word::srgbf, color}, {"srgbft", Word::srgbft, color},
    {"srgbt", Word::srgbt, color}, {"statistics", Word::statistics, keyword}, {"steps", Word::steps, keyword}, {"str", Word::str, string_function},
    {"strcmp", Word::strcmp, float_function}, {"strength", Word::strength, keyword}, {"strlen", Word::strlen, float_function},
    {"strlwr", Word::strlwr, string_function}, {"strupr", Word::strupr, string_function}, {"sturm", Word::sturm, keyword},
    {"substr", Word::substr, string_function}, {"subsurface", Word::subsurface, keyword}, {"sum", Word::sum, float_function},
    {"superellipsoid", Word::superellipsoid, keyword}, {"switch", Word::switch_, keyword}, {"sys", Word::sys, keyword},
    {"t", Word::t, vector_function}, {"tan", Word::tan, float_function}, {"tanh", Word::tanh, float_function}, {"target", Word::target, keyword},
    {"text", Word::text, keyword}, {"texture", Word::texture, keyword}, {"texture_list", Word::texture_list, keyword},
    {"texture_map", Word::texture_map, keyword}, {"tga", Word::tga, keyword}, {"thickness", Word::thickness, keyword},
    {"threshold", Word::threshold, keyword}, {"tiff", Word::tiff, keyword}, {"tightness", Word::tightness, keyword}, {"tile2", Word::tile2, keyword},
    {"tiles", Word::tiles, keyword}, {"tiling", Word::tiling, keyword}, {"tolerance", Word::tolerance, keyword},
    {"toroidal", Word::toroidal, keyword}, {"torus", Word::torus, keyword}, {"trace", Word::trace, vector_function},
    {"transform", Word::transform, keyword}, {"translate", Word::translate, keyword}, {"translucency", Word::translucency, keyword},
    {"transmit", Word::transmit, color}, {"triangle", Word::triangle, keyword}, {"triangle_wave", Word::triangle_wave, keyword},
    {"triangular", Word::triangular, keyword}, {"true", Word::true_, float_function}, {"ttf", Word::ttf, keyword},
    {"turb_depth", Word::turb_depth, keyword}, {"turbulence", Word::turbulence, keyword}, {"type", Word::type, keyword},
    {"u", Word::u, vector_function}, {"u_steps", Word::u_steps, keyword}, {"uint16be", Word::uint16be, keyword},
    {"uint16le", Word::uint16le, keyword}, {"uint8", Word::uint8, keyword}, {"ultra_wide_angle", Word::ultra_wide_angle, keyword},
    {"undef", Word::undef, keyword}, {"union", Word::union_, keyword}, {"up", Word::up, keyword}, {"use_alpha", Word::use_alpha, keyword},
    {"use_color", Word::use_color, keyword}, {"use_colour", Word::use_color, keyword}, {"use_index", Word::use_index, keyword},
    {"utf8", Word::utf8, keyword}, {"uv_indices", Word::uv_indices, keyword}, {"uv_mapping", Word::uv_mapping, keyword},
    {"uv_vectors", Word::uv_vectors, keyword}, {"v", Word::v, vector_function}, {"v_steps", Word::v_steps, keyword},
    {"val", Word::val, float_function}, {"variance", Word::variance, keyword}, {"vaxis_rotate", Word::vaxis_rotate, vector_function},
    {"vcross", Word::vcross, vector_function}, {"vdot", Word::vdot, float_function}, {"version", Word::version, float_function},
    {"vertex_vectors", Word::vertex_vectors, keyword}, {"vlength", Word::vlength, float_function}, {"vnormalize", Word::vnormalize, vector_function},
    {"vrotate", Word::vrotate, vector_function}, {"vstr", Word::vstr, string_function}, {"vturbulence", Word::vturbulence, vector_function},
    {"warning", Word::warning, keyword}, {"warp", Word::warp, keyword}, {"water_level", Word::water_level, keyword}, {"waves", Word::waves, keyword},
    {"while", Word::while_, keyword}, {"width", Word::width, keyword}, {"wood", Word::wood, keyword}, {"wrinkles", Word::wrinkles, keyword},
    {"write", Word::write, keyword}, {"x", Word::x, vector_function}, {"xyz", Word::xyz, keyword}, {"y", Word::y, vector_function},
    {"yes", Word::yes, float_function}, {"z", Word::z, vector_function}};

// Index by Word into kWords (the first spelling).
constexpr auto kByWord = [] {
  std::array<std::uint16_t, std::size(kWords) + 1> index{};
  for (std::size_t i = std::size(kWords); i-- > 0;) index[static_cast<std::size_t>(kWords[i].word)] = static_cast<std::uint16_t>(i + 1);
  return index;
}();

const WordEntry* entry(Word word) {
  const std::uint16_t i = static_cast<std::size_t>(word) < kByWord.size() ? kByWord[static_cast<std::size_t>(word)] : std::uint16_t{0};
  return i ? &kWords[i - 1] : nullptr;
}

}  // namespace

std::span<const WordEntry> all_words() { return kWords; }

std::string_view spelling(Word word) {
  const WordEntry* e = entry(word);
  return e ? e->text : std::string_view{};
}

WordClass word_class(Word word) {
  const WordEntry* e = entry(word);
  return e ? e->word_class : keyword;
}

}  // namespace verisim::parser
