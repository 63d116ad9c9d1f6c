// The families of suspects, one file each. A function adds those that it finds worth a look, with their scores.
#pragma once

#include "compare/causes/case.h"

namespace verisim::compare {

using Suspicions = std::vector<Suspicion>;

// Values after the picture was made: brightness, gamma, offset, contrast, saturation, exchanged channels, clipping ...
void suspect_tone(const Case& c, Suspicions& out);
// The same for one part of the picture, whose name begins the details.
void suspect_tone_of(const Case& c, const std::string& name, const Mask& part, Suspicions& out);
// Where the camera looks: shift, zoom, stretching, rotation, mirror images.
void suspect_framing(const Case& c, Suspicions& out);
// What happens between neighbouring pixels: blur, sharpening, noise, coarse pixels, anti-aliasing.
void suspect_filtering(const Case& c, Suspicions& out);
// Rectangles, rows and columns; a part that is shifted; vignetting.
void suspect_regions(const Case& c, Suspicions& out);
// Few pixels: specks, NaN, edges, surfaces that coincide.
void suspect_specks(const Case& c, Suspicions& out);
// Objects that are missing, too much, moved, scaled, turned, of another shape or colour. Needs tags.
void suspect_objects(const Case& c, Suspicions& out);
// Terms of the colour: lights, highlights, ambient light, reflection, transparency, radiosity, photons, fog, media.
// Needs tags.
void suspect_terms(const Case& c, Suspicions& out);
// How much of the squared difference lies in the terms that the two programs tell; nothing where one does not.
std::optional<double> told_by_terms(const Case& c);
// What the wrong pixels show: patterns, normals, features. Needs tags.
void suspect_features(const Case& c, Suspicions& out);

}  // namespace verisim::compare
