#include "render/particle_picture.hpp"

#include "core/assets.hpp"
#include "render/axis.hpp"
#include "render/particle_culling.hpp"

#include <algorithm>

namespace eisph {

namespace {

/// Sphere radius in particle spacings: large enough that a resting lattice has no holes.
constexpr float kSphereRadius = 0.58F;
constexpr float kDiscRadius = 0.5F;              ///< two dimensions: neighbours just touch
constexpr double kSphereOpacity = 0.3;           ///< shadow of a layer of water drawn as spheres
constexpr double kSurfaceOpacity = 0.10;         ///< and as transparent water, which is looked through
constexpr float kShadingStrength = 1.1F;         ///< of spheres
constexpr float kSurfaceShadingStrength = 0.4F;  ///< of transparent water, which has lights of its own
constexpr int kShadingReach = 3;                 ///< pixels

/// Of a particle drawn as a sphere, m.
float sphere_radius(const Snapshot& snapshot) {
  const float factor = snapshot.dimension == 3 ? kSphereRadius : kDiscRadius;
  return factor * static_cast<float>(snapshot.particle_spacing);
}

const GlFunctions& current(GlContext& context) {
  context.make_current();
  return context.functions();
}

void fit(std::optional<OffscreenTarget>& target, const GlFunctions& gl, int width, int height) {
  if (target && target->width() == width && target->height() == height) return;
  target.reset();
  target.emplace(gl, width, height);
}

}  // namespace

ParticlePicture::ParticlePicture(const Scene& scene, std::shared_ptr<GlContext> context,
                                 const ParticlePictureOptions& options)
    : scene_(scene),
      context_(std::move(context)),
      options_(options),
      grid_spacing_(round_down_nicely(0.2 * (scene.domain_max - scene.domain_min).head<2>().maxCoeff())),
      obstacles_(obstacle_mesh(scene)),
      particle_painter_(current(*context_), home_folder() / "shaders"),
      solid_painter_(context_->functions(), home_folder() / "shaders"),
      resolve_program_(context_->functions(), home_folder() / "shaders", "resolve"),
      resolve_array_(context_->functions()) {}

ParticlePicture::~ParticlePicture() { context_->make_current(); }

std::string ParticlePicture::context_description() const {
  context_->make_current();
  return context_->description();
}

const GlTexture& ParticlePicture::paint(const ImageSettings& settings, const CameraView& camera, int width,
                                        int height, const Snapshot& snapshot, const DepthGrid& depth,
                                        const BoundaryParticles& boundary, const ColourMap& map,
                                        const FieldScale& scale) {
  const GlFunctions& gl = current(*context_);
  const Palette colours = palette(settings.dark_background);
  fit(samples_, gl, options_.samples_per_pixel * width, options_.samples_per_pixel * height);
  fit(pixels_, gl, width, height);
  samples_->begin(colours.page);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_PROGRAM_POINT_SIZE);
  gl.DepthFunc(GL_LEQUAL);
  if (settings.draw_walls) draw_floor(settings, camera, colours, snapshot);
  if (settings.draw_obstacles && settings.field != "kind") {
    solid_painter_.set_clip(settings.clip);
    draw_solids(camera, colours, snapshot.time);
    solid_painter_.set_clip({});
  }
  draw_other_particles(settings, camera, snapshot, boundary);
  const OffscreenTarget* samples = &*samples_;
  if (settings.draw_fluid) {
    if (settings.style == WaterStyle::Surface && scene_.dimension == 3) {
      samples = &draw_surface(settings, camera, snapshot, depth, map, scale);
    } else {
      draw_particles(settings, camera, snapshot, depth, map, scale);
    }
  }
  if (settings.draw_walls) draw_walls(settings, camera, colours);
  const float shading = samples == &*samples_ ? kShadingStrength : kSurfaceShadingStrength;
  resolve(*samples, shading, camera, colours, width, height);
  return pixels_->colour();
}

Image ParticlePicture::read() const {
  context_->make_current();
  return pixels_->read();
}

