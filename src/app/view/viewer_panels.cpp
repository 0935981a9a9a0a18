// The panels of the viewer and what input does.

#include "app/view/plot_widget.hpp"
#include "app/view/view_camera.hpp"
#include "app/view/viewer.hpp"
#include "io/scene_file.hpp"
#include "render/depth_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <fmt/format.h>
#include <imgui.h>

namespace eisph {

namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoSavedSettings;
constexpr float kPanelLetters = 20.0F;  ///< width of the side panels
constexpr double kDegreesPerPixel = 0.4;
constexpr double kZoomPerNotch = 0.88;

// Keys have the numbers of GLFW, which are those of the capital letters.
constexpr int kEscape = 256;
constexpr int kRight = 262;
constexpr int kLeft = 263;
constexpr int kF1 = 290;

ImTextureID texture_id(GLuint name) {
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(name));
}

/// Of the side panels; narrower where the window is.
float panel_width() {
  return std::min(kPanelLetters * ImGui::GetFontSize(), 0.28F * ImGui::GetIO().DisplaySize.x);
}

void begin_panel(const char* name, float left, float width) {
  ImGui::SetNextWindowPos(ImVec2(left, 0.0F));
  ImGui::SetNextWindowSize(ImVec2(width, ImGui::GetIO().DisplaySize.y));
  ImGui::Begin(name, nullptr, kFixed);
}

bool input_double(const char* label, double& value, const char* format = "%.4g") {
  return ImGui::InputDouble(label, &value, 0.0, 0.0, format);
}

}  // namespace

void Viewer::control_panel() {
  begin_panel("controls", 0.0F, panel_width());
  ImGui::PushItemWidth(0.5F * ImGui::GetContentRegionAvail().x);
  ImGui::TextWrapped("%s", (scene_.title.empty() ? scene_.name : scene_.title).c_str());
  run_section();
  if (ImGui::CollapsingHeader("Colour", ImGuiTreeNodeFlags_DefaultOpen)) colour_section();
  if (ImGui::CollapsingHeader("View", ImGuiTreeNodeFlags_DefaultOpen)) view_section();
  if (ImGui::CollapsingHeader("Cut")) cut_section();
  if (ImGui::CollapsingHeader("Show")) show_section();
  if (source_.takes_parameters() && ImGui::CollapsingHeader("Parameters")) parameter_section();
  if (ImGui::CollapsingHeader("Pictures")) output_section();
  if (ImGui::CollapsingHeader("Time of a step")) {
    for (const auto& [stage, nanoseconds] : source_.status().stage_times) {
      ImGui::Text("%s", stage.c_str());
      ImGui::SameLine(0.6F * ImGui::GetContentRegionAvail().x);
      ImGui::Text("%.1f ns", nanoseconds);
    }
    ImGui::TextDisabled("for each particle");
  }
  if (!log_.empty() && ImGui::CollapsingHeader("Log")) log_section();
  ImGui::TextDisabled("H: keys and mouse");
  ImGui::PopItemWidth();
  ImGui::End();
}

