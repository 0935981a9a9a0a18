#include "app/view/plot_widget.hpp"

#include "render/axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <imgui.h>

namespace eisph {

namespace {

constexpr std::array<ImU32, 4> kColours = {IM_COL32(90, 160, 230, 255), IM_COL32(235, 150, 70, 255),
                                           IM_COL32(120, 190, 110, 255), IM_COL32(200, 120, 200, 255)};
constexpr ImU32 kFrame = IM_COL32(110, 114, 122, 255);
constexpr ImU32 kCursor = IM_COL32(200, 200, 205, 110);

/// Ends of an axis that has room for all finite values.
std::array<double, 2> ends_of(const ProbePlot& plot) {
  double lower = std::numeric_limits<double>::max();
  double upper = std::numeric_limits<double>::lowest();
  for (const ProbePlot::Series& series : plot.series) {
    for (const double value : series.values) {
      if (!std::isfinite(value)) continue;
      lower = std::min(lower, value);
      upper = std::max(upper, value);
    }
  }
  if (lower > upper) return {0.0, 1.0};
  // A constant has some room too.
  const double size = std::max(std::abs(lower), std::abs(upper));
  const bool flat = upper - lower <= 1e-6 * size;
  const double room = flat ? (size > 0.0 ? 0.1 * size : 1.0) : 0.05 * (upper - lower);
  return {lower - room, upper + room};
}

}  // namespace

void draw_plot(const ProbePlot& plot, double time, double end_time, float height) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float line = ImGui::GetTextLineHeight();
  const std::array<double, 2> ends = ends_of(plot);
  const bool of_line = plot.over_distance;
  const double last = plot.x.size() > 1 ? plot.x.back() : std::max(of_line ? 1.0 : end_time, 1e-9);

  std::string heading = plot.title;
  if (plot.series.size() == 1) heading += ": " + plot.series.front().name;
  if (plot.unit != "-") heading += " (" + plot.unit + ")";
  ImGui::TextUnformatted(heading.c_str());
  if (plot.series.size() > 1) {
    for (std::size_t k = 0; k < plot.series.size(); ++k) {
      ImGui::SameLine();
      ImGui::PushStyleColor(ImGuiCol_Text, kColours[k % kColours.size()]);
      ImGui::TextUnformatted(plot.series[k].name.c_str());
      ImGui::PopStyleColor();
    }
  }
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const std::string top = fmt::format("{:.4g}", ends[1]);
  const std::string bottom = fmt::format("{:.4g}", ends[0]);
  const float margin =
      std::max(ImGui::CalcTextSize(top.c_str()).x, ImGui::CalcTextSize(bottom.c_str()).x) + 0.4F * line;
  const ImVec2 upper_left(corner.x + margin, corner.y + 0.3F * line);
  const ImVec2 lower_right(corner.x + width - 0.3F * line, corner.y + height - 1.2F * line);
  const auto at = [&](double t, double value) {
    return ImVec2(upper_left.x + static_cast<float>(t / last) * (lower_right.x - upper_left.x),
                  lower_right.y - static_cast<float>((value - ends[0]) / (ends[1] - ends[0])) *
                                      (lower_right.y - upper_left.y));
  };
  const ImU32 text = ImGui::GetColorU32(ImGuiCol_Text);
  list.AddRect(upper_left, lower_right, kFrame);
  list.AddText(ImVec2(corner.x, upper_left.y - 0.3F * line), text, top.c_str());
  list.AddText(ImVec2(corner.x, lower_right.y - 0.7F * line), text, bottom.c_str());
  list.AddText(ImVec2(upper_left.x, lower_right.y + 0.1F * line), text, "0");
  const std::string end = fmt::format("{:.3g} {}", last, of_line ? "m" : "s");
  list.AddText(ImVec2(lower_right.x - ImGui::CalcTextSize(end.c_str()).x, lower_right.y + 0.1F * line), text,
               end.c_str());
  if (!of_line) {
    const float cursor = at(std::min(time, last), ends[0]).x;
    list.AddLine(ImVec2(cursor, upper_left.y), ImVec2(cursor, lower_right.y), kCursor, 2.0F);
  }

  // Not more points than can be told apart.
  const std::size_t stride = std::max<std::size_t>(1, plot.x.size() / 1000);
  std::vector<ImVec2> points;
  points.reserve(1002);
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const std::vector<double>& values = plot.series[k].values;
    const ImU32 colour = kColours[k % kColours.size()];
    const auto flush = [&] {
      list.AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0, 1.5F);
      points.clear();
    };
    for (std::size_t row = 0; row < values.size(); row += stride) {
      if (std::isfinite(values[row])) {
        points.push_back(at(plot.x[row], values[row]));
      } else {
        flush();
      }
    }
    flush();
  }
  ImGui::Dummy(ImVec2(width, height));
}

}  // namespace eisph
