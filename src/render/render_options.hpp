#pragma once

#include "render/gl_context.hpp"

namespace eisph {

/// How particle pictures are drawn; the defaults are meant for frames.
struct ParticlePictureOptions {
  bool cull_interior = true;  ///< leave out particles that other particles hide
  int samples_per_pixel = 2;  ///< along each axis
  bool depth_shading = true;  ///< darken what lies behind its surroundings (three dimensions)
  ContextKind context = ContextKind::Automatic;
};

}  // namespace eisph