void Viewer::run_section() {
  const SourceStatus status = source_.status();
  const float third = (ImGui::GetContentRegionAvail().x - 2.0F * ImGui::GetStyle().ItemSpacing.x) / 3.0F;
  if (ImGui::Button(status.playing ? "Pause" : "Play", ImVec2(third, 0.0F))) {
    status.playing ? source_.pause() : source_.play();
  }
  ImGui::SameLine();
  if (ImGui::Button("Step", ImVec2(third, 0.0F))) source_.step();
  ImGui::SameLine();
  if (ImGui::Button("Restart", ImVec2(third, 0.0F))) source_.restart();
  input_double("##until", settings_.run_to);
  ImGui::SameLine();
  if (ImGui::Button("Run to (s)", ImVec2(-1.0F, 0.0F))) source_.run_to(settings_.run_to);

  const std::vector<double>& times = source_.saved_times();
  if (!times.empty()) {
    const auto nearest = std::lower_bound(times.begin(), times.end(), status.time - 1e-9);
    int state = static_cast<int>(nearest - times.begin());
    const int last = static_cast<int>(times.size()) - 1;
    ImGui::SetNextItemWidth(-1.0F);
    const std::string format = fmt::format("state %d of {}", last);
    if (ImGui::SliderInt("##state", &state, 0, last, format.c_str())) {
      source_.pause();
      source_.show(static_cast<std::size_t>(state));
    }
  }
  ImGui::Text("t = %.4f s of %g s", status.time, scene_.end_time);
  ImGui::Text("step %llu, %.3g s", static_cast<unsigned long long>(status.steps), status.time_step);
  ImGui::Text("%llu particles", static_cast<unsigned long long>(status.carriers));
  if (status.carrier_steps_per_second > 0.0) {
    ImGui::Text("%.2f million particle-steps/s", 1e-6 * status.carrier_steps_per_second);
  }
  if (!status.message.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(255, 140, 110, 255));
    ImGui::TextWrapped("%s", status.message.c_str());
    ImGui::PopStyleColor();
  } else if (status.at_end) {
    ImGui::TextDisabled("at the end");
  }
}

void Viewer::colour_section() {
  ImageSettings& picture = settings_.picture;
  if (ImGui::BeginCombo("field", picture.field.c_str())) {
    for (const std::string& field : fields()) {
      if (ImGui::Selectable(field.c_str(), picture.field == field)) choose_field(field);
    }
    ImGui::EndCombo();
  }
  if (picture.field == "kind" || picture.field == "water") return;
  if (ImGui::BeginCombo("colour map", picture.colour_map.c_str())) {
    for (const std::string& map : colour_map_names()) {
      if (ImGui::Selectable(map.c_str(), picture.colour_map == map)) picture.colour_map = map;
    }
    ImGui::EndCombo();
  }
  const auto mode = [&](const char* label, RangeMode wanted, const char* tip) {
    if (ImGui::RadioButton(label, settings_.range_mode == wanted) && settings_.range_mode != wanted) {
      if (wanted == RangeMode::Held) {
        const FieldScale scale = field_scale(scene_, picture_settings());
        settings_.held_range = {scale.lower / scale.display_unit, scale.upper / scale.display_unit};
      }
      settings_.range_mode = wanted;
      painted_ = nullptr;
    }
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tip);
  };
  ImGui::TextUnformatted("range");
  ImGui::SameLine();
  mode("scene", RangeMode::Automatic, "by the scene alone, the same in all frames");
  ImGui::SameLine();
  mode("state", RangeMode::Fitted, "of the state that is shown");
  ImGui::SameLine();
  mode("held", RangeMode::Held, "as it is now, or as typed");
  if (settings_.range_mode == RangeMode::Held) {
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::InputScalarN("##range", ImGuiDataType_Double, settings_.held_range.data(), 2, nullptr, nullptr,
                        "%.4g");
  }
}

void Viewer::view_section() {
  int n = 0;
  for (const PresetView view :
       {PresetView::Oblique, PresetView::Front, PresetView::Side, PresetView::Top, PresetView::AlongFlow}) {
    if (n++ % 3 != 0) ImGui::SameLine();
    if (ImGui::Button(preset_name(view))) choose_preset(view);
  }
  if (settings_.picture.camera) {
    bool flat = settings_.picture.camera->projection == Projection::Orthographic;
    if (ImGui::Checkbox("orthographic", &flat)) {
      set_projection(*settings_.picture.camera, flat ? Projection::Orthographic : Projection::Perspective);
    }
  }
  ImGui::Checkbox("dark background", &settings_.picture.dark_background);
  ImGui::Checkbox("depth and curves", &settings_.side_panel);
}

