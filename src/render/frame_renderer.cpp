#include "render/frame_renderer.hpp"

#include "core/error.hpp"
#include "render/axis.hpp"
#include "render/camera_view.hpp"
#include "render/depth_map.hpp"
#include "render/depth_profile.hpp"
#include "render/drawing.hpp"
#include "render/field.hpp"
#include "render/layout.hpp"
#include "render/particle_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace eisph {

namespace {

/// Two decimals, or as many as the time needs, up to five.
std::string time_text(double time) {
  int decimals = 2;
  const auto needs_more = [&] {
    const double scaled = time * std::pow(10.0, decimals);
    return std::abs(scaled - std::round(scaled)) > 1e-5;
  };
  while (decimals < 5 && needs_more()) ++decimals;
  return fmt::format("t = {:.{}f} s", time, decimals);
}

/// The image in another size. Its camera shows no less than before, to the sides and up and down.
ImageSettings resized(ImageSettings image, int width, int height) {
  if (image.camera) {
    const double fitting =
        std::min(static_cast<double>(height), static_cast<double>(width) * image.height / image.width);
    const double wider = height / fitting;
    const double half = 0.5 * image.camera->field_of_view * std::numbers::pi / 180.0;
    image.camera->field_of_view = 2.0 * std::atan(std::tan(half) * wider) * 180.0 / std::numbers::pi;
    image.camera->orthographic_height *= wider;
  }
  image.width = width;
  image.height = height;
  return image;
}

}  // namespace

class FrameRenderer::Parts {
 public:
  Parts(const Scene& scene, const ParticlePictureOptions& options, std::shared_ptr<GlContext> context)
      : scene_(scene), options_(options), context_(std::move(context)) {
    const auto particles = [](const ImageSettings& image) { return image.kind == ImageKind::Particles; };
    if (std::any_of(scene.images.begin(), scene.images.end(), particles)) particle_picture();
  }

  [[nodiscard]] std::string context_description() {
    return particle_picture_ ? particle_picture_->context_description() : std::string();
  }

  Image draw(const ImageSettings& settings, const Snapshot& snapshot, const DepthGrid& depth,
             const std::vector<GaugeCurve>& curves, const BoundaryParticles& boundary) {
    boundary_ = &boundary;
    const std::string time = time_text(snapshot.time);
    if (settings.kind == ImageKind::Panels) return draw_panels(settings, snapshot, depth, curves, time);
    return draw_frame(settings, snapshot, depth, time, 0, {});
  }

  GLuint paint(const ImageSettings& settings, const Snapshot& snapshot, const DepthGrid& depth,
               const BoundaryParticles& boundary, int width, int height) {
    const Camera camera = settings.camera ? *settings.camera : default_camera(scene_, height, width, height);
    const CameraView view(camera, height, width, height, drawn_bounds(scene_));
    return particle_picture()
        .paint(settings, view, width, height, snapshot, depth, boundary, map_of(settings),
               field_scale(scene_, settings))
        .name();
  }

  const ColourMap& colour_map(const std::string& name) {
    const auto found = colour_maps_.find(name);
    return found != colour_maps_.end() ? found->second
                                       : colour_maps_.emplace(name, ColourMap::load(name)).first->second;
  }

 private:
  ParticlePicture& particle_picture() {
    if (!particle_picture_) {
      if (!context_) context_ = create_context(options_.context);
      particle_picture_.emplace(scene_, context_, options_);
    }
    return *particle_picture_;
  }

  ColourMap map_of(const ImageSettings& settings) {
    const Palette colours = palette(settings.dark_background);
    const bool kinds = settings.kind == ImageKind::Particles && settings.field == "kind";
    return kinds ? ColourMap::two_colours(colours.fluid_kind, colours.object_kind)
                 : colour_map(colour_map_name(settings));
  }

  [[nodiscard]] const std::string& title() const { return scene_.title.empty() ? scene_.name : scene_.title; }

