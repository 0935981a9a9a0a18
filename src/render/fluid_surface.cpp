#include "render/fluid_surface.hpp"

#include "render/point_margin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace eisph {

namespace {

/// Reaches of the smoothing passes in particle spacings: two standard deviations of their Gaussians. A wide
/// reach has few taps: the narrow ones before it make them enough, and those after it take out their traces.
constexpr std::array kReaches{1.2F, 3.0F, 1.2F, 0.5F};
/// Distances that belong to one surface, in particle spacings.
constexpr float kRange = 3.0F;
constexpr double kSliceCells = 4.0;  ///< height of a slice of a column, cells
constexpr int kThicknessPixels = 2;  ///< pixels per sample of the thickness, along each axis

void bind_texture(const GlFunctions& gl, int unit, const GlTexture& texture) {
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl.BindTexture(GL_TEXTURE_2D, texture.name());
}

template <class Element>
void upload(const GlFunctions& gl, const GlBuffer& buffer, const std::vector<Element>& elements) {
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer.name());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(elements.size() * sizeof(Element)), elements.data(),
                GL_STREAM_DRAW);
}

}  // namespace

std::vector<WaterPiece> water_pieces(const Snapshot& snapshot, double floor) {
  std::vector<WaterPiece> pieces;
  if (!snapshot.columns) {
    pieces.reserve(snapshot.size());
    for (const Vec3f& position : snapshot.position) {
      if (position.allFinite()) pieces.push_back({position, 1.0F});
    }
    return pieces;
  }
  const ColumnField& field = *snapshot.columns;
  pieces.reserve(2 * field.size());
  for (std::size_t j = 0; j < field.rows; ++j) {
    for (std::size_t i = 0; i < field.columns; ++i) {
      const std::size_t cell = field.index(i, j);
      const double depth = field.depth[cell];
      const int slices = static_cast<int>(std::ceil(depth / (kSliceCells * field.cell_size)));
      const double height = depth / std::max(slices, 1);
      for (int k = 0; k < slices; ++k) {
        const Vec3d middle(field.origin_x + (static_cast<double>(i) + 0.5) * field.cell_size,
                           field.origin_y + (static_cast<double>(j) + 0.5) * field.cell_size,
                           floor + field.bed[cell] + (k + 0.5) * height);
        const double spacing = snapshot.particle_spacing;
        const double volume = height * field.cell_size * field.cell_size / (spacing * spacing * spacing);
        pieces.push_back({middle.cast<float>(), static_cast<float>(volume)});
      }
    }
  }
  return pieces;
}

float surface_sphere_radius(float number_density, double spacing) {
  const float crowd = std::clamp((number_density - 0.2F) / 0.4F, 0.0F, 1.0F);
  return (0.5F + 0.28F * crowd) * static_cast<float>(spacing);
}

FluidSurface::FluidSurface(const GlFunctions& gl, const std::filesystem::path& shaders)
    : gl_(gl),
      distance_program_(gl, shaders, "surface_depth"),
      smooth_program_(gl, shaders, "resolve", "surface_smooth"),
      thickness_program_(gl, shaders, "surface_thickness"),
      composite_program_(gl, shaders, "resolve", "surface_composite"),
      shown_array_(gl),
      all_array_(gl),
      screen_array_(gl),
      shown_vertices_(gl),
      all_vertices_(gl),
      colour_map_(gl) {
  gl.BindVertexArray(shown_array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, shown_vertices_.name());
  gl.EnableVertexAttribArray(0);
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(SurfaceVertex), nullptr);
  const std::array offsets{offsetof(SurfaceVertex, value), offsetof(SurfaceVertex, radius)};
  for (const GLuint k : {0U, 1U}) {
    gl.EnableVertexAttribArray(k + 1);
    gl.VertexAttribPointer(k + 1, 1, GL_FLOAT, GL_FALSE, sizeof(SurfaceVertex),
                           reinterpret_cast<const void*>(offsets[k]));
  }
  gl.BindVertexArray(all_array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, all_vertices_.name());
  gl.EnableVertexAttribArray(0);
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(WaterPiece), nullptr);
  gl.EnableVertexAttribArray(1);
  gl.VertexAttribPointer(1, 1, GL_FLOAT, GL_FALSE, sizeof(WaterPiece),
                         reinterpret_cast<const void*>(offsetof(WaterPiece, volume)));
  bind_texture(gl, 0, colour_map_);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void FluidSurface::fit(int width, int height, int samples_per_pixel) {
  if (result_ && result_->width() == width && result_->height() == height) return;
  for (std::optional<FloatTarget>* target : {&distances_, &smoothed_, &thickness_}) target->reset();
  result_.reset();
  thickness_factor_ = kThicknessPixels * samples_per_pixel;
  distances_.emplace(gl_, width, height, 2, FloatTarget::Depth::Buffer, GL_NEAREST);
  smoothed_.emplace(gl_, width, height, 2, FloatTarget::Depth::None, GL_NEAREST);
  const auto coarse = [this](int samples) { return (samples + thickness_factor_ - 1) / thickness_factor_; };
  thickness_.emplace(gl_, coarse(width), coarse(height), 1, FloatTarget::Depth::None, GL_LINEAR);
  result_.emplace(gl_, width, height);
}