void Viewer::cut_section() {
  constexpr std::array<const char*, 6> kNames = {"x from", "x to", "y from", "y to", "z from", "z to"};
  for (std::size_t k = 0; k < 6; ++k) {
    if (scene_.dimension == 2 && k / 2 == 1) continue;
    ImGui::PushID(static_cast<int>(k));
    ImGui::Checkbox(kNames[k], &settings_.cut[k]);
    ImGui::SameLine(0.38F * ImGui::GetContentRegionAvail().x);
    const int axis = static_cast<int>(k / 2);
    const double lower = scene_.domain_min[axis];
    const double upper = scene_.domain_max[axis];
    ImGui::SetNextItemWidth(-1.0F);
    if (ImGui::SliderScalar("##at", ImGuiDataType_Double, &settings_.cut_at[k], &lower, &upper, "%.3f m")) {
      settings_.cut[k] = true;
    }
    ImGui::PopID();
  }
}

void Viewer::show_section() {
  ImageSettings& picture = settings_.picture;
  ImGui::Checkbox("fluid", &picture.draw_fluid);
  if (scene_.dimension == 3) {
    bool surface = picture.style == WaterStyle::Surface;
    if (ImGui::Checkbox("as a surface", &surface)) {
      picture.style = surface ? WaterStyle::Surface : WaterStyle::Spheres;
      if (!surface && picture.field == "water") choose_field("speed");
      if (surface && picture.field == "kind") choose_field("water");
    }
    ImGui::Checkbox("shadow", &picture.shadow);
    ImGui::Checkbox("glass walls", &picture.glass);
  }
  ImGui::Checkbox("walls", &picture.draw_walls);
  ImGui::Checkbox("obstacles, dams, gates", &picture.draw_obstacles);
  ImGui::Checkbox("object particles", &picture.draw_objects);
  ImGui::Checkbox("ghost particles", &picture.draw_ghosts);
  ImGui::Checkbox("virtual particles", &picture.draw_virtual_particles);
}

void Viewer::parameter_section() {
  RunningParameters& parameters = settings_.parameters;
  if (scene_.scheme.name != "shallow_water") {
    input_double("viscosity (m\u00B2/s)", parameters.kinematic_viscosity, "%.3g");
    input_double("artificial", parameters.artificial_viscosity);
  }
  input_double(step_factor_name(scene_), parameters.step_factor);
  if (scene_.scheme.name == "eisph") ImGui::InputInt("sweeps", &parameters.pressure_sweeps);
  parameters.kinematic_viscosity = std::max(parameters.kinematic_viscosity, 0.0);
  parameters.artificial_viscosity = std::max(parameters.artificial_viscosity, 0.0);
  parameters.step_factor = std::clamp(parameters.step_factor, 1e-3, 5.0);
  parameters.pressure_sweeps = std::clamp(parameters.pressure_sweeps, 1, 100);
  if (ImGui::Button("Apply from the next step on")) apply_parameters();
}

void Viewer::output_section() {
  ImGui::InputInt2("size", settings_.frame_size.data());
  for (int& size : settings_.frame_size) size = std::clamp(size, 160, 8192);
  if (ImGui::Button("Screenshot")) screenshot();
  ImGui::SameLine();
  if (ImGui::Button(recording_ ? "Stop recording" : "Record")) set_recording(!recording_);
  ImGui::BeginDisabled(recording_);
  if (source_.saved_times().empty()) input_double("every (s)", settings_.record_interval);
  settings_.record_interval = std::max(settings_.record_interval, 1e-4);
  ImGui::EndDisabled();
  ImGui::TextWrapped("in %s", options_.folder.string().c_str());
}

void Viewer::log_section() {
  for (const std::string& line : log_) ImGui::TextWrapped("%s", line.c_str());
}