void ParticlePicture::draw_floor(const ImageSettings& settings, const CameraView& camera,
                                 const Palette& colours, const Snapshot& snapshot) {
  if (scene_.dimension != 3) return;
  const std::filesystem::path shaders = home_folder() / "shaders";
  if (settings.shadow && !settings.clip) {  // what is cut away throws none
    if (!floor_painter_) floor_painter_.emplace(context_->functions(), shaders, scene_);
    const bool opaque = settings.style == WaterStyle::Spheres;
    const bool solids = settings.draw_obstacles && settings.field != "kind";
    floor_painter_->draw(camera, colours.floor,
                         ground_light(scene_, snapshot, solids, opaque ? kSphereOpacity : kSurfaceOpacity));
  } else {
    SolidMesh floor;
    add_floor(floor, scene_.domain_min.x(), scene_.domain_max.x(), scene_.domain_min.y(),
              scene_.domain_max.y(), scene_.domain_min.z());
    solid_painter_.draw_surface(camera, floor.triangles, colours.floor);
  }
  solid_painter_.draw_edges(camera, floor_grid(scene_, grid_spacing_), colours.grid,
                            0.9F * static_cast<float>(options_.samples_per_pixel), samples_->width(),
                            samples_->height());
}

void ParticlePicture::draw_walls(const ImageSettings& settings, const CameraView& camera,
                                 const Palette& colours) {
  if (settings.glass && scene_.dimension == 3) {
    if (!glass_painter_) {
      glass_painter_.emplace(context_->functions(), home_folder() / "shaders", scene_,
                             framed_bounds(scene_).upper.z());
    }
    glass_painter_->draw(camera, colours.glass);
  }
  draw_wall_edges(camera, colours);
}

void ParticlePicture::draw_wall_edges(const CameraView& camera, const Palette& colours) const {
  const bool flat = scene_.dimension == 2;
  const double top = flat ? scene_.domain_max.z() : framed_bounds(scene_).upper.z();
  // Without depth, so that the shading of the resolve pass does not take the lines for walls before the
  // water.
  const GlFunctions& gl = context_->functions();
  gl.DepthMask(GL_FALSE);
  solid_painter_.draw_edges(camera, wall_edges(scene_, top), flat ? colours.line : colours.faint,
                            1.2F * static_cast<float>(options_.samples_per_pixel), samples_->width(),
                            samples_->height());
  gl.DepthMask(GL_TRUE);
}

void ParticlePicture::draw_solids(const CameraView& camera, const Palette& colours, double time) const {
  const SolidMesh gates = gate_mesh(scene_, time);
  const auto width = 1.1F * static_cast<float>(options_.samples_per_pixel);
  for (const auto& [mesh, colour] :
       {std::pair(&obstacles_, colours.solid), std::pair(&gates, colours.gate)}) {
    solid_painter_.draw_surface(camera, mesh->triangles, colour);
    solid_painter_.draw_edges(camera, mesh->edges, mix(colour, Colour{}, 0.55F), width, samples_->width(),
                              samples_->height());
  }
}

/// Those that the camera can see of what is not cut away.
std::vector<std::uint32_t> ParticlePicture::particles_seen(const ImageSettings& settings,
                                                           const CameraView& camera,
                                                           const Snapshot& snapshot) const {
  // What hides others may be cut away.
  const bool cull = options_.cull_interior && snapshot.dimension == 3 && !settings.clip;
  return cull ? visible_particles(snapshot, camera, scene_.domain_min.z())
              : particles_within(snapshot, settings.clip);
}

void ParticlePicture::draw_particles(const ImageSettings& settings, const CameraView& camera,
                                     const Snapshot& snapshot, const DepthGrid& depth, const ColourMap& map,
                                     const FieldScale& scale) const {
  const std::vector<std::uint32_t> chosen = particles_seen(settings, camera, snapshot);
  const std::vector<float> values = field_values(settings.field, snapshot, depth, chosen);
  std::vector<ParticleVertex> vertices(chosen.size());
  for (std::size_t k = 0; k < chosen.size(); ++k) vertices[k] = {snapshot.position[chosen[k]], values[k]};
  particle_painter_.draw(*samples_, camera, options_.samples_per_pixel, vertices, sphere_radius(snapshot),
                         map, scale.lower, scale.upper);
}