  /// A frame of one picture. Without a time there is no title either; a text height of 0 follows the frame.
  /// `marked` gauges are shown on depth maps.
  Image draw_frame(const ImageSettings& settings, const Snapshot& snapshot, const DepthGrid& depth,
                   const std::string& time, int text_height, const std::vector<std::string>& marked) {
    const FieldScale scale = field_scale(scene_, settings);
    const Palette colours = palette(settings.dark_background);
    const bool kinds = settings.kind == ImageKind::Particles && settings.field == "kind";
    const ColourMap map = map_of(settings);
    const FrameLayout layout = lay_out_frame(
        settings.width, settings.height, typeface_,
        {.time = time, .legend_label = scale.label, .caption = settings.caption, .text_height = text_height});
    Image frame(settings.width, settings.height);
    fill_rectangle(frame, {0, 0, frame.width, frame.height}, colours.page);
    const LengthScale length = draw_picture(frame, layout, settings, snapshot, depth, map, scale, marked);
    if (!time.empty()) draw_title(frame, layout, typeface_, colours, title(), time);
    draw_length_scale(frame, layout, typeface_, colours, length);
    draw_caption(frame, layout, typeface_, colours);
    if (kinds) {
      std::vector<std::pair<std::string, Colour>> sorts = {{"fluid", colours.fluid_kind},
                                                           {"object", colours.object_kind}};
      if (settings.draw_ghosts) sorts.emplace_back("ghost", colours.ghost_kind);
      if (settings.draw_virtual_particles) sorts.emplace_back("virtual", colours.virtual_kind);
      draw_kinds(frame, layout, typeface_, colours, scale.label, sorts);
    } else if (!scale.label.empty()) {
      const bool map_of_depth = settings.kind == ImageKind::DepthMap;
      const double bare_below = map_of_depth ? settings.dry_depth : std::numeric_limits<double>::lowest();
      draw_colour_bar(frame, layout, typeface_, colours, scale, map, bare_below, bare_ground(colours));
    }
    return frame;
  }

  [[nodiscard]] const ImageSettings& image_named(const std::string& name) const {
    const auto found = std::find_if(scene_.images.begin(), scene_.images.end(),
                                    [&name](const ImageSettings& image) { return image.name == name; });
    if (found == scene_.images.end() || found->kind == ImageKind::Panels) {
      throw InputError(fmt::format("{}: panels: the scene has no picture '{}' to draw as a panel",
                                   scene_.source_file, name));
    }
    return *found;
  }

  Image draw_panels(const ImageSettings& settings, const Snapshot& snapshot, const DepthGrid& depth,
                    const std::vector<GaugeCurve>& curves, const std::string& time) {
    const Palette colours = palette(settings.dark_background);
    const FrameLayout layout = lay_out_frame(settings.width, settings.height, typeface_,
                                             {.time = time, .caption = settings.caption});
    Image frame(settings.width, settings.height);
    fill_rectangle(frame, {0, 0, frame.width, frame.height}, colours.page);
    draw_title(frame, layout, typeface_, colours, title(), time);
    draw_caption(frame, layout, typeface_, colours);
    const PixelRectangle area{layout.picture.x, layout.picture.y, layout.picture.width,
                              layout.scale.bottom() - layout.picture.y};
    const std::size_t plots = settings.gauges.empty() ? 0 : 1;
    const std::vector<PixelRectangle> places =
        panel_places(area, settings.panels.size() + plots, layout.text_height);
    const int text = std::max(10, layout.text_height * 2 / 3);
    for (const PixelRectangle& place : places) {
      if (std::min(place.width, place.height) < 6 * text) {
        throw InputError(fmt::format("{}: image '{}': {} panels are too many for {} x {} pixels",
                                     scene_.source_file, settings.name, places.size(), settings.width,
                                     settings.height));
      }
    }
    for (std::size_t k = 0; k < settings.panels.size(); ++k) {
      ImageSettings panel = resized(image_named(settings.panels[k]), places[k].width, places[k].height);
      panel.dark_background = settings.dark_background;
      paste(frame, draw_frame(panel, snapshot, depth, "", text, settings.gauges), places[k].x, places[k].y);
    }
    if (plots > 0) {
      const GaugeAxes axes = gauge_axes(curves, scene_.end_time, depth_scale(scene_), snapshot.time);
      const int margin = text * 2 / 3;
      const PixelRectangle& place = places.back();
      draw_gauge_plot(
          frame, {place.x + margin, place.y + margin, place.width - 2 * margin, place.height - 2 * margin},
          curves, axes, snapshot.time, typeface_.size(text), colours);
    }
    return frame;
  }

  /// Dots where the gauges are, in the colours of their curves.
  void mark_gauges(Image& frame, const PixelRectangle& place, const TopView& view,
                   const std::vector<std::string>& marked, const FrameLayout& layout,
                   const Palette& colours) const {
    for (std::size_t k = 0; k < marked.size(); ++k) {
      const auto gauge = std::find_if(scene_.gauges.begin(), scene_.gauges.end(),
                                      [&](const Gauge& candidate) { return candidate.name == marked[k]; });
      if (gauge == scene_.gauges.end()) continue;
      const double x = place.x + view.area.x + (gauge->x - view.left) / view.metres_per_pixel;
      const double y = place.y + view.area.y + (view.top - gauge->y) / view.metres_per_pixel;
      draw_gauge_mark(frame, x, y, 0.45 * layout.text_height, k, colours);
    }
  }

