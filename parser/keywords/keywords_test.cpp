// The table of words against the lexer's list and, word by word and place by place, against the parser.
#include "parser/keywords/keywords.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "parser/lexer/lexer.h"
#include "parser/parse.h"

namespace verisim::parser {
namespace {

// SDL after which a place of the table is reached. A place may need several: some words stand only behind others.
struct Opening {
  std::string_view place, text;
};

const Opening kOpenings[] = {
    {"scene", ""},
    {"value", "#declare V_ = "},
    {"#default", "#default { "},
    {"sphere", "sphere { 0, 1 "},
    {"box", "box { 0, 1 "},
    {"plane", "plane { y, 0 "},
    {"cylinder", "cylinder { 0, y, 1 "},
    {"cone", "cone { 0, 1, y, 0 "},
    {"torus", "torus { 1, 0.2 "},
    {"disc", "disc { 0, y, 1 "},
    {"ovus", "ovus { 1, 0.5 "},
    {"superellipsoid", "superellipsoid { <1, 1> "},
    {"quadric", "quadric { <1,1,1>, <0,0,0>, <0,0,0>, -1 "},
    {"cubic", "cubic { <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,-1> "},
    {"quartic", "quartic { <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,-1> "},
    {"poly", "poly { 2, <1,0,0,0,1,0,0,1,0,-1> "},
    {"polynomial", "polynomial { 2, xyz(2,0,0):1 "},
    {"blob", "blob { "},
    {"blob", "blob { sphere { 0, 1, 1 } "},
    {"component", "blob { sphere { 0, 1, 1 "},
    {"component", "blob { cylinder { 0, y, 1, 1 "},
    {"bicubic_patch", "bicubic_patch { type 1 "},
    {"bicubic_patch",
     "bicubic_patch { type 1 <0,0,0>,<1,0,0>,<2,0,0>,<3,0,0>,<0,1,0>,<1,1,0>,<2,1,0>,<3,1,0>,<0,2,0>,<1,2,0>,<2,2,0>,"
     "<3,2,0>,<0,3,0>,<1,3,0>,<2,3,0>,<3,3,0> "},
    {"difference", "difference { sphere { 0, 1 } "},
    {"intersection", "intersection { sphere { 0, 1 } "},
    {"merge", "merge { sphere { 0, 1 } "},
    {"union", "union { sphere { 0, 1 } "},
    {"composite", "composite { sphere { 0, 1 } "},
    {"object", "object { "},
    {"object", "object { sphere { 0, 1 } "},
    {"height_field", "height_field { "},
    {"height_field", "height_field { function 4, 4 { x } "},
    {"isosurface", "isosurface { "},
    {"isosurface", "isosurface { function { x*x+y*y+z*z-1 } "},
    {"contained_by", "isosurface { function { x } contained_by { "},
    {"julia_fractal", "julia_fractal { <0,0,0,0> "},
    {"lathe", "lathe { "},
    {"lathe", "lathe { linear_spline 2, <0,0>, <1,1> "},
    {"sor", "sor { 4, <0,0>, <1,1>, <1,2>, <0,3> "},
    {"prism", "prism { "},
    {"prism", "prism { 0, 1, 4, <0,0>, <1,0>, <1,1>, <0,0> "},
    {"sphere_sweep", "sphere_sweep { "},
    {"sphere_sweep", "sphere_sweep { linear_spline 2, 0, 1, y, 1 "},
    {"light_group", "light_group { "},
    {"light_source", "light_source { 0, rgb 1 "},
    {"light_source", "light_source { 0, rgb 1 spotlight "},
    {"light_source", "light_source { 0, rgb 1 area_light x, y, 2, 2 "},
    {"light_source", "light_source { 0, rgb 1 area_light x, y, 2, 2 circular "},
    {"looks_like", "light_source { 0, rgb 1 looks_like { "},
    {"looks_like", "light_source { 0, rgb 1 looks_like { sphere { 0, 1 } "},
    {"projected_through", "light_source { 0, rgb 1 projected_through { "},
    {"light_photons", "light_source { 0, rgb 1 photons { "},
    {"object_photons", "sphere { 0, 1 photons { "},
    {"object_radiosity", "sphere { 0, 1 radiosity { "},
    {"mesh", "mesh { triangle { 0, x, y } "},
    {"mesh_triangle", "mesh { triangle { 0, x, y "},
    {"mesh_triangle", "mesh { smooth_triangle { 0, z, x, z, y, z "},
    {"mesh2", "mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0,1,2> } "},
    {"mesh2", "mesh2 { "},
    {"mesh2", "mesh2 { vertex_vectors { 3, 0, x, y } "},
    {"texture_list", "mesh2 { vertex_vectors { 3, 0, x, y } texture_list { 1, "},
    {"parametric", "parametric { "},
    {"parametric", "parametric { function { u } function { v } function { 0 } <0,0>, <1,1> "},
    {"polygon", "polygon { 4, <0,0>, <1,0>, <1,1>, <0,0> "},
    {"triangle", "triangle { 0, x, y "},
    {"smooth_triangle", "smooth_triangle { 0, z, x, z, y, z "},
    {"text", "text { "},
    {"text", "text { internal 1 \"A\" 1, 0 "},
    {"bounded_by", "sphere { 0, 1 bounded_by { "},
    {"clipped_by", "sphere { 0, 1 clipped_by { "},
    {"texture", "sphere { 0, 1 texture { "},
    {"texture", "sphere { 0, 1 texture { pigment { rgb 1 } "},
    {"texture", "sphere { 0, 1 texture { wood "},
    {"texture", "sphere { 0, 1 texture { wood texture_map { [0 pigment{rgb 1}] [1 pigment{rgb 1}] } "},
    {"pigment", "sphere { 0, 1 pigment { "},
    {"pigment", "sphere { 0, 1 pigment { wood "},
    {"normal", "sphere { 0, 1 normal { "},
    {"normal", "sphere { 0, 1 normal { bumps 1 "},
    {"normal", "sphere { 0, 1 normal { facets "},
    {"density", "media { density { "},
    {"density", "media { density { wood "},
    {"pigment", "sphere { 0, 1 pigment { agate "},
    {"pigment", "sphere { 0, 1 pigment { brick "},
    {"pigment", "sphere { 0, 1 pigment { quilted "},
    {"pigment", "sphere { 0, 1 pigment { crackle "},
    {"pigment", "sphere { 0, 1 pigment { julia <0, 0>, 9 "},
    {"pigment", "sphere { 0, 1 pigment { pavement "},
    {"normal", "sphere { 0, 1 normal { agate "},
    {"normal", "sphere { 0, 1 normal { brick "},
    {"normal", "sphere { 0, 1 normal { quilted "},
    {"normal", "sphere { 0, 1 normal { crackle "},
    {"normal", "sphere { 0, 1 normal { julia <0, 0>, 9 "},
    {"normal", "sphere { 0, 1 normal { pavement "},
    {"density", "media { density { agate "},
    {"density", "media { density { brick "},
    {"density", "media { density { quilted "},
    {"density", "media { density { crackle "},
    {"density", "media { density { julia <0, 0>, 9 "},
    {"density", "media { density { pavement "},
    {"texture", "sphere { 0, 1 texture { agate texture_map { [0 pigment{rgb 1}] [1 pigment{rgb 1}] } "},
    {"texture", "sphere { 0, 1 texture { quilted texture_map { [0 pigment{rgb 1}] [1 pigment{rgb 1}] } "},
    {"texture", "sphere { 0, 1 texture { crackle texture_map { [0 pigment{rgb 1}] [1 pigment{rgb 1}] } "},
    {"texture", "sphere { 0, 1 texture { julia <0, 0>, 9 texture_map { [0 pigment{rgb 1}] [1 pigment{rgb 1}] } "},
    {"texture", "sphere { 0, 1 texture { pavement texture_map { [0 pigment{rgb 1}] [1 pigment{rgb 1}] } "},
    {"texture", "sphere { 0, 1 texture { tiles { texture { pigment { rgb 1 } } "},
    {"texture", "sphere { 0, 1 texture { brick texture { pigment { rgb 1 } } texture { pigment { rgb 0 } } mortar 1 "},
    {"texture",
     "sphere { 0, 1 texture { density_file df3 \"voxels.df3\" texture_map { [0 pigment{rgb 1}] [1 pigment{rgb 1}] } "},
    {"pigment", "sphere { 0, 1 pigment { density_file df3 \"voxels.df3\" "},
    {"normal", "sphere { 0, 1 normal { density_file df3 \"voxels.df3\" "},
    {"density", "media { density { density_file df3 \"voxels.df3\" "},
    {"finish", "sphere { 0, 1 finish { "},
    {"reflection", "sphere { 0, 1 finish { reflection { 1 "},
    {"irid", "sphere { 0, 1 finish { irid { 0.1 "},
    {"finish_subsurface", "sphere { 0, 1 finish { subsurface { "},
    {"image_map", "sphere { 0, 1 pigment { image_map { "},
    {"image_map", "sphere { 0, 1 pigment { image_map { function 2, 2 { x } "},
    {"bump_map", "sphere { 0, 1 normal { bump_map { "},
    {"bump_map", "sphere { 0, 1 normal { bump_map { function 2, 2 { x } "},
    {"material_map", "sphere { 0, 1 texture { material_map { "},
    {"material_map", "sphere { 0, 1 texture { material_map { function 2, 2 { x } "},
    {"image_pattern", "sphere { 0, 1 pigment { image_pattern { "},
    {"image_pattern", "sphere { 0, 1 pigment { image_pattern { function 2, 2 { x } "},
    {"object_pattern", "sphere { 0, 1 pigment { object { "},
    {"warp", "sphere { 0, 1 pigment { wood warp { "},
    {"warp", "sphere { 0, 1 pigment { wood warp { turbulence 1 "},
    {"warp", "sphere { 0, 1 pigment { wood warp { repeat x "},
    {"warp", "sphere { 0, 1 pigment { wood warp { black_hole 0, 1 "},
    {"warp", "sphere { 0, 1 pigment { wood warp { cylindrical "},
    {"warp", "sphere { 0, 1 pigment { wood warp { toroidal "},
    {"interior", "sphere { 0, 1 interior { "},
    {"material", "sphere { 0, 1 material { "},
    {"media", "media { "},
    {"scattering", "media { scattering { 5, 1 "},
    {"camera", "camera { "},
    {"mesh_camera", "camera { mesh_camera { 1, 0 "},
    {"mesh_camera", "camera { mesh_camera { 1, 3 mesh { triangle { 0, x, y } } "},
    {"fog", "fog { "},
    {"rainbow", "rainbow { "},
    {"sky_sphere", "sky_sphere { "},
    {"global_settings", "global_settings { "},
    {"global_radiosity", "global_settings { radiosity { "},
    {"global_photons", "global_settings { photons { "},
    {"global_subsurface", "global_settings { subsurface { "},
    {"transform", "sphere { 0, 1 transform { "},
    {"spline", "#declare S_ = spline { "},
    {"function", "#declare F_ = function { "},
    {"function_pattern", "#declare F_ = function { pattern { "},
    {"+charset", "global_settings { charset "},
    {"+declare", "#declare "},
    {"+deprecated", "#declare deprecated "},
    {"+density_file", "sphere { 0, 1 pigment { density_file "},
    {"+diffuse", "sphere { 0, 1 finish { diffuse "},
    {"+phong", "sphere { 0, 1 finish { phong "},
    {"+specular", "sphere { 0, 1 finish { specular "},
    {"+magnet", "sphere { 0, 1 pigment { magnet 1 "},
    {"+slope", "sphere { 0, 1 pigment { slope { "},
    {"+slope", "sphere { 0, 1 pigment { slope { y "},
    {"+transmit", "sphere { 0, 1 pigment { image_map { function 2, 2 { x } transmit "},
    {"+filter", "sphere { 0, 1 pigment { image_map { function 2, 2 { x } filter "},
};

struct Complaint {
  int line = 0;
  Code code = Code::internal;
};

// The first error that a word behind an opening gives; the word is alone on line 3.
std::optional<Complaint> complaint(std::string_view opening, std::string_view word) {
  static const ParseOptions* const kOptions = [] {
    scene::DensityFileParams voxels;
    voxels.samples = std::make_shared<const std::vector<std::uint32_t>>(8, 1u);
    voxels.size[0] = voxels.size[1] = voxels.size[2] = 2;
    auto* options = new ParseOptions;
    options->files["voxels.df3"] = std::make_shared<const MemoryFile>(voxels);
    return options;
  }();
  const std::string text =
      "#version 3.7; global_settings { assumed_gamma 1 }\n" + std::string(opening) + "\n" + std::string(word) + "\n\n";
  const ParseResult result = parse_text(text, "", *kOptions);
  if (result.errors.empty()) return std::nullopt;
  return Complaint{result.errors.front().line, result.errors.front().code};
}

// A place, as it is known by what it answers to a word that nothing takes.
class Place {
 public:
  explicit Place(std::string_view opening) : opening_(opening), refusal_(complaint(opening, "steps")) {}
  bool good() const { return refusal_ && refusal_->line == 3; }
  bool takes(std::string_view word) const {
    const std::optional<Complaint> answer = complaint(opening_, word);
    if (!answer || answer->line != 3) return true;
    switch (answer->code) {
      case Code::unexpected_token:
      case Code::misplaced_keyword:
      case Code::misplaced_directive:
      case Code::missing_hash:
        return false;
      default:
        return answer->code != refusal_->code;
    }
  }

