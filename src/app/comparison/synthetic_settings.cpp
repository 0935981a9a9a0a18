#include "app/comparison/synthetic_settings.hpp"

#include "core/assets.hpp"
#include "io/schema_table.hpp"

#include <cmath>

namespace eisph {

namespace {

constexpr double kWhite = 255.0;
constexpr double kMostPixels = 20000.0;

KeyTable<SyntheticCamera> camera_keys() {
  KeyTable<SyntheticCamera> keys;
  keys.integer("width", "pixels", &SyntheticCamera::width, between(64.0, kMostPixels), "Of the pictures.");
  keys.integer("height", "pixels", &SyntheticCamera::height, between(64.0, kMostPixels), "Of the pictures.");
  keys.add(
      {.name = "bit_depth", .type = "8 or 16", .meaning = "Bits of a grey level."},
      [](const toml::node& node, int, SyntheticCamera& camera) {
        long long bits = 0;
        if (!read_integer(node, between(8.0, 16.0), bits) || (bits != 8 && bits != 16)) return false;
        camera.bit_depth = static_cast<int>(bits);
        return true;
      },
      [](const SyntheticCamera& camera, int) { return std::to_string(camera.bit_depth); });
  keys.number("elevation", "m", &SyntheticCamera::elevation, above(0.0), "Of the camera above the floor.");
  keys.number("tilt", "degrees", &SyntheticCamera::tilt, between(-40.0, 40.0), "Of the camera, towards x.");
  keys.number("roll", "degrees", &SyntheticCamera::roll, between(-180.0, 180.0), "About the optical axis.");
  keys.number("margin", "", &SyntheticCamera::margin, between(0.01, 0.4),
              "Share of the picture left free at each side of the area.");
  keys.number("radial_distortion", "", &SyntheticCamera::radial_distortion, between(-0.2, 0.2),
              "k1 of the lens: u_d = u (1 + k1 r^2), r in half diagonals of the picture.");
  return keys;
}

KeyTable<SyntheticLight> light_keys() {
  KeyTable<SyntheticLight> keys;
  keys.number("bright", "of 255", &SyntheticLight::bright, above_to(0.0, kWhite), "Level of the dry floor.");
  keys.number("extinction_length", "m", &SyntheticLight::extinction_length, above(0.0),
              "Depth over which the light falls to 1/e.");
  keys.number("falloff", "", &SyntheticLight::falloff, between(0.0, 1.0), "Share missing in the corners.");
  keys.number("gradient", "", &SyntheticLight::gradient, between(-1.0, 1.0),
              "Share that is more at the right.");
  keys.number("noise", "of 255", &SyntheticLight::noise, at_least(0.0), "Standard deviation of a pixel.");
  keys.number("frame", "of 255", &SyntheticLight::frame, between(0.0, kWhite), "Level outside the area.");
  keys.number("solid", "of 255", &SyntheticLight::solid, between(0.0, kWhite), "Level of solids.");
  return keys;
}

KeyTable<SyntheticRims> rim_keys() {
  KeyTable<SyntheticRims> keys;
  keys.number("width", "m", &SyntheticRims::width, at_least(0.0),
              "Mean width of the dark rims that bubbles make in water at walls and solids; 0: none.");
  keys.number("darkness", "", &SyntheticRims::darkness, between(0.0, 1.0),
              "Share of the light lost at the wall.");
  return keys;
}

KeyTable<SyntheticSettings> synthetic_keys() {
  KeyTable<SyntheticSettings> keys;
  keys.add(
      {.name = "calibration_depths",
       .type = "a list of two or more rising numbers, each at least 0",
       .unit = "m",
       .meaning = "Depths of the photographs of still water."},
      [](const toml::node& node, int, SyntheticSettings& settings) {
        return read_ascending(node, at_least(0.0), settings.calibration_depths) &&
               settings.calibration_depths.size() >= 2;
      },
      [](const SyntheticSettings& settings, int) { return write_numbers(settings.calibration_depths); });
  keys.integer("seed", "", &SyntheticSettings::seed, between(0.0, 2147483647.0), "Of noise and rims.");
  keys.section("camera", &SyntheticSettings::camera, camera_keys(), "Above the middle of the area.");
  keys.section("light", &SyntheticSettings::light, light_keys(), "From below through coloured water.");
  keys.section("rims", &SyntheticSettings::rims, rim_keys(), "Air bubbles.");
  return keys;
}

}  // namespace

SyntheticSettings load_synthetic_settings(const std::optional<std::filesystem::path>& file,
                                          const std::vector<std::string>& overrides) {
  const std::filesystem::path path = file.value_or(home_folder() / "assets" / "synthetic_camera.toml");
  TomlSource source(path, overrides,
                    {.expected = "a camera file (TOML)", .example = "light.noise=0 or camera.bit_depth=16"});
  SyntheticSettings settings;
  settings.source_file = path.string();
  SectionReader reader{.source = source, .dimension = 3};
  synthetic_keys().read(reader, "", source.root(), settings);
  return settings;
}

std::string synthetic_schema_text() {
  SchemaWriter writer{
      .text =
          "Keys of a camera file (TOML) of synthetic photographs. SI units; grey levels from 0 to 255.\n\n"
          "[top of the file]\n"};
  synthetic_keys().describe(writer, "");
  return writer.text;
}

}  // namespace eisph
