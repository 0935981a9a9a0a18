#include "render/gauge_plot.hpp"

#include "render/axis.hpp"
#include "render/drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace eisph {

namespace {

constexpr double kSameTime = 1e-9;  ///< s

/// Colours that are told apart on a light and on a dark page, also by those who confuse red and green.
constexpr std::array<Colour, 6> kCurveColours{Colour{0.12F, 0.47F, 0.71F}, Colour{0.90F, 0.49F, 0.13F},
                                              Colour{0.36F, 0.66F, 0.50F}, Colour{0.80F, 0.40F, 0.62F},
                                              Colour{0.55F, 0.55F, 0.55F}, Colour{0.66F, 0.56F, 0.10F}};

struct Point {
  double x;
  double y;
};

/// A line with smooth edges, ends round. Pixels.
void draw_line(Image& image, const Point& a, const Point& b, double width, const Colour& colour) {
  const double reach = 0.5 * width + 1.0;
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length_squared = dx * dx + dy * dy;
  for (int y = static_cast<int>(std::min(a.y, b.y) - reach);
       y <= static_cast<int>(std::max(a.y, b.y) + reach); ++y) {
    for (int x = static_cast<int>(std::min(a.x, b.x) - reach);
         x <= static_cast<int>(std::max(a.x, b.x) + reach); ++x) {
      const double px = x + 0.5 - a.x;
      const double py = y + 0.5 - a.y;
      const double along =
          length_squared > 0.0 ? std::clamp((px * dx + py * dy) / length_squared, 0.0, 1.0) : 0.0;
      const double away = std::hypot(px - along * dx, py - along * dy);
      blend_pixel(image, x, y, colour, static_cast<float>(0.5 * width + 0.5 - away));
    }
  }
}

/// Places of times and levels in the plot.
struct PlotArea {
  PixelRectangle area;
  GaugeAxes axes;

  [[nodiscard]] Point at(double time, double level) const {
    return {area.x + time / axes.end_time * area.width, area.bottom() - level / axes.top * area.height};
  }
};

PixelRectangle inner_area(const PixelRectangle& place, const GaugeAxes& axes, const Font& font) {
  int widest = 0;
  for (const Tick& mark : ticks(0.0, axes.top, 6)) widest = std::max(widest, font.width(mark.label));
  const int left = widest + font.height();
  const int above = font.height() * 3 / 2;
  const int below = font.height() * 5 / 2;
  return {place.x + left, place.y + above, std::max(place.width - left - font.height(), 1),
          std::max(place.height - above - below, 1)};
}

void draw_axes(Image& image, const PixelRectangle& place, const PlotArea& plot, const Font& font,
               const Palette& colours) {
  const PixelRectangle& area = plot.area;
  const int line = std::max(1, font.height() / 16);
  const int tick = font.height() / 3;
  for (const Tick& mark : ticks(0.0, plot.axes.top, std::clamp(area.height / (2 * font.height()), 2, 6))) {
    const int y = static_cast<int>(std::lround(plot.at(0.0, mark.value).y));
    fill_rectangle(image, {area.x, y, area.width, line}, mix(colours.page, colours.faint, 0.5F));
    font.draw(image, area.x - tick - font.width(mark.label), y - font.height() / 2, mark.label, colours.text);
  }
  int widest = 0;
  for (const Tick& mark : ticks(0.0, plot.axes.end_time, 8))
    widest = std::max(widest, font.width(mark.label));
  for (const Tick& mark : ticks(0.0, plot.axes.end_time, std::clamp(area.width / (2 * widest), 2, 8))) {
    const int x = static_cast<int>(std::lround(plot.at(mark.value, 0.0).x));
    fill_rectangle(image, {x, area.bottom(), line, tick}, colours.line);
    font.draw(image, x - font.width(mark.label) / 2, area.bottom() + tick + line, mark.label, colours.text);
  }
  fill_rectangle(image, {area.x - line, area.y, line, area.height + line}, colours.line);
  fill_rectangle(image, {area.x - line, area.bottom(), area.width + line, line}, colours.line);
  font.draw(image, place.x, place.y, "level (m)", colours.text);
  font.draw(image, area.right() - font.width("time (s)"), place.bottom() - font.height(), "time (s)",
            colours.text);
}

/// Names at the upper right, as far as there is room.
void draw_names(Image& image, const PixelRectangle& place, const std::vector<GaugeCurve>& curves,
                const Font& font, const Palette& colours) {
  const int first = place.x + font.width("level (m)") + font.height();
  int right = place.right();
  for (std::size_t k = curves.size(); k-- > 0;) {
    const int width = font.width(curves[k].name);
    const int start = right - width - 2 * font.height();
    if (start < first) return;
    const double y = place.y + 0.5 * font.height();
    draw_line(image, {start + 0.2 * font.height(), y}, {start + 1.4 * font.height(), y}, font.height() / 7.0,
              kCurveColours[k % kCurveColours.size()]);
    font.draw(image, right - width, place.y, curves[k].name, colours.text);
    right = start - font.height() / 2;
  }
}

void draw_curve(Image& image, const PlotArea& plot, const GaugeCurve& curve, double now, double width,
                const Colour& colour) {
  for (std::size_t k = 0; k < curve.time.size() && curve.time[k] <= now + kSameTime; ++k) {
    const Point here = plot.at(curve.time[k], std::min(curve.surface[k], plot.axes.top));
    const Point before =
        k == 0 ? here : plot.at(curve.time[k - 1], std::min(curve.surface[k - 1], plot.axes.top));
    draw_line(image, before, here, width, colour);
    const bool last = k + 1 == curve.time.size() || curve.time[k + 1] > now + kSameTime;
    if (last) draw_line(image, here, here, 3.5 * width, colour);
  }
}

}  // namespace

void draw_gauge_mark(Image& image, double x, double y, double radius, std::size_t index,
                     const Palette& colours) {
  draw_line(image, {x, y}, {x, y}, 2.0 * radius, colours.page);
  draw_line(image, {x, y}, {x, y}, 1.4 * radius, kCurveColours[index % kCurveColours.size()]);
}

GaugeAxes gauge_axes(const std::vector<GaugeCurve>& curves, double end_time, double depth_scale, double now) {
  double highest = depth_scale;
  for (const GaugeCurve& curve : curves) {
    for (std::size_t k = 0; k < curve.time.size() && curve.time[k] <= now + kSameTime; ++k)
      highest = std::max(highest, curve.surface[k]);
  }
  return {end_time, round_up_nicely(highest)};
}

void draw_gauge_plot(Image& image, const PixelRectangle& place, const std::vector<GaugeCurve>& curves,
                     const GaugeAxes& axes, double now, const Font& font, const Palette& colours) {
  const PlotArea plot{inner_area(place, axes, font), axes};
  draw_axes(image, place, plot, font, colours);
  const int line = std::max(1, font.height() / 12);
  const auto cursor = static_cast<int>(std::lround(plot.at(std::min(now, axes.end_time), 0.0).x));
  fill_rectangle(image, {cursor - line / 2, plot.area.y, line, plot.area.height}, colours.text);
  for (std::size_t k = 0; k < curves.size(); ++k) {
    draw_curve(image, plot, curves[k], now, std::max(1.5, font.height() / 9.0),
               kCurveColours[k % kCurveColours.size()]);
  }
  draw_names(image, place, curves, font, colours);
}

}  // namespace eisph