void Viewer::side_panel() {
  const float width = panel_width();
  begin_panel("depth and curves", ImGui::GetIO().DisplaySize.x - width, width);
  const float room = ImGui::GetContentRegionAvail().x;
  if (scene_.dimension == 3 && depth_of_ != nullptr) {
    ImageSettings map;
    map.kind = ImageKind::DepthMap;
    map.field = "depth";
    map.colour_map = "depth_blue";
    map.dark_background = true;
    const FieldScale scale = field_scale(scene_, map);
    const Vec3d size = scene_.domain_max - scene_.domain_min;
    const int pixels = std::max(32, static_cast<int>(room));
    const int rows = std::clamp(static_cast<int>(pixels * size.y() / size.x()) + 8, 32, pixels);
    if (shown_depth_ != depth_of_ || shown_depth_width_ != static_cast<std::size_t>(pixels)) {
      const TopView view = top_view(scene_, map, pixels, rows, 4);
      depth_texture_.set(draw_depth_map(scene_, map, depth_, view, pixels, rows,
                                        view_renderer_.colour_map(map.colour_map), scale));
      shown_depth_ = depth_of_;
      shown_depth_width_ = static_cast<std::size_t>(pixels);
    }
    ImGui::Text("water depth, 0 to %.3g m", scale.upper);
    ImGui::Image(texture_id(depth_texture_.name()),
                 ImVec2(static_cast<float>(pixels), static_cast<float>(rows)));
  }
  const double time = snapshot_ != nullptr ? snapshot_->time : 0.0;
  const float height = std::max(8.0F * ImGui::GetTextLineHeight(), 0.45F * room);
  for (const ProbePlot& plot : *source_.plots()) draw_plot(plot, time, scene_.end_time, height);
  ImGui::End();
}

void Viewer::picture_panel() {
  const float left = panel_width();
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float width = display.x - left - (settings_.side_panel ? left : 0.0F);
  ImGui::SetNextWindowPos(ImVec2(left, 0.0F));
  ImGui::SetNextWindowSize(ImVec2(width, display.y));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
  ImGui::Begin("picture", nullptr,
               kFixed | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  const int columns = std::max(16, static_cast<int>(width));
  const int rows = std::max(16, static_cast<int>(display.y));
  place_camera(columns, rows);
  const CameraView view(*settings_.picture.camera, rows, columns, rows, drawn_bounds(scene_));
  const ImVec2 pixels = ImGui::GetIO().DisplayFramebufferScale;
  paint(static_cast<int>(static_cast<float>(columns) * pixels.x),
        static_cast<int>(static_cast<float>(rows) * pixels.y));
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 area(static_cast<float>(columns), static_cast<float>(rows));
  // The first row of a texture is the lowest.
  if (picture_ != 0) ImGui::Image(texture_id(picture_), area, ImVec2(0.0F, 1.0F), ImVec2(1.0F, 0.0F));
  ImGui::SetCursorScreenPos(corner);
  ImGui::InvisibleButton("camera", area,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  cut_handles(view, corner);
  move_camera(view.pixels_per_metre());
  if (settings_.picture.field != "kind" && settings_.picture.field != "water") colour_bar();
  if (snapshot_ != nullptr) {
    const ImU32 ink =
        settings_.picture.dark_background ? IM_COL32(235, 235, 238, 255) : IM_COL32(30, 30, 32, 255);
    const std::string time = fmt::format("t = {:.4f} s", snapshot_->time);
    ImGui::GetWindowDrawList()->AddText(
        ImVec2(corner.x + area.x - ImGui::CalcTextSize(time.c_str()).x - ImGui::GetFontSize(),
               corner.y + 0.6F * ImGui::GetFontSize()),
        ink, time.c_str());
  }
  ImGui::End();
}

/// At the start: where the scene has it, so far back that a picture narrower than a frame shows as much.
void Viewer::place_camera(int columns, int rows) {
  if (camera_placed_) return;
  camera_placed_ = true;
  std::optional<Camera>& camera = settings_.picture.camera;
  if (!camera) {
    camera = default_camera(scene_, rows, columns, rows);
    return;
  }
  const double of_frame = static_cast<double>(settings_.frame_size[0]) / settings_.frame_size[1];
  zoom(*camera, std::max(1.0, of_frame * rows / columns));
}

void Viewer::colour_bar() {
  const FieldScale scale = field_scale(scene_, picture_settings());
  const ColourMap& map = view_renderer_.colour_map(settings_.picture.colour_map);
  Image strip(ColourMap::kSize, 1);
  for (int k = 0; k < ColourMap::kSize; ++k) {
    const Colour& colour = map.table()[static_cast<std::size_t>(k)];
    std::uint8_t* pixel = strip.pixel(k, 0);
    pixel[0] = static_cast<std::uint8_t>(std::lround(255.0F * colour.red));
    pixel[1] = static_cast<std::uint8_t>(std::lround(255.0F * colour.green));
    pixel[2] = static_cast<std::uint8_t>(std::lround(255.0F * colour.blue));
  }
  bar_texture_.set(strip);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float letter = ImGui::GetFontSize();
  const ImVec2 window = ImGui::GetWindowPos();
  const ImVec2 size = ImGui::GetWindowSize();
  const ImVec2 from(window.x + letter, window.y + size.y - 2.6F * letter);
  const ImVec2 to(from.x + std::min(16.0F * letter, size.x - 2.0F * letter), from.y + 0.8F * letter);
  const ImU32 ink =
      settings_.picture.dark_background ? IM_COL32(235, 235, 238, 255) : IM_COL32(30, 30, 32, 255);
  list.AddImage(texture_id(bar_texture_.name()), from, to);
  list.AddText(ImVec2(from.x, from.y - 1.3F * letter), ink, scale.label.c_str());
  const std::string lower = fmt::format("{:.3g}", scale.lower / scale.display_unit);
  const std::string upper = fmt::format("{:.3g}", scale.upper / scale.display_unit);
  list.AddText(ImVec2(from.x, to.y + 0.2F * letter), ink, lower.c_str());
  list.AddText(ImVec2(to.x - ImGui::CalcTextSize(upper.c_str()).x, to.y + 0.2F * letter), ink, upper.c_str());
}

/// Those that the picture can show as it is.
std::vector<std::string> Viewer::fields() const {
  std::vector<std::string> fields = {"speed", "velocity_x"};
  if (scene_.dimension == 3) fields.emplace_back("velocity_y");
  for (const char* field : {"velocity_z", "pressure", "depth"}) fields.emplace_back(field);
  fields.emplace_back(settings_.picture.style == WaterStyle::Surface ? "water" : "kind");
  return fields;
}

void Viewer::choose_field(const std::string& field) {
  settings_.picture.field = field;
  settings_.picture.colour_map.clear();
  settings_.picture.colour_map = colour_map_name(settings_.picture);
  settings_.range_mode = RangeMode::Automatic;
  painted_ = nullptr;
}

/// Left: orbit; right or middle: pan; wheel: zoom. Of the picture, when the last item is under the mouse.
void Viewer::move_camera(double pixels_per_metre) {
  if (!settings_.picture.camera || held_cut_ >= 0) return;
  Camera& camera = *settings_.picture.camera;
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActive()) {
    if (ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0.0F) && scene_.dimension == 3) {
      orbit(camera, -kDegreesPerPixel * io.MouseDelta.x, kDegreesPerPixel * io.MouseDelta.y);
    } else if (io.MouseDelta.x != 0.0F || io.MouseDelta.y != 0.0F) {
      pan(camera, -io.MouseDelta.x, io.MouseDelta.y, pixels_per_metre);
    }
  }
  if (ImGui::IsItemHovered() && io.MouseWheel != 0.0F) zoom(camera, std::pow(kZoomPerNotch, io.MouseWheel));
}