  [[nodiscard]] Colour bare_ground(const Palette& colours) const {
    return scene_.dimension == 3 ? colours.dry_floor : colours.page;
  }

  LengthScale draw_picture(Image& frame, const FrameLayout& layout, const ImageSettings& settings,
                           const Snapshot& snapshot, const DepthGrid& depth, const ColourMap& map,
                           const FieldScale& scale, const std::vector<std::string>& marked) {
    if (settings.kind == ImageKind::Particles)
      return draw_particles(frame, layout, settings, snapshot, depth, map, scale);
    const PixelRectangle& place = layout.picture;
    if (scene_.dimension == 2) {
      const Font& font = typeface_.size(layout.text_height);
      const ProfileView view = profile_view(scene_, place.width, place.height, font);
      paste(frame,
            draw_depth_profile(scene_, settings, depth, view, place.width, place.height, map, scale, font),
            place.x, place.y);
      LengthScale length = length_scale(1.0 / view.metres_per_pixel, view.area.width, layout.scale.width);
      const double exaggeration = view.metres_per_pixel / view.height_per_pixel;
      if (exaggeration > 1.01) {
        const std::string text = length.texts.front();
        length.texts = {fmt::format("{} along x; heights \u00D7 {:.3g}", text, exaggeration),
                        fmt::format("{} in x; z \u00D7 {:.2g}", text, exaggeration)};
      }
      return length;
    }
    const TopView view = top_view(scene_, settings, place.width, place.height, layout.text_height / 2);
    paste(frame, draw_depth_map(scene_, settings, depth, view, place.width, place.height, map, scale),
          place.x, place.y);
    mark_gauges(frame, place, view, marked, layout, palette(settings.dark_background));
    return length_scale(1.0 / view.metres_per_pixel, place.width, layout.scale.width);
  }

  LengthScale draw_particles(Image& frame, const FrameLayout& layout, const ImageSettings& settings,
                             const Snapshot& snapshot, const DepthGrid& depth, const ColourMap& map,
                             const FieldScale& scale) {
    const PixelRectangle& place = layout.picture;
    const Camera camera = settings.camera
                              ? *settings.camera
                              : default_camera(scene_, settings.height, place.width, place.height);
    const CameraView view(camera, settings.height, place.width, place.height, drawn_bounds(scene_));
    ParticlePicture& picture = particle_picture();
    picture.paint(settings, view, place.width, place.height, snapshot, depth, *boundary_, map, scale);
    paste(frame, picture.read(), place.x, place.y);
    LengthScale length = length_scale(view.pixels_per_metre(), place.width, layout.scale.width);
    const std::string text = length.texts.front();
    length.texts.clear();
    const std::string at_centre = view.perspective() ? text + " at view centre" : text;
    if (scene_.dimension == 3 && settings.draw_walls) {
      length.texts.push_back(
          fmt::format("{}; floor grid {}", at_centre, length_text(picture.grid_spacing())));
    }
    length.texts.push_back(at_centre);
    length.texts.push_back(text);
    return length;
  }

  Scene scene_;
  ParticlePictureOptions options_;
  std::shared_ptr<GlContext> context_;
  const BoundaryParticles* boundary_ = nullptr;  ///< of the frame in hand
  Typeface typeface_;
  std::map<std::string, ColourMap> colour_maps_;
  std::optional<ParticlePicture> particle_picture_;
};

FrameRenderer::FrameRenderer(const Scene& scene, const ParticlePictureOptions& options,
                             std::shared_ptr<GlContext> context)
    : parts_(std::make_unique<Parts>(scene, options, std::move(context))) {}

FrameRenderer::~FrameRenderer() = default;

std::string FrameRenderer::context_description() const { return parts_->context_description(); }

const ColourMap& FrameRenderer::colour_map(const std::string& name) { return parts_->colour_map(name); }

Image FrameRenderer::draw(const ImageSettings& settings, const Snapshot& snapshot, const DepthGrid& depth,
                          const std::vector<GaugeCurve>& curves, const BoundaryParticles& boundary) {
  return parts_->draw(settings, snapshot, depth, curves, boundary);
}

GLuint FrameRenderer::paint(const ImageSettings& settings, const Snapshot& snapshot, const DepthGrid& depth,
                            const BoundaryParticles& boundary, int width, int height) {
  return parts_->paint(settings, snapshot, depth, boundary, width, height);
}

}  // namespace eisph