/// Object, ghost and virtual particles, each sort in its own colour.
void ParticlePicture::draw_other_particles(const ImageSettings& settings, const CameraView& camera,
                                           const Snapshot& snapshot,
                                           const BoundaryParticles& boundary) const {
  const Palette colours = palette(settings.dark_background);
  const auto draw = [&](const std::vector<Vec3f>& positions, float radius, const Colour& colour) {
    std::vector<ParticleVertex> vertices;
    vertices.reserve(positions.size());
    for (const Vec3f& position : positions) {
      if (is_within(settings.clip, position)) vertices.push_back({position, 0.0F});
    }
    particle_painter_.draw(*samples_, camera, options_.samples_per_pixel, vertices, radius,
                           ColourMap::two_colours(colour, colour), 0.0, 1.0);
  };
  const float radius = sphere_radius(snapshot);
  const bool objects = settings.draw_objects || (settings.field == "kind" && settings.draw_obstacles);
  if (objects && snapshot.objects) draw(snapshot.objects->position, radius, colours.object_kind);
  draw(boundary.ghosts, radius, colours.ghost_kind);
  // Twice as many to a length.
  draw(boundary.virtual_particles, 0.5F * radius, colours.virtual_kind);
}

const OffscreenTarget& ParticlePicture::draw_surface(const ImageSettings& settings, const CameraView& camera,
                                                     const Snapshot& snapshot, const DepthGrid& depth,
                                                     const ColourMap& map, const FieldScale& scale) {
  if (!fluid_surface_) fluid_surface_.emplace(context_->functions(), home_folder() / "shaders");
  const std::vector<std::uint32_t> chosen = particles_seen(settings, camera, snapshot);
  const std::vector<float> values = field_values(settings.field, snapshot, depth, chosen);
  std::vector<SurfaceVertex> shown(chosen.size());
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const std::uint32_t i = chosen[k];
    shown[k] = {snapshot.position[i], values[k],
                surface_sphere_radius(snapshot.number_density[i], snapshot.particle_spacing)};
  }
  std::vector<WaterPiece> pieces = water_pieces(snapshot, scene_.domain_min.z());
  std::erase_if(pieces, [&](const WaterPiece& piece) { return !is_within(settings.clip, piece.position); });
  return fluid_surface_->draw(*samples_, camera, options_.samples_per_pixel, shown, pieces, map,
                              {.spacing = snapshot.particle_spacing,
                               .depth_scale = depth_scale(scene_),
                               .has_field = settings.field != "water",
                               .scale = scale,
                               .dark = settings.dark_background});
}

void ParticlePicture::resolve(const OffscreenTarget& samples, float shading, const CameraView& camera,
                              const Palette& colours, int width, int height) {
  const GlFunctions& gl = context_->functions();
  pixels_->begin(colours.page);
  gl.Disable(GL_DEPTH_TEST);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, samples.colour().name());
  gl.ActiveTexture(GL_TEXTURE0 + 1);
  gl.BindTexture(GL_TEXTURE_2D, samples.depth().name());
  const bool shade = options_.depth_shading && scene_.dimension == 3;
  // Reach and scale follow the picture, so that a frame looks alike at every size.
  const int reach = std::max(1, kShadingReach * std::min(width, height) / 600);
  resolve_program_.use();
  resolve_program_.set("samples", 0);
  resolve_program_.set("depth", 1);
  resolve_program_.set("projection", camera.projection());
  resolve_program_.set("factor", options_.samples_per_pixel);
  resolve_program_.set("reach", reach * options_.samples_per_pixel);
  resolve_program_.set("strength", shade ? shading : 0.0F);
  resolve_program_.set("scale", static_cast<float>(0.5 * depth_scale(scene_)));
  gl.BindVertexArray(resolve_array_.name());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.ActiveTexture(GL_TEXTURE0);
}

}  // namespace eisph