/// A dot on every clip plane in use, which the mouse can take along its axis.
void Viewer::cut_handles(const CameraView& view, const ImVec2& corner) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) held_cut_ = -1;
  const Bounds box = framed_bounds(scene_);
  const float radius = 0.5F * ImGui::GetFontSize();
  for (int k = 0; k < 6; ++k) {
    if (!settings_.cut[static_cast<std::size_t>(k)]) continue;
    const int axis = k / 2;
    double& at = settings_.cut_at[static_cast<std::size_t>(k)];
    Vec3d centre = 0.5 * (box.lower + box.upper);
    centre[axis] = at;
    const Vec3d place = view.project(centre);
    if (place.z() <= 0.0 && view.perspective()) continue;
    Vec3d farther = centre;
    farther[axis] += 0.01 * (box.upper[axis] - box.lower[axis]);
    const Vec3d step = (view.project(farther) - place) / (farther[axis] - centre[axis]);
    const ImVec2 dot(corner.x + static_cast<float>(place.x()), corner.y + static_cast<float>(place.y()));
    const float off = std::hypot(io.MousePos.x - dot.x, io.MousePos.y - dot.y);
    if (held_cut_ < 0 && ImGui::IsItemHovered() && off < 1.5F * radius &&
        ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
      held_cut_ = k;
    }
    if (held_cut_ == k) {
      const double length = step.head<2>().squaredNorm();
      if (length > 0.0) at += (io.MouseDelta.x * step.x() + io.MouseDelta.y * step.y()) / length;
      at = std::clamp(at, scene_.domain_min[axis], scene_.domain_max[axis]);
    }
    constexpr std::array<ImU32, 3> kAxes = {IM_COL32(225, 90, 80, 255), IM_COL32(100, 190, 90, 255),
                                            IM_COL32(80, 140, 235, 255)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddCircleFilled(dot, radius, kAxes[static_cast<std::size_t>(axis)]);
    list.AddCircle(dot, radius, held_cut_ == k || off < 1.5F * radius ? IM_COL32_WHITE : IM_COL32_BLACK, 0,
                   2.0F);
  }
}

