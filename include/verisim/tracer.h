// verisim's ray tracer: a scene description in, a picture out (docs/embedding.md).
//
// scene::Scene is a description, made by hand or by the parser (verisim/parser.h); render::render makes a
// render::Framebuffer of it; image::to_picture and image::write turn that into what files hold.
#pragma once

#include "tracer/film/layers.h"
#include "tracer/image/formats/layers_file.h"
#include "tracer/image/output.h"
#include "tracer/image/in_memory.h"
#include "tracer/render/render.h"
#include "tracer/scene/scene.h"