const OffscreenTarget& FluidSurface::draw(const OffscreenTarget& opaque, const CameraView& camera,
                                          int samples_per_pixel, const std::vector<SurfaceVertex>& shown,
                                          const std::vector<WaterPiece>& all, const ColourMap& map,
                                          const FluidLook& look) {
  fit(opaque.width(), opaque.height(), samples_per_pixel);
  const auto focal_length = static_cast<float>(camera.focal_length() * samples_per_pixel);
  const auto spacing = static_cast<float>(look.spacing);
  gl_.Enable(GL_PROGRAM_POINT_SIZE);
  draw_distances(camera, focal_length, shown);
  gl_.Disable(GL_DEPTH_TEST);
  smooth(camera, focal_length, spacing);
  draw_thickness(opaque, camera, focal_length, all, spacing);
  compose(opaque, camera, focal_length, map, look);
  return *result_;
}

void FluidSurface::draw_distances(const CameraView& camera, float focal_length,
                                  const std::vector<SurfaceVertex>& shown) const {
  distances_->begin();
  if (shown.empty()) return;
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_LEQUAL);
  upload(gl_, shown_vertices_, shown);
  distance_program_.use();
  distance_program_.set("view", camera.view());
  distance_program_.set("projection", camera.projection());
  distance_program_.set("focal_length", focal_length);
  const PointMargin margin(gl_, distance_program_, distances_->width(), distances_->height());
  gl_.BindVertexArray(shown_array_.name());
  gl_.DrawArrays(GL_POINTS, 0, static_cast<GLsizei>(shown.size()));
}

void FluidSurface::smooth(const CameraView& camera, float focal_length, float spacing) const {
  smooth_program_.use();
  smooth_program_.set("surface", 0);
  smooth_program_.set("projection", camera.projection());
  smooth_program_.set("focal_length", focal_length);
  smooth_program_.set("range", kRange * spacing);
  gl_.BindVertexArray(screen_array_.name());
  for (const float reach : kReaches) {
    smooth_program_.set("reach", reach * spacing);
    for (const bool along_x : {true, false}) {
      const FloatTarget& from = along_x ? *distances_ : *smoothed_;
      const FloatTarget& to = along_x ? *smoothed_ : *distances_;
      to.bind();
      bind_texture(gl_, 0, from.texture());
      smooth_program_.set("direction", along_x ? 1.0F : 0.0F, along_x ? 0.0F : 1.0F);
      gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    }
  }
}

void FluidSurface::draw_thickness(const OffscreenTarget& opaque, const CameraView& camera, float focal_length,
                                  const std::vector<WaterPiece>& all, float spacing) const {
  thickness_->begin();
  if (all.empty()) return;
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_ONE, GL_ONE);
  upload(gl_, all_vertices_, all);
  bind_texture(gl_, 0, opaque.depth());
  thickness_program_.use();
  thickness_program_.set("view", camera.view());
  thickness_program_.set("projection", camera.projection());
  thickness_program_.set("spacing", spacing);
  thickness_program_.set("focal_length", focal_length / static_cast<float>(thickness_factor_));
  thickness_program_.set("opaque_depth", 0);
  thickness_program_.set("factor", thickness_factor_);
  const PointMargin margin(gl_, thickness_program_, thickness_->width(), thickness_->height());
  gl_.BindVertexArray(all_array_.name());
  gl_.DrawArrays(GL_POINTS, 0, static_cast<GLsizei>(all.size()));
  gl_.Disable(GL_BLEND);
}

void FluidSurface::compose(const OffscreenTarget& opaque, const CameraView& camera, float focal_length,
                           const ColourMap& map, const FluidLook& look) const {
  result_->begin(Colour{});
  // The depth is written, which takes an enabled test.
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_ALWAYS);
  bind_texture(gl_, 0, distances_->texture());
  bind_texture(gl_, 1, thickness_->texture());
  bind_texture(gl_, 2, opaque.colour());
  bind_texture(gl_, 3, opaque.depth());
  bind_texture(gl_, 4, colour_map_);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, ColourMap::kSize, 1, 0, GL_RGB, GL_FLOAT, map.table().data());
  const ShaderProgram& program = composite_program_;
  program.use();
  program.set("surface", 0);
  program.set("thickness", 1);
  program.set("opaque_colour", 2);
  program.set("opaque_depth", 3);
  program.set("colour_map", 4);
  program.set("view", camera.view());
  program.set("projection", camera.projection());
  program.set("size", static_cast<float>(result_->width()), static_cast<float>(result_->height()));
  program.set("focal_length", focal_length);
  program.set("depth_scale", static_cast<float>(look.depth_scale));
  program.set("spacing", static_cast<float>(look.spacing));
  program.set("lower", static_cast<float>(look.scale.lower));
  program.set("upper", static_cast<float>(look.scale.upper));
  program.set("has_field", look.has_field ? 1 : 0);
  program.set("zenith", look.dark ? Colour{0.62F, 0.72F, 0.82F} : Colour{0.93F, 0.97F, 1.0F});
  program.set("horizon", look.dark ? Colour{0.30F, 0.36F, 0.44F} : Colour{0.74F, 0.83F, 0.90F});
  program.set("body", look.dark ? Colour{0.24F, 0.58F, 0.76F} : Colour{0.06F, 0.34F, 0.52F});
  gl_.BindVertexArray(screen_array_.name());
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  gl_.DepthFunc(GL_LEQUAL);
  gl_.ActiveTexture(GL_TEXTURE0);
}

}  // namespace eisph