 private:
  std::string_view opening_;
  std::optional<Complaint> refusal_;
};

std::map<std::string_view, std::set<std::string_view>> places_by_word() {
  std::map<std::string_view, std::set<std::string_view>> places;
  for (const WordEntry& entry : all_words())
    for (const Keyword* use : keyword_uses(entry.text))
      for (const std::string_view place : places_of(*use)) places[entry.text].insert(place);
  return places;
}

TEST(Keywords, AreTheWordsOfTheLexer) {
  std::set<std::string_view> words, described;
  for (const WordEntry& entry : all_words()) words.insert(entry.text);
  for (const KeywordSection& section : keyword_sections())
    for (const Keyword& keyword : section.keywords) described.insert(keyword.word);
  EXPECT_EQ(words, described);
}

TEST(Keywords, HaveAMeaningAndASyntax) {
  for (const KeywordSection& section : keyword_sections())
    for (const Keyword& keyword : section.keywords) {
      EXPECT_TRUE(keyword.meaning.ends_with('.')) << keyword.word;
      EXPECT_TRUE(keyword.syntax.empty() || keyword.syntax.find(keyword.word) != std::string_view::npos)
          << keyword.word << ": " << keyword.syntax;
    }
}

TEST(Keywords, StandWhereTheParserTakesThemAndNowhereElse) {
  const auto places = places_by_word();
  std::map<std::string_view, std::vector<Place>> openings;
  for (const Opening& opening : kOpenings) {
    openings[opening.place].emplace_back(opening.text);
    EXPECT_TRUE(openings[opening.place].back().good()) << opening.text;
  }
  for (const auto& [place, texts] : openings) {
    std::string missing, extra;
    for (const WordEntry& entry : all_words()) {
      // Words of expressions stand wherever a number may: that is not a property of the block.
      if (entry.word_class != WordClass::keyword) continue;
      const bool taken = std::any_of(texts.begin(), texts.end(), [&](const Place& p) { return p.takes(entry.text); });
      const bool described = places.count(entry.text) && places.at(entry.text).count(place);
      if (taken && !described) missing += std::string(entry.text) + " ";
      if (!taken && described) extra += std::string(entry.text) + " ";
    }
    EXPECT_EQ(missing, "") << "the parser takes them in " << place;
    EXPECT_EQ(extra, "") << "the parser refuses them in " << place;
  }
}

TEST(Keywords, OfExpressionsAreThoseOfTheLexer) {
  for (const WordEntry& entry : all_words()) {
    bool in_expressions = false;
    for (const Keyword* use : keyword_uses(entry.text)) in_expressions |= may_stand(*use, "expression");
    EXPECT_EQ(in_expressions, entry.word_class != WordClass::keyword) << entry.text;
  }
}

TEST(Keywords, BehindAHashAreTheDirectivesOfTheLexer) {
  for (const WordEntry& entry : all_words()) {
    bool directive = false;
    for (const Keyword* use : keyword_uses(entry.text)) directive |= may_stand(*use, "#");
    Names names;
    const auto file = tokenise(std::make_shared<Source>("", "#" + std::string(entry.text)), names, 9);
    EXPECT_EQ(directive, file->tokens.front().kind == TokenKind::directive) << entry.text;
  }
}

TEST(Keywords, EveryPlaceIsTested) {
  std::set<std::string_view> tested{"#", "expression"};
  for (const Opening& opening : kOpenings) tested.insert(opening.place);
  for (const std::string_view place : all_places()) EXPECT_TRUE(tested.count(place)) << place;
}

TEST(Keywords, AreToldInTheTerminal) {
  EXPECT_EQ(keyword_text("ovus"),
            "ovus { BOTTOM_RADIUS, TOP_RADIUS }\n  An egg along the y axis.\n  In: wherever an object may stand.\n");
  EXPECT_EQ(keyword_text("no_such_word"), "");
}

TEST(Keywords, InAPlaceAreToldForThatPlace) {
  EXPECT_NE(keyword_markdown("emission", "media").find("per unit of length"), std::string::npos);
  EXPECT_EQ(keyword_markdown("emission", "finish").find("per unit of length"), std::string::npos);
}

}  // namespace
}  // namespace verisim::parser
