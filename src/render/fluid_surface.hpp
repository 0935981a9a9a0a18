#pragma once

#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "render/camera_view.hpp"
#include "render/colour_map.hpp"
#include "render/field.hpp"
#include "render/float_target.hpp"
#include "render/gl_object.hpp"
#include "render/offscreen_target.hpp"
#include "render/shader_program.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace eisph {

/// A particle that the surface is made of.
struct SurfaceVertex {
  Vec3f position;  ///< m
  float value;     ///< of the field that colours it
  float radius;    ///< m
};

/// A piece of water that light passes through.
struct WaterPiece {
  Vec3f position;  ///< m
  float volume;    ///< over that of a cube of the spacing
};

/// The water of a state in pieces: its particles, or slices of its columns where it has columns, as their
/// particles are only those that can be seen. `floor` is the height of the floor, m.
[[nodiscard]] std::vector<WaterPiece> water_pieces(const Snapshot& snapshot, double floor);

/// Radius (m) of a particle's sphere: in the water so large that those of a thin sheet still touch, of a lone
/// drop nearly that of its own volume. `number_density` is normalised, `spacing` in metres.
[[nodiscard]] float surface_sphere_radius(float number_density, double spacing);

/// What the surface is made of and looks like.
struct FluidLook {
  double spacing = 0.0;      ///< m, of the particles
  double depth_scale = 1.0;  ///< m, thickness at which the water's tint is clear
  bool has_field = false;    ///< coloured by the values of the particles; else as water
  FieldScale scale;          ///< of the field
  bool dark = false;         ///< the page, and so what the water mirrors
};

/// Draws particles as the surface of transparent water (three dimensions): the distances of their spheres are
/// smoothed on the screen and lit. W. van der Laan, S. Green and M. Sainz, Screen space fluid rendering with
/// curvature flow, I3D 2009; the smoothing is that of N. Truong and C. Yuksel 2018.
class FluidSurface {
 public:
  FluidSurface(const GlFunctions& gl, const std::filesystem::path& shaders);

  /// The picture in `opaque` with the water in it, and its depth. `samples_per_pixel` along one axis. `shown`
  /// has the particles that can be seen, `all` the water that light passes through.
  const OffscreenTarget& draw(const OffscreenTarget& opaque, const CameraView& camera, int samples_per_pixel,
                              const std::vector<SurfaceVertex>& shown, const std::vector<WaterPiece>& all,
                              const ColourMap& map, const FluidLook& look);

 private:
  void fit(int width, int height, int samples_per_pixel);
  void draw_distances(const CameraView& camera, float focal_length,
                      const std::vector<SurfaceVertex>& shown) const;
  void smooth(const CameraView& camera, float focal_length, float spacing) const;
  void draw_thickness(const OffscreenTarget& opaque, const CameraView& camera, float focal_length,
                      const std::vector<WaterPiece>& all, float spacing) const;
  void compose(const OffscreenTarget& opaque, const CameraView& camera, float focal_length,
               const ColourMap& map, const FluidLook& look) const;

  const GlFunctions& gl_;
  ShaderProgram distance_program_;
  ShaderProgram smooth_program_;
  ShaderProgram thickness_program_;
  ShaderProgram composite_program_;
  GlVertexArray shown_array_;
  GlVertexArray all_array_;
  GlVertexArray screen_array_;
  GlBuffer shown_vertices_;
  GlBuffer all_vertices_;
  GlTexture colour_map_;
  int thickness_factor_ = 1;  ///< samples of the picture per sample of the thickness, along each axis
  std::optional<FloatTarget> distances_;
  std::optional<FloatTarget> smoothed_;
  std::optional<FloatTarget> thickness_;
  std::optional<OffscreenTarget> result_;
};

}  // namespace eisph
