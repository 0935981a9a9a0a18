#pragma once

#include "app/view/state_source.hpp"
#include "app/view/view_camera.hpp"
#include "app/view/view_settings.hpp"
#include "core/depth_grid.hpp"
#include "core/scene.hpp"
#include "probe/depth_grid.hpp"
#include "render/camera_view.hpp"
#include "render/colour_map.hpp"
#include "render/field.hpp"
#include "render/frame_renderer.hpp"
#include "render/gui_painter.hpp"

#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

struct ImGuiContext;
struct ImVec2;

namespace eisph {

struct ViewerOptions {
  float scale = 1.0F;            ///< of letters and controls: 1, 1.5, 2
  std::filesystem::path folder;  ///< of screenshots, recorded frames and the log; made when first needed
};

/// The window of `eisph view`: the picture in the middle, controls on the left, depth and curves on the
/// right. Draws in whatever context; input is what stands in ImGui's IO when draw() is called.
class Viewer {
 public:
  /// Makes an ImGui context of its own and leaves it current. Throws InputError when shaders or fonts are
  /// missing.
  Viewer(std::shared_ptr<GlContext> context, const Scene& scene, StateSource& source,
         const ViewerOptions& options);
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;
  ~Viewer();

  /// One round: the newest state, the interface, and both drawn into `framebuffer`, whose size in pixels is
  /// that of ImGui's display.
  void draw(GLuint framebuffer);

  /// Whether anything goes on without input.
  [[nodiscard]] bool busy() const { return source_.status().playing; }
  [[nodiscard]] const ViewSettings& settings() const { return settings_; }
  /// The newest first.
  [[nodiscard]] const std::deque<std::string>& log() const { return log_; }
  [[nodiscard]] std::size_t frames_written() const { return frames_written_; }
  [[nodiscard]] bool recording() const { return recording_; }

 private:
  // Panels.
  void control_panel();
  void run_section();
  void colour_section();
  void view_section();
  void cut_section();
  void show_section();
  void parameter_section();
  void output_section();
  void log_section();
  void side_panel();
  void picture_panel();
  void place_camera(int columns, int rows);
  void colour_bar();
  void help_panel();

  void heed_keys();
  void move_camera(double pixels_per_metre);
  void cut_handles(const CameraView& view, const ImVec2& corner);
  void choose_preset(PresetView view);
  [[nodiscard]] std::vector<std::string> fields() const;
  void choose_field(const std::string& field);
  void apply_parameters();
  void write_picture(const Snapshot& snapshot);
  void screenshot();
  void set_recording(bool on);
  void note(const std::string& line);

  /// What the picture shows now, complete with range and clip box.
  [[nodiscard]] ImageSettings picture_settings() const;
  void follow_state();
  void find_depth();
  void paint(int width, int height);

  const Scene scene_;
  StateSource& source_;
  ViewerOptions options_;
  ViewSettings settings_;
  std::shared_ptr<GlContext> context_;
  ImGuiContext* gui_ = nullptr;
  GuiPainter gui_painter_;
  FrameRenderer view_renderer_;   ///< of the window: one sample per pixel
  FrameRenderer frame_renderer_;  ///< of files
  DepthGridBuilder depth_builder_;
  ImageTexture depth_texture_;
  ImageTexture bar_texture_;

  std::shared_ptr<const Snapshot> snapshot_;
  std::shared_ptr<const Snapshot> painted_;
  ImageSettings painted_settings_;
  std::shared_ptr<const Snapshot> depth_of_;  ///< the state that depth_ belongs to
  DepthGrid depth_;
  GLuint picture_ = 0;
  std::array<int, 2> picture_size_{};
  std::array<double, 2> fitted_range_ = {0.0, 1.0};
  bool camera_placed_ = false;
  int held_cut_ = -1;  ///< handle that the mouse holds
  std::size_t shown_depth_width_ = 0;
  std::shared_ptr<const Snapshot> shown_depth_;

  std::deque<std::string> log_;
  std::size_t frames_written_ = 0;
  bool recording_ = false;
};

}  // namespace eisph
