#include "app/view/viewer.hpp"

#include "app/frame_stage.hpp"
#include "app/run_files.hpp"
#include "app/view/view_camera.hpp"
#include "boundary/boundary_particles.hpp"
#include "core/assets.hpp"
#include "io/file_io.hpp"
#include "render/font.hpp"
#include "render/particle_culling.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <imgui.h>

namespace eisph {

namespace {

constexpr float kLetterHeight = 15.0F;
constexpr std::size_t kLogLines = 200;

// Latin, Greek, dashes, superscripts and the signs of the labels.
constexpr std::array<ImWchar, 11> kGlyphs = {0x0020, 0x017F, 0x0370, 0x03FF, 0x2010, 0x2027,
                                             0x2070, 0x209F, 0x2212, 0x2265, 0};

void set_up_gui(float scale) {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  io.Fonts->AddFontFromFileTTF(Typeface::default_file().c_str(), std::round(kLetterHeight * scale), nullptr,
                               kGlyphs.data());
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 0.0F;
  style.WindowBorderSize = 0.0F;
  style.FrameRounding = 2.0F;
  style.ScaleAllSizes(scale);
}

ViewSettings first_settings(const Scene& scene) {
  ViewSettings settings;
  const auto particles =
      std::find_if(scene.images.begin(), scene.images.end(),
                   [](const ImageSettings& image) { return image.kind == ImageKind::Particles; });
  if (particles != scene.images.end()) settings.picture = *particles;
  settings.picture.name = "view";
  settings.frame_size = {settings.picture.width, settings.picture.height};
  if (settings.picture.range) {
    settings.range_mode = RangeMode::Held;
    settings.held_range = *settings.picture.range;
  }
  for (int d = 0; d < 3; ++d) {
    settings.cut_at[2 * d] = scene.domain_min[d];
    settings.cut_at[2 * d + 1] = scene.domain_max[d];
  }
  settings.run_to = scene.end_time;
  const double interval = scene.output.frames.interval;
  settings.record_interval = interval > 0.0 ? interval : scene.end_time / 100.0;
  settings.parameters = running_parameters(scene);
  return settings;
}

}  // namespace

Viewer::Viewer(std::shared_ptr<GlContext> context, const Scene& scene, StateSource& source,
               const ViewerOptions& options)
    : scene_(scene),
      source_(source),
      options_(options),
      settings_(first_settings(scene)),
      context_(std::move(context)),
      gui_(ImGui::CreateContext()),
      gui_painter_(context_->functions(), home_folder() / "shaders"),
      view_renderer_(scene, {.samples_per_pixel = 1}, context_),
      frame_renderer_(scene, {}, context_),
      depth_builder_(scene),
      depth_texture_(context_->functions()),
      bar_texture_(context_->functions()) {
  ImGui::SetCurrentContext(gui_);
  set_up_gui(options.scale);
  gui_painter_.set_fonts(*ImGui::GetIO().Fonts);
}

Viewer::~Viewer() {
  source_.record(0.0, {});
  context_->make_current();
  ImGui::DestroyContext(gui_);
}

void Viewer::draw(GLuint framebuffer) {
  context_->make_current();
  ImGui::SetCurrentContext(gui_);
  follow_state();
  ImGui::NewFrame();
  heed_keys();
  control_panel();
  if (settings_.side_panel) side_panel();
  picture_panel();
  if (settings_.help) help_panel();
  ImGui::Render();

  const GlFunctions& gl = context_->functions();
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.ClearColor(0.06F, 0.06F, 0.07F, 1.0F);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gui_painter_.draw(*ImGui::GetDrawData());
}

/// Takes the newest state over and what follows from it.
void Viewer::follow_state() {
  auto newest = source_.latest();
  if (newest == nullptr || newest == snapshot_) return;
  snapshot_ = std::move(newest);
  if (settings_.side_panel && scene_.dimension == 3) find_depth();
}

/// The depth grid of the state that is shown.
void Viewer::find_depth() {
  if (depth_of_ == snapshot_) return;
  depth_ = depth_builder_.build(*snapshot_);
  depth_of_ = snapshot_;
}

ImageSettings Viewer::picture_settings() const {
  ImageSettings settings = settings_.picture;
  settings.range.reset();
  if (settings_.range_mode == RangeMode::Held) settings.range = settings_.held_range;
  if (settings_.range_mode == RangeMode::Fitted) settings.range = fitted_range_;
  if (settings.range && !((*settings.range)[0] < (*settings.range)[1])) settings.range.reset();
  if (std::any_of(settings_.cut.begin(), settings_.cut.end(), [](bool used) { return used; })) {
    ClipBox box{scene_.domain_min, scene_.domain_max};
    const double beyond = 10.0 * (scene_.domain_max - scene_.domain_min).norm();
    box.min.array() -= beyond;
    box.max.array() += beyond;
    for (int d = 0; d < 3; ++d) {
      if (settings_.cut[2 * d]) box.min[d] = settings_.cut_at[2 * d];
      if (settings_.cut[2 * d + 1]) box.max[d] = settings_.cut_at[2 * d + 1];
    }
    settings.clip = box;
  }
  return settings;
}

/// Draws the picture unless it would be the one that is there.
void Viewer::paint(int width, int height) {
  if (snapshot_ == nullptr) return;
  if (settings_.picture.field == "depth") find_depth();
  if (settings_.range_mode == RangeMode::Fitted && painted_ != snapshot_) {
    const std::vector<std::uint32_t> all = finite_particles(*snapshot_);
    const std::vector<float> values = field_values(settings_.picture.field, *snapshot_, depth_, all);
    if (!values.empty()) {
      const auto [least, most] = std::minmax_element(values.begin(), values.end());
      const double unit = field_scale(scene_, settings_.picture).display_unit;
      fitted_range_ = {*least / unit, *most / unit};
    }
  }
  const ImageSettings settings = picture_settings();
  const std::array<int, 2> size = {width, height};
  if (picture_ != 0 && painted_ == snapshot_ && painted_settings_ == settings && picture_size_ == size)
    return;
  const BoundaryParticles boundary =
      boundary_particles(scene_, *snapshot_, settings.draw_ghosts, settings.draw_virtual_particles);
  picture_ = view_renderer_.paint(settings, *snapshot_, depth_, boundary, width, height);
  painted_ = snapshot_;
  painted_settings_ = settings;
  picture_size_ = size;
}

void Viewer::write_picture(const Snapshot& snapshot) {
  ImageSettings settings = picture_settings();
  settings.width = settings_.frame_size[0];
  settings.height = settings_.frame_size[1];
  const DepthGrid depth = settings.field == "depth" ? depth_builder_.build(snapshot) : DepthGrid{};
  const std::filesystem::path folder = options_.folder / "frames";
  create_folder(folder);
  const std::string name = frame_file_name("view", frames_written_);
  const BoundaryParticles boundary =
      boundary_particles(scene_, snapshot, settings.draw_ghosts, settings.draw_virtual_particles);
  write_frame(folder, scene_,
              {name, snapshot.time, frame_renderer_.draw(settings, snapshot, depth, {}, boundary)});
  ++frames_written_;
  note(fmt::format("t = {:.4g} s: {}", snapshot.time, (folder / name).string()));
}

void Viewer::screenshot() {
  if (snapshot_ != nullptr) write_picture(*snapshot_);
}

void Viewer::set_recording(bool on) {
  recording_ = on;
  if (on) {
    source_.record(settings_.record_interval, [this](const Snapshot& snapshot) { write_picture(snapshot); });
    note(fmt::format("recording every {:g} s", settings_.record_interval));
  } else {
    source_.record(0.0, {});
    note("recording ends");
  }
}

void Viewer::apply_parameters() {
  source_.set_parameters(settings_.parameters);
  const RunningParameters& now = settings_.parameters;
  note(
      fmt::format("t = {:.4g} s: kinematic_viscosity = {:g} m^2/s, artificial_viscosity = {:g}, {} = {:g}, "
                  "pressure_sweeps = {}",
                  source_.status().time, now.kinematic_viscosity, now.artificial_viscosity,
                  step_factor_name(scene_), now.step_factor, now.pressure_sweeps));
}

/// Into the panel and the log file.
void Viewer::note(const std::string& line) {
  log_.push_front(line);
  if (log_.size() > kLogLines) log_.pop_back();
  create_folder(options_.folder);
  std::ofstream file(options_.folder / "view.log", std::ios::app);
  file << fmt::format("{:%Y-%m-%d %H:%M:%S} ", fmt::localtime(std::time(nullptr))) << line << '\n';
}

void Viewer::choose_preset(PresetView view) {
  const int width = std::max(picture_size_[0], 16);
  const int height = std::max(picture_size_[1], 16);
  const Projection projection =
      settings_.picture.camera ? settings_.picture.camera->projection : Projection::Perspective;
  settings_.picture.camera = preset_camera(scene_, view, projection, height, width, height);
}

}  // namespace eisph