void Viewer::heed_keys() {
  if (ImGui::GetIO().WantTextInput) return;
  const auto pressed = [](int key) { return ImGui::IsKeyPressed(key, false); };
  const SourceStatus status = source_.status();
  if (pressed(' ')) status.playing ? source_.pause() : source_.play();
  if (ImGui::IsKeyPressed(kRight, true)) source_.step();
  if (ImGui::IsKeyPressed(kLeft, true) && !source_.saved_times().empty()) {
    const std::vector<double>& times = source_.saved_times();
    const auto now = std::lower_bound(times.begin(), times.end(), status.time - 1e-9) - times.begin();
    source_.pause();
    source_.show(static_cast<std::size_t>(std::max<std::ptrdiff_t>(now - 1, 0)));
  }
  if (pressed('R')) source_.restart();
  if (pressed('F')) {
    const std::vector<std::string> all = fields();
    const auto now = std::find(all.begin(), all.end(), settings_.picture.field);
    choose_field(now == all.end() || now + 1 == all.end() ? all.front() : *(now + 1));
  }
  if (pressed('S')) screenshot();
  if (pressed('V')) set_recording(!recording_);
  if (pressed('D')) settings_.side_panel = !settings_.side_panel;
  if (pressed('B')) settings_.picture.dark_background = !settings_.picture.dark_background;
  if (pressed('O') && settings_.picture.camera) {
    const bool flat = settings_.picture.camera->projection == Projection::Orthographic;
    set_projection(*settings_.picture.camera, flat ? Projection::Perspective : Projection::Orthographic);
  }
  for (int k = 0; k < 5; ++k) {
    if (pressed('1' + k)) choose_preset(static_cast<PresetView>(k));
  }
  if (pressed('H') || pressed(kF1)) settings_.help = !settings_.help;
  if (pressed(kEscape)) settings_.help = false;
}

void Viewer::help_panel() {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(0.5F * display.x, 0.5F * display.y), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  ImGui::Begin("Keys and mouse", &settings_.help,
               ImGuiWindowFlags_NoResize | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoSavedSettings);
  constexpr std::array<std::array<const char*, 2>, 16> kKeys = {
      {{"space", "play or pause"},
       {"right", "one step, or the next saved state"},
       {"left", "the saved state before"},
       {"R", "restart"},
       {"F", "next field"},
       {"1 to 5", "oblique, front, side, top, along the flow"},
       {"O", "orthographic or perspective"},
       {"B", "dark or light background"},
       {"D", "depth and curves"},
       {"S", "screenshot"},
       {"V", "record, or stop recording"},
       {"H, F1", "this panel"},
       {"left drag", "turn"},
       {"right drag", "move"},
       {"wheel", "nearer or farther"},
       {"coloured dots", "take a clip plane along its axis"}}};
  for (const auto& [key, meaning] : kKeys) {
    ImGui::TextUnformatted(key);
    ImGui::SameLine(9.0F * ImGui::GetFontSize());
    ImGui::TextUnformatted(meaning);
  }
  ImGui::End();
}

}  // namespace eisph
