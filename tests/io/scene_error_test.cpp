#include "io/scene_text.hpp"

#include <ctime>
#include <ostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eisph {
namespace {

using testing::HasSubstr;

/// One edit of the test scene and what the message must say; line 0: nothing in the file stands for it.
struct ErrorCase {
  const char* name;
  const char* from;
  const char* to;
  int line;
  std::vector<std::string> pieces;
};

std::ostream& operator<<(std::ostream& stream, const ErrorCase& error_case) {
  return stream << error_case.name;
}
std::string name_of_case(const testing::TestParamInfo<ErrorCase>& info) { return info.param.name; }

/// The message of the edited scene has the file, the line and all pieces, on one line.
void expect_error(const std::string& base, const ErrorCase& error_case) {
  SceneLoader loader;
  const std::string message = loader.error(edited(base, error_case.from, error_case.to));
  const std::string place = error_case.line > 0 ? "case.toml:" + std::to_string(error_case.line) + ": "
                                                : std::string("case.toml: ");
  EXPECT_THAT(message, HasSubstr(place));
  for (const std::string& piece : error_case.pieces) EXPECT_THAT(message, HasSubstr(piece));
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

class SceneError : public testing::TestWithParam<ErrorCase> {};
TEST_P(SceneError, NamesPlaceKeyValueAndWhatIsAccepted) { expect_error(kSceneText, GetParam()); }

class SceneError2d : public testing::TestWithParam<ErrorCase> {};
TEST_P(SceneError2d, NamesPlaceKeyValueAndWhatIsAccepted) { expect_error(kSceneText2d, GetParam()); }

// clang-format off
INSTANTIATE_TEST_SUITE_P(
    Keys, SceneError,
    testing::Values(
        ErrorCase{"syntax", "spacing = 0.1", "spacing = = 0.1", 5, {"not valid TOML"}},
        ErrorCase{"repeated_key", "spacing = 0.1", "spacing = 0.1\nspacing = 0.2", 6,
                  {"not valid TOML", "spacing"}},
        ErrorCase{"unknown_key", "spacing = 0.1", "spacng = 0.1", 5,
                  {"particles.spacng = 0.1", "unknown key", "did you mean spacing?", "smoothing_ratio"}},
        ErrorCase{"unknown_section", "[[probe]]", "[[porbe]]", 34, {"porbe", "did you mean probe?"}},
        ErrorCase{"unknown_key_far_from_any", "end_time = 1.0", "xyzzy_quux_plugh = 1", 3,
                  {"xyzzy_quux_plugh = 1", "unknown key; accepted here: dimension, name"}},
        ErrorCase{
            "missing_key", "spacing = 0.1", "", 4, {"particles.spacing: missing", "a number above 0, in m"}},
        ErrorCase{"missing_key_at_the_top", "end_time = 1.0", "", 0, {"end_time: missing", "above 0, in s"}},
        ErrorCase{"missing_key_of_a_box", "max = [2.3, 0.6, 1.0]", "", 16,
                  {"obstacle.0.max: missing", "[x, y, z]"}},
        ErrorCase{"wrong_type_number", "spacing = 0.1", "spacing = \"fine\"", 5,
                  {"particles.spacing = \"fine\"", "expected a number above 0"}},
        ErrorCase{"wrong_type_text", "name = \"test\"", "name = 5", 1, {"name = 5", "expected a name"}},
        ErrorCase{"wrong_type_integer", "dimension = 3", "dimension = 3.0", 2,
                  {"dimension = 3.0", "a whole number from 2 to 3"}},
        ErrorCase{"wrong_type_boolean", "[output]", "[boundary]\nghost_particles = 1\n[output]", 38,
                  {"boundary.ghost_particles = 1", "true or false"}},
        ErrorCase{"wrong_type_section", "[output]\ntimes = [0.25, 0.5]", "[[output]]", 37,
                  {"output", "expected a section [output]"}},
        ErrorCase{"wrong_type_list", "[[probe]]", "[probe]", 34, {"probe", "expected sections [[probe]]"}},
        ErrorCase{
            "not_a_number", "spacing = 0.1", "spacing = nan", 5, {"particles.spacing = nan", "above 0"}},
        ErrorCase{"infinite", "end_time = 1.0", "end_time = inf", 3, {"end_time = inf", "above 0"}},
        ErrorCase{
            "spacing_zero", "spacing = 0.1", "spacing = 0", 5, {"particles.spacing = 0", "above 0, in m"}},
        ErrorCase{"end_time_zero", "end_time = 1.0", "end_time = 0.0", 3, {"end_time = 0.0", "above 0"}},
        ErrorCase{"dimension_four", "dimension = 3", "dimension = 4", 2, {"dimension = 4", "from 2 to 3"}},
        ErrorCase{"smoothing_ratio", "spacing = 0.1", "spacing = 0.1\nsmoothing_ratio = 2.1", 6,
                  {"particles.smoothing_ratio = 2.1", "from 1 to 2"}},
        ErrorCase{"kernel", "spacing = 0.1", "spacing = 0.1\nkernel = \"wendland\"", 6,
                  {"particles.kernel = \"wendland\"", "one of \"quintic_spline\", \"wendland_c2\", \"cubic_spline\""}},
        ErrorCase{"slip_factor", "z_max = \"open\"", "z_max = 1.5", 15,
                  {"domain.faces.z_max = 1.5", "slip factor from 0 (no slip) to 1 (free slip)"}},
        ErrorCase{"face_word", "z_max = \"open\"", "z_max = \"slippery\"", 15,
                  {"domain.faces.z_max = \"slippery\"", "\"free_slip\"", "\"symmetry\""}},
        ErrorCase{"density", "density = 1000.0", "density = -1.0", 7,
                  {"fluid.density = -1.0", "above 0, in kg/m^3"}},
        ErrorCase{"gravity_zero", "end_time = 1.0", "end_time = 1.0\ngravity = [0.0, 0.0, 0.0]", 4,
                  {"gravity = [0.0, 0.0, 0.0]", "not zero"}},
        ErrorCase{"vector_of_two_in_3d", "max = [1.0, 1.0, 0.5]", "max = [1.0, 0.5]", 10,
                  {"fluid.region.0.max = [1.0, 0.5]", "[x, y, z]"}},
        ErrorCase{"key_of_another_shape", "name = \"pillar\"", "name = \"pillar\"\nradius = 0.1", 18,
                  {"obstacle.0.radius = 0.1", "only accepted with shape = \"cylinder\" or \"sphere\""}},
        ErrorCase{"name_with_a_slash", "name = \"pillar\"", "name = \"a/b\"", 17,
                  {"obstacle.0.name = \"a/b\"", "letters, digits, _ and -"}},
        ErrorCase{"solver", "[output]", "[scheme]\nname = \"swe\"\n[output]", 38,
                  {"scheme.name = \"swe\"", "one of \"eisph\""}},
        ErrorCase{"time_step", "[output]", "[scheme]\ntime_step = 0\n[output]", 38,
                  {"scheme.time_step = 0", "\"adaptive\" or a number above 0, in s"}},
        ErrorCase{"volume_correction", "[output]", "[scheme]\nvolume_correction = \"none\"\n[output]", 38,
                  {"scheme.volume_correction = \"none\"", "\"automatic\" or a number from 0 to 4"}}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Settings, SceneError,
    testing::Values(
        ErrorCase{"same_solid_name", "name = \"dam\"", "name = \"pillar\"", 21,
                  {"dam.0.name = \"pillar\"", "already taken by obstacle.0"}},
        ErrorCase{"same_gate_name", "name = \"gate\"", "name = \"dam\"", 25,
                  {"gate.0.name = \"dam\"", "already taken by dam.0"}},
        ErrorCase{"same_record_name", "name = \"floor\"", "name = \"level\"", 35,
                  {"probe.0.name = \"level\"", "already taken by gauge.0"}},
        ErrorCase{"same_image_name", "", "[[image]]\nname = \"view\"\n", 45,
                  {"image.1.name = \"view\"", "already taken by image.0"}},
        ErrorCase{"gate_speed_and_duration", "duration = 0.2", "duration = 0.2\nspeed = 4.0", 30,
                  {"gate.0.duration = 0.2", "expected one of the two"}},
        ErrorCase{
            "gate_without_speed", "duration = 0.2", "", 24, {"gate.0.speed: missing", "or duration (in s)"}},
        ErrorCase{"gate_without_stroke", "stroke = 0.8", "", 24, {"gate.0.stroke: missing", "above 0, in m"}},
        ErrorCase{"stroke_of_an_instant_gate", "motion = \"lift\"", "motion = \"instant\"", 29,
                  {"gate.0.stroke = 0.8", "only accepted with motion = \"lift\""}},
        ErrorCase{"times_beyond_the_end", "times = [0.25, 0.5]", "times = [0.25, 1.5]", 38,
                  {"output.times = [0.25, 1.5]", "1.5 s is beyond", "up to end_time = 1 s"}},
        ErrorCase{"image_times_beyond_the_end", "name = \"view\"", "name = \"view\"\ntimes = [2.0]", 41,
                  {"image.0.times = [2.0]", "up to end_time = 1 s"}},
        ErrorCase{"times_falling", "times = [0.25, 0.5]", "times = [0.5, 0.25]", 38,
                  {"output.times = [0.5, 0.25]", "a list of rising times"}},
        ErrorCase{"time_negative", "times = [0.25, 0.5]", "times = [-0.5, 0.25]", 38, {"each at least 0"}},
        ErrorCase{"camera_at_its_target", "eye = [2.0, -5.0, 2.0]", "eye = [2.0, 0.5, 0.5]", 42,
                  {"image.0.camera.eye = [2.0, 0.5, 0.5]", "at its own target"}},
        ErrorCase{"camera_up_along_the_view", "eye = [2.0, -5.0, 2.0]", "eye = [2.0, 0.5, 5.0]", 41,
                  {"image.0.camera.up = [0.0, 0.0, 1.0]", "not along the view"}},
        ErrorCase{"orthographic_without_height", "[image.camera]",
                  "[image.camera]\nprojection = \"orthographic\"", 41,
                  {"image.0.camera.orthographic_height: missing", "above 0, in m"}},
        ErrorCase{"colour_map", "name = \"view\"", "name = \"view\"\ncolour_map = \"jet\"", 41,
                  {"image.0.colour_map = \"jet\"", "expected one of", "cividis", "grey_depth", "viridis"}},
        ErrorCase{"field", "name = \"view\"", "name = \"view\"\nfield = \"vorticity\"", 41,
                  {"image.0.field = \"vorticity\"", "\"speed\"", "\"pressure\""}},
        ErrorCase{"field_of_a_depth_map", "[image.camera]\neye = [2.0, -5.0, 2.0]\ntarget = [2.0, 0.5, 0.5]",
                  "kind = \"depth_map\"\nfield = \"speed\"", 42,
                  {"image.0.field = \"speed\"", "only accepted with kind = \"particles\""}},
        ErrorCase{"camera_of_a_depth_map", "[image.camera]", "kind = \"depth_map\"\n[image.camera]", 42,
                  {"image.0.camera", "only accepted with kind = \"particles\""}},
        ErrorCase{"kind_of_a_surface", "name = \"view\"",
                  "name = \"view\"\nstyle = \"surface\"\nfield = \"kind\"", 42,
                  {"image.0.field = \"kind\"", "style = \"particles\""}},
        ErrorCase{"spheres_without_a_field", "name = \"view\"", "name = \"view\"\nfield = \"water\"", 41,
                  {"image.0.field = \"water\"", "style = \"surface\""}},
        ErrorCase{"panels_without_images", "", "[[image]]\nname = \"all\"\nkind = \"panels\"\n", 44,
                  {"image.1.panels: missing", "some of: view"}},
        ErrorCase{"panel_of_panels", "",
                  "[[image]]\nname = \"all\"\nkind = \"panels\"\npanels = [\"view\", \"all\"]\n", 47,
                  {"image.1.panels = \"all\"", "expected some of: view"}},
        ErrorCase{"unknown_gauge", "",
                  "[[image]]\nname = \"all\"\nkind = \"panels\"\npanels = [\"view\"]\ngauges = [\"absent\"]\n", 48,
                  {"image.1.gauges = \"absent\"", "expected some of: level"}},
        ErrorCase{"panels_of_a_view", "name = \"view\"", "name = \"view\"\npanels = [\"view\"]", 41,
                  {"image.0.panels", "only accepted with kind = \"panels\""}},
        ErrorCase{"colour_map_of_panels", "",
                  "[[image]]\nname = \"all\"\nkind = \"panels\"\npanels = [\"view\"]\ncolour_map = \"viridis\"\n", 48,
                  {"image.1.colour_map", "\"particles\" or \"depth_map\""}},
        ErrorCase{"range_falling", "name = \"view\"", "name = \"view\"\nrange = [2.0, 1.0]", 41,
                  {"image.0.range = [2.0, 1.0]", "two rising numbers"}},
        ErrorCase{"width", "name = \"view\"", "name = \"view\"\nwidth = 0", 41,
                  {"image.0.width = 0", "from 16 to 16384"}}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Geometry, SceneError,
    testing::Values(
        ErrorCase{"domain_inside_out", "max = [4.0, 1.0, 2.0]", "max = [4.0, -1.0, 2.0]", 13,
                  {"domain.max = [4.0, -1.0, 2.0]", "-1 m long in y", "at least 0.132 m"}},
        ErrorCase{"domain_narrower_than_the_kernel", "max = [4.0, 1.0, 2.0]", "max = [4.0, 0.1, 2.0]", 13,
                  {"0.1 m long in y", "the smoothing length"}},
        ErrorCase{"no_region", "[[fluid.region]]\nmin = [0.0, 0.0, 0.0]\nmax = [1.0, 1.0, 0.5]", "", 6,
                  {"fluid.region: missing", "at least one [[fluid.region]]"}},
        ErrorCase{"region_inside_out", "max = [1.0, 1.0, 0.5]", "max = [1.0, -1.0, 0.5]", 10,
                  {"fluid.region.0.max", "expected y above that of min, 0"}},
        ErrorCase{"region_over_the_edge", "max = [1.0, 1.0, 0.5]", "max = [1.0, 1.2, 0.5]", 10,
                  {"fluid.region.0.max = [1.0, 1.2, 0.5]", "out of the domain in y", "[4.0, 1.0, 2.0]"}},
        ErrorCase{"ball_outside", "[domain]",
                  "[[fluid.region]]\nshape = \"sphere\"\ncentre = [9.0, 0.5, 0.5]\nradius = 0.2\n[domain]",
                  13,
                  {"fluid.region.1.centre = [9.0, 0.5, 0.5]", "out of the domain in x"}},
        ErrorCase{"solid_outside", "min = [2.0, 0.3, 0.0]\nmax = [2.3",
                  "min = [5.0, 0.3, 0.0]\nmax = [5.3", 18,
                  {"obstacle.0.min = [5.0, 0.3, 0.0]", "outside the domain"}},
        ErrorCase{"dam_inside_out", "max = [1.2, 0.3, 1.0]", "max = [1.2, 0.3, 0.0]", 23,
                  {"dam.0.max = [1.2, 0.3, 0.0]", "expected z above that of min, 0"}},
        // The centres at x = 0.95 m, in rows at y = 0.35, 0.45, 0.55 m and five levels, are inside the
        // obstacle.
        ErrorCase{"water_in_an_obstacle", "min = [2.0, 0.3, 0.0]\nmax = [2.3",
                  "min = [0.9, 0.3, 0.0]\nmax = [1.0", 17,
                  {"obstacle.0.name = \"pillar\"", "15 fluid particles lie inside", "cut = true"}},
        ErrorCase{"water_in_a_gate", "min = [1.0, 0.3, 0.0]", "min = [0.9, 0.3, 0.0]", 25,
                  {"gate.0.name = \"gate\"", "35 fluid particles lie inside"}},
        ErrorCase{"all_water_cut", "[domain]",
                  "[[fluid.region]]\nmin = [0.0, 0.0, 0.0]\nmax = [1.0, 1.0, 1.0]\ncut = true\n[domain]", 6,
                  {"fluid", "no particle lies in the water"}},
        ErrorCase{"water_thinner_than_the_lattice", "max = [1.0, 1.0, 0.5]", "max = [1.0, 1.0, 0.06]", 10,
                  {"fluid.region.0.max = [1.0, 1.0, 0.06]", "0.06 m thick in z", "particles.spacing = 0.1 m"}},
        ErrorCase{"drop_smaller_than_the_lattice", "[domain]",
                  "[[fluid.region]]\nshape = \"sphere\"\ncentre = [0.5, 0.5, 1.5]\nradius = 0.04\n[domain]", 14,
                  {"fluid.region.1.radius = 0.04", "0.08 m thick, less than a layer"}},
        ErrorCase{"gauge_outside", "position = [0.5, 0.5]", "position = [0.5, 1.5]", 33,
                  {"gauge.0.position = [0.5, 1.5]", "outside the domain"}},
        ErrorCase{"probe_outside", "position = [0.5, 0.5, 0.1]", "position = [0.5, 0.5, -0.1]", 36,
                  {"probe.0.position = [0.5, 0.5, -0.1]", "outside the domain"}},
        ErrorCase{"absurd_count", "spacing = 0.1", "spacing = 1e-5", 5,
                  {"particles.spacing = 1e-05", "GB of memory", "GB are available"}}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Probes, SceneError,
    testing::Values(
        ErrorCase{"sensor_name", "", "[[pressure_sensor]]\nname = \"level\"\nposition = [0.0, 0.5, 0.1]", 45,
                  {"pressure_sensor.0.name = \"level\"", "already taken by gauge.0"}},
        ErrorCase{"front_name", "", "[[front]]\nname = \"floor\"\ndirection = \"+x\"", 45,
                  {"front.0.name = \"floor\"", "already taken by probe.0"}},
        ErrorCase{"line_name", "",
                  "[[line]]\nname = \"level\"\nstart = [0.0, 0.5, 0.1]\nend = [1.0, 0.5, 0.1]", 45,
                  {"line.0.name = \"level\"", "already taken by gauge.0"}},
        ErrorCase{"force_name", "", "[[force]]\nname = \"level\"\nobstacle = \"pillar\"", 45,
                  {"force.0.name = \"level\"", "already taken by gauge.0"}},
        ErrorCase{"discharge_name", "", "[[discharge]]\nname = \"level\"\naxis = \"x\"\nposition = 1.0", 45,
                  {"discharge.0.name = \"level\"", "already taken by gauge.0"}},
        ErrorCase{"sensor_without_position", "", "[[pressure_sensor]]\nname = \"a\"", 44,
                  {"pressure_sensor.0.position: missing", "[x, y, z]"}},
        ErrorCase{"sensor_outside", "", "[[pressure_sensor]]\nname = \"a\"\nposition = [0.0, 0.5, -0.1]", 46,
                  {"pressure_sensor.0.position = [0.0, 0.5, -0.1]", "outside the domain"}},
        ErrorCase{"sensor_off_the_wall", "", "[[pressure_sensor]]\nname = \"a\"\nposition = [0.2, 0.5, 0.5]", 46,
                  {"pressure_sensor.0.position = [0.2, 0.5, 0.5]", "a place on a wall", "as normal"}},
        ErrorCase{"sensor_on_an_open_face", "",
                  "[[pressure_sensor]]\nname = \"a\"\nposition = [2.0, 0.5, 2.0]", 46,
                  {"pressure_sensor.0.position = [2.0, 0.5, 2.0]", "not open"}},
        ErrorCase{"sensor_over_the_edge", "",
                  "[[pressure_sensor]]\nname = \"a\"\nposition = [0.0, 0.5, 0.1]\nsize = 0.3", 47,
                  {"pressure_sensor.0.size = 0.3", "out of the domain in z"}},
        ErrorCase{"sensor_normal_zero", "",
                  "[[pressure_sensor]]\nname = \"a\"\nposition = [0.0, 0.5, 0.1]\nnormal = [0.0, 0.0, 0.0]", 47,
                  {"pressure_sensor.0.normal = [0.0, 0.0, 0.0]", "not all zero"}},
        ErrorCase{"sensor_shape", "",
                  "[[pressure_sensor]]\nname = \"a\"\nposition = [0.0, 0.5, 0.1]\nshape = \"ring\"", 47,
                  {"pressure_sensor.0.shape = \"ring\"", "\"disc\", \"square\""}},
        ErrorCase{"sensor_size", "",
                  "[[pressure_sensor]]\nname = \"a\"\nposition = [0.0, 0.5, 0.1]\nsize = -0.1", 47,
                  {"pressure_sensor.0.size = -0.1", "at least 0, in m"}},
        ErrorCase{"sensor_interval", "",
                  "[[pressure_sensor]]\nname = \"a\"\nposition = [0.0, 0.5, 0.1]\ninterval = 0", 47,
                  {"pressure_sensor.0.interval = 0", "above 0, in s"}},
        ErrorCase{"sensor_response",
                  "",
                  "[[pressure_sensor]]\nname = \"a\"\nposition = [0.0, 0.5, 0.1]\nresponse_time = -1",
                  47,
                  {"pressure_sensor.0.response_time = -1", "at least 0, in s"}},
        ErrorCase{"sensor_response_within_interval",
                  "",
                  "[[pressure_sensor]]\nname = \"a\"\nposition = [0.0, 0.5, 0.1]\nresponse_time = 0.005",
                  47,
                  {"pressure_sensor.0.response_time = 0.005", "less than the 0.01 s between two records"}},
        ErrorCase{"front_without_direction", "", "[[front]]\nname = \"a\"", 44,
                  {"front.0.direction: missing", "\"+x\", \"-x\", \"+y\", \"-y\""}},
        ErrorCase{"front_direction", "", "[[front]]\nname = \"a\"\ndirection = \"+z\"", 46,
                  {"front.0.direction = \"+z\"", "\"-y\""}},
        ErrorCase{"front_range_along_itself", "",
                  "[[front]]\nname = \"a\"\ndirection = \"+x\"\nx_range = [0.0, 1.0]", 47,
                  {"front.0.x_range = [0.0, 1.0]", "only accepted with direction = \"+y\" or \"-y\""}},
        ErrorCase{"front_range_falling", "",
                  "[[front]]\nname = \"a\"\ndirection = \"+x\"\ny_range = [0.5, 0.4]", 47,
                  {"front.0.y_range = [0.5, 0.4]", "two rising numbers, in m"}},
        ErrorCase{"front_range_outside", "",
                  "[[front]]\nname = \"a\"\ndirection = \"-y\"\nz_range = [2.5, 3.0]", 47,
                  {"front.0.z_range = [2.5, 3.0]", "outside the domain"}},
        ErrorCase{"line_start_outside", "",
                  "[[line]]\nname = \"a\"\nstart = [-1.0, 0.5, 0.1]\nend = [1.0, 0.5, 0.1]", 46,
                  {"line.0.start = [-1.0, 0.5, 0.1]", "outside the domain"}},
        ErrorCase{"line_end_outside", "",
                  "[[line]]\nname = \"a\"\nstart = [0.0, 0.5, 0.1]\nend = [1.0, 0.5, 2.1]", 47,
                  {"line.0.end = [1.0, 0.5, 2.1]", "outside the domain"}},
        ErrorCase{"line_without_length", "",
                  "[[line]]\nname = \"a\"\nstart = [1.0, 0.5, 0.1]\nend = [1.0, 0.5, 0.1]", 47,
                  {"line.0.end = [1.0, 0.5, 0.1]", "expected another point"}},
        ErrorCase{"line_points", "",
                  "[[line]]\nname = \"a\"\nstart = [0.0, 0.5, 0.1]\nend = [1.0, 0.5, 0.1]\npoints = 1", 48,
                  {"line.0.points = 1", "a whole number from 2"}},
        ErrorCase{"force_on_nothing", "", "[[force]]\nname = \"a\"\nobstacle = \"tower\"", 46,
                  {"force.0.obstacle = \"tower\"", "one of pillar, dam, gate"}},
        ErrorCase{"force_moment_point", "",
                  "[[force]]\nname = \"a\"\nobstacle = \"pillar\"\nmoment_point = [1.0, 2.0]", 47,
                  {"force.0.moment_point = [1.0, 2.0]", "[x, y, z]"}},
        ErrorCase{"discharge_axis", "", "[[discharge]]\nname = \"a\"\naxis = \"w\"\nposition = 1.0", 46,
                  {"discharge.0.axis = \"w\"", "\"x\", \"y\", \"z\""}},
        ErrorCase{"discharge_outside", "", "[[discharge]]\nname = \"a\"\naxis = \"y\"\nposition = 1.5", 47,
                  {"discharge.0.position = 1.5", "outside the domain"}},
        ErrorCase{"discharge_range_along_itself", "",
                  "[[discharge]]\nname = \"a\"\naxis = \"x\"\nposition = 1.0\nx_range = [0.0, 1.0]", 48,
                  {"discharge.0.x_range = [0.0, 1.0]", "an axis other than \"x\""}},
        ErrorCase{"discharge_range_outside", "",
                  "[[discharge]]\nname = \"a\"\naxis = \"x\"\nposition = 1.0\ny_range = [1.5, 2.0]", 48,
                  {"discharge.0.y_range = [1.5, 2.0]", "outside the domain"}},
        ErrorCase{"depth_rule", "times = [0.25, 0.5]", "depth_rule = \"mean\"", 38,
                  {"output.depth_rule = \"mean\"", "\"highest_particle\", \"surface\""}}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    PlaneProbes, SceneError2d,
    testing::Values(
        ErrorCase{"front_across", "", "[[front]]\nname = \"a\"\ndirection = \"+y\"", 16,
                  {"front.0.direction = \"+y\"", "in 2D \"+x\", \"-x\""}},
        ErrorCase{"front_range_across", "",
                  "[[front]]\nname = \"a\"\ndirection = \"+x\"\ny_range = [0.0, 1.0]", 17,
                  {"front.0.y_range = [0.0, 1.0]", "dimension = 3"}},
        ErrorCase{"discharge_across", "", "[[discharge]]\nname = \"a\"\naxis = \"y\"\nposition = 0.0", 16,
                  {"discharge.0.axis = \"y\"", "no y"}},
        ErrorCase{"force_without_solids", "", "[[force]]\nname = \"a\"\nobstacle = \"block\"", 16,
                  {"force.0.obstacle = \"block\"", "a scene with an [[obstacle]]"}}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Plane, SceneError2d,
    testing::Values(ErrorCase{"vector_of_three", "max = [1.0, 0.5]", "max = [1.0, 1.0, 0.5]", 8,
                  {"fluid.region.0.max = [1.0, 1.0, 0.5]", "in 2D [x, z]"}},
                    ErrorCase{"cylinder", "min = [0.0, 0.0]\nmax = [1.0, 0.5]",
                  "shape = \"cylinder\"\ncentre = [0.5, 0.0]\nradius = 0.2\nheight = 0.2", 7,
                  {"fluid.region.0.shape = \"cylinder\"", "needs dimension = 3"}},
                    ErrorCase{"y_face", "[[image]]", "[domain.faces]\ny_min = \"open\"\n[[image]]", 13,
                  {"domain.faces.y_min = \"open\"", "only accepted with dimension = 3"}},
                    ErrorCase{"rotation", "max = [1.0, 0.5]", "max = [1.0, 0.5]\nrotation_z = 10", 9,
                  {"fluid.region.0.rotation_z = 10", "dimension = 3"}},
                    ErrorCase{"depth_map", "name = \"view\"", "name = \"view\"\nkind = \"depth_map\"", 14,
                  {"image.0.kind = \"depth_map\"", "needs dimension = 3"}},
                    ErrorCase{"surface", "name = \"view\"", "name = \"view\"\nstyle = \"surface\"", 14,
                  {"image.0.style = \"surface\"", "only accepted with kind = \"particles\" in 3D"}},
                    ErrorCase{"shadow", "name = \"view\"", "name = \"view\"\nshadow = true", 14,
                  {"image.0.shadow = true", "in 3D"}},
                    ErrorCase{"velocity_y", "name = \"view\"", "name = \"view\"\nfield = \"velocity_y\"", 14,
                  {"image.0.field = \"velocity_y\"", "another field"}},
                    ErrorCase{"gauge_position", "[[image]]",
                  "[[gauge]]\nname = \"a\"\nposition = [0.5, 0.5]\n[[image]]", 14,
                  {"gauge.0.position = [0.5, 0.5]", "in 2D [x]"}}),
    name_of_case);

// clang-format on

TEST(SceneErrors, FileThatCannotBeReadIsNamed) {
  const TemporaryFolder folder;
  EXPECT_THAT(error_of<InputError>([&] { (void)load_scene(folder / "none.toml"); }),
              HasSubstr("none.toml: cannot be read"));
  EXPECT_THAT(error_of<InputError>([&] { (void)load_scene(folder.path()); }), HasSubstr("cannot be read"));
}

TEST(SceneErrors, TooManyParticlesForTheMemoryComeWithASpacingThatFits) {
  SceneLoader loader;
  put_text(loader.file(), kSceneText);
  constexpr std::uint64_t kMemory = 5'000'000;
  EXPECT_NO_THROW((void)load_scene(loader.file(), {}, kMemory));
  const auto message_for = [&](const std::string& spacing) {
    return error_of<InputError>(
        [&] { (void)load_scene(loader.file(), {"particles.spacing=" + spacing}, kMemory); });
  };
  const std::string message = message_for("0.02");
  EXPECT_THAT(message, HasSubstr("particles.spacing = 0.02"));
  EXPECT_THAT(message, HasSubstr("0.005 GB are available"));
}

TEST(SceneErrors, WaterThatOutgrowsTheMemoryIsCountedAgainstIt) {
  SceneLoader loader;
  put_text(loader.file(), edited(kSceneText2d, "spacing = 0.1", "spacing = 0.005"));
  EXPECT_NO_THROW((void)load_scene(loader.file(), {}, 200U * 100U * 600U + 1'000'000U));
  const std::string message = error_of<InputError>([&] { (void)load_scene(loader.file(), {}, 10'000'000U); });
  EXPECT_THAT(message,
              HasSubstr("about 2e+04 fluid particles, the solids and the grids need 0.0127 GB of memory"));
  EXPECT_THAT(message, HasSubstr("0.01 GB are available"));
  EXPECT_THAT(message, HasSubstr("expected a spacing of 0.0064 m or more"));
  EXPECT_NO_THROW((void)load_scene(loader.file(), {"particles.spacing=0.0064"}, 10'000'000U));
}

TEST(SceneErrors, AbsurdCountIsFoundAtOnce) {
  SceneLoader loader;
  // Time of the processor, which does not depend on what else the machine does.
  const std::clock_t start = std::clock();
  EXPECT_FALSE(loader.error(edited(kSceneText, "spacing = 0.1", "spacing = 1e-7")).empty());
  EXPECT_LT(std::clock() - start, CLOCKS_PER_SEC);
}

}  // namespace
}  // namespace eisph
