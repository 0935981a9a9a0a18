// Keys of the repeated sections: solids, instruments, outputs and images.

#include "io/scene_keys.hpp"

#include <cmath>
#include <cstdlib>
#include <numbers>

#include <fmt/format.h>

namespace eisph {

namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

/// The shortest number of degrees that gives this angle back.
std::string write_degrees(double angle) {
  for (int digits = 1; digits < 17; ++digits) {
    const std::string text = fmt::format("{:.{}g}", angle * 180.0 / std::numbers::pi, digits);
    const double degrees = std::strtod(text.c_str(), nullptr);
    if (radians(degrees) == angle) return write_number(degrees);
  }
  return write_number(angle * 180.0 / std::numbers::pi);
}

/// A list of names.
template <class Owner>
Key<Owner>& add_names(KeyTable<Owner>& keys, const std::string& name, std::vector<std::string> Owner::*field,
                      const std::string& meaning) {
  return keys.add(
      {.name = name, .type = "a list of names", .meaning = meaning},
      [=](const toml::node& node, int, Owner& owner) { return read_names(node, owner.*field); },
      [=](const Owner& owner, int) { return write_names(owner.*field); });
}

/// Keys of the shape that an owner has as its member `shape`.
template <class Owner>
void add_shape_keys(KeyTable<Owner>& keys) {
  const auto kind = [](auto& owner) -> auto& { return owner.shape.kind; };
  const auto is = [](ShapeKind wanted) {
    return [=](const Owner& owner, int) { return owner.shape.kind == wanted; };
  };
  const auto is_round = [](const Owner& owner, int) { return owner.shape.kind != ShapeKind::Box; };
  const std::string box = "with shape = \"box\"";
  const std::string round = "with shape = \"cylinder\" or \"sphere\"";
  keys.template choice<ShapeKind>(
      "shape", kind,
      {{"box", ShapeKind::Box}, {"cylinder", ShapeKind::Cylinder}, {"sphere", ShapeKind::Sphere}},
      "Form of the body. A cylinder is upright and for 3D only; in 2D a sphere is a disc.");
  keys.vector(
          "min", "m", [](auto& owner) -> auto& { return owner.shape.min; }, "Lower corner, before rotation.")
      .when(box, is(ShapeKind::Box))
      .required();
  keys.vector(
          "max", "m", [](auto& owner) -> auto& { return owner.shape.max; }, "Upper corner, before rotation.")
      .when(box, is(ShapeKind::Box))
      .required();
  keys.add(
          {.name = "rotation_z",
           .type = "a number from -360 to 360",
           .unit = "degrees",
           .meaning = "Rotation about the vertical axis through the centre, anticlockwise seen from above."},
          [](const toml::node& node, int, Owner& owner) {
            double degrees = 0.0;
            if (!read_number(node, between(-360.0, 360.0), degrees)) return false;
            owner.shape.rotation_z = radians(degrees);
            return true;
          },
          [](const Owner& owner, int) { return write_degrees(owner.shape.rotation_z); })
      .when(box + " and dimension = 3", [](const Owner& owner, int dimension) {
        return owner.shape.kind == ShapeKind::Box && dimension == 3;
      });
  keys.vector(
          "centre", "m", [](auto& owner) -> auto& { return owner.shape.centre; },
          "Centre of the sphere; for a cylinder the centre of its base.")
      .when(round, is_round)
      .required();
  keys.number(
          "radius", "m", [](auto& owner) -> auto& { return owner.shape.radius; }, above(0.0), "Radius.")
      .when(round, is_round)
      .required();
  keys.number(
          "height", "m", [](auto& owner) -> auto& { return owner.shape.height; }, above(0.0), "Height.")
      .when("with shape = \"cylinder\"", is(ShapeKind::Cylinder))
      .required();
}

template <class Owner>
void add_schedule_keys(KeyTable<Owner>& keys, const std::string& prefix, Schedule Owner::*schedule,
                       const std::string& what, const std::string& fallback) {
  keys.instants(
          prefix + "times", [=](auto& owner) -> auto& { return (owner.*schedule).times; },
          "Times of " + what + ". With an interval as well, both count; an empty list alone means never.")
      .fallback(fallback);
  keys.number(
          prefix + "interval", "s", [=](auto& owner) -> auto& { return (owner.*schedule).interval; },
          at_least(0.0), "Interval of " + what + ", from t = 0 on; 0: none.")
      .fallback(fallback);
}

KeyTable<Camera> camera_keys() {
  KeyTable<Camera> keys;
  const auto is = [](Projection wanted) {
    return [=](const Camera& camera, int) { return camera.projection == wanted; };
  };
  keys.choice<Projection>(
      "projection", &Camera::projection,
      {{"perspective", Projection::Perspective}, {"orthographic", Projection::Orthographic}},
      "Kind of projection.");
  const auto three = [&](const std::string& name, Vec3d Camera::*member, const std::string& unit,
                         const std::string& meaning) -> Key<Camera>& {
    return keys.add(
        {.name = name, .type = "a list [x, y, z] of numbers", .unit = unit, .meaning = meaning},
        [=](const toml::node& node, int, Camera& camera) { return read_vector(node, 3, camera.*member); },
        [=](const Camera& camera, int) { return write_vector(camera.*member, 3); });
  };
  three("eye", &Camera::eye, "m", "Position of the camera, also in 2D with all of x, y, z.").required();
  three("target", &Camera::target, "m", "Point in the middle of the picture.").required();
  three("up", &Camera::up, "", "Direction that points upwards in the picture.");
  keys.number("field_of_view", "degrees", &Camera::field_of_view, between(1.0, 170.0),
              "Vertical angle of view.")
      .when("with projection = \"perspective\"", is(Projection::Perspective));
  keys.number("orthographic_height", "m", &Camera::orthographic_height, above(0.0),
              "Height of the scene that the picture shows.")
      .when("with projection = \"orthographic\"", is(Projection::Orthographic))
      .required();
  return keys;
}

}  // namespace

KeyTable<FluidRegion> fluid_region_keys() {
  KeyTable<FluidRegion> keys;
  add_shape_keys(keys);
  keys.boolean("cut", &FluidRegion::cut, "Take this part out of the water instead of adding it.");
  keys.vector("velocity", "m/s", &FluidRegion::velocity, "Velocity at t = 0.")
      .when("with cut = false", [](const FluidRegion& region, int) { return !region.cut; });
  keys.number("angular_velocity", "rad/s", &FluidRegion::angular_velocity, any_number(),
              "Rotation at t = 0 about the y axis through the centre of the region, added to the velocity.")
      .when("with cut = false", [](const FluidRegion& region, int) { return !region.cut; });
  keys.number(
          "vortex_speed", "m/s", &FluidRegion::vortex_speed, any_number(),
          "Largest speed along x of a Taylor-Green vortex at t = 0, one period over the region in x and z.")
      .when("with cut = false", [](const FluidRegion& region, int) { return !region.cut; });
  return keys;
}

KeyTable<Obstacle> obstacle_keys() {
  KeyTable<Obstacle> keys;
  keys.identifier("name", &Obstacle::name, "Name, unlike those of all other solids.").required();
  add_shape_keys(keys);
  return keys;
}

KeyTable<Gate> gate_keys() {
  KeyTable<Gate> keys;
  const auto lifted = [](const Gate& gate, int) { return gate.motion == GateMotion::Lift; };
  const std::string with_lift = "with motion = \"lift\"";
  keys.identifier("name", &Gate::name, "Name, unlike those of all other solids.").required();
  add_shape_keys(keys);
  keys.choice<GateMotion>("motion", &Gate::motion,
                          {{"instant", GateMotion::Instant}, {"lift", GateMotion::Lift}},
                          "The gate vanishes, or is lifted by its stroke and then gone.");
  keys.number("start_time", "s", &Gate::start_time, at_least(0.0), "When it vanishes or starts to rise.");
  keys.number("stroke", "m", &Gate::stroke, above(0.0), "How far it is lifted.")
      .when(with_lift, lifted)
      .required();
  keys.number("speed", "m/s", &Gate::speed, above(0.0), "Speed of the lift; this or duration is needed.")
      .when(with_lift, lifted)
      .fallback("stroke / duration");
  keys.add(
          {.name = "duration",
           .type = "a number above 0",
           .unit = "s",
           .meaning = "Time that the lift takes; this or speed is needed."},
          [](const toml::node& node, int, Gate& gate) {
            double duration = 0.0;
            if (!read_number(node, above(0.0), duration)) return false;
            gate.speed = gate.stroke / duration;
            return true;
          },
          [](const Gate&, int) { return std::string(); })
      .when(with_lift, lifted)
      .fallback("stroke / speed");
  return keys;
}

KeyTable<Gauge> gauge_keys() {
  KeyTable<Gauge> keys;
  keys.identifier("name", &Gauge::name, "Name of the record, unlike those of all other probes.").required();
  keys.add(
          {.name = "position",
           .type = "a list [x, y] of numbers, in 2D [x]",
           .unit = "m",
           .meaning = "Axis of the column."},
          [](const toml::node& node, int dimension, Gauge& gauge) {
            std::vector<double> numbers;
            if (!read_numbers(node, numbers) || static_cast<int>(numbers.size()) != dimension - 1)
              return false;
            gauge.x = numbers[0];
            gauge.y = dimension == 3 ? numbers[1] : 0.0;
            return true;
          },
          [](const Gauge& gauge, int dimension) {
            return dimension == 3 ? write_numbers({gauge.x, gauge.y}) : write_numbers({gauge.x});
          })
      .required();
  keys.number("size", "m", &Gauge::size, above(0.0), "Side of the column.").fallback("1.5 dx");
  keys.number("height", "m", &Gauge::height, above(0.0), "Height of the column above the floor.")
      .fallback("the height of the domain");
  keys.boolean(
      "ignore_spray", &Gauge::ignore_spray,
      "Leave spray, particles in the air with a number density below that of an edge of water, out of the "
      "level; false: the highest particle, whatever it is (thesis).");
  keys.number("interval", "s", &Gauge::interval, above(0.0), "Time between records.").fallback("0.01");
  return keys;
}

KeyTable<PointProbe> probe_keys() {
  KeyTable<PointProbe> keys;
  keys.identifier("name", &PointProbe::name, "Name of the record, unlike those of all other probes.")
      .required();
  keys.vector("position", "m", &PointProbe::position, "The point.").required();
  keys.number("interval", "s", &PointProbe::interval, above(0.0), "Time between records.").fallback("0.01");
  return keys;
}

KeyTable<OutputSettings> output_keys() {
  KeyTable<OutputSettings> keys;
  add_schedule_keys(keys, "", &OutputSettings::frames, "frames of images without an own schedule",
                    "without both: one frame at the end time");
  add_schedule_keys(keys, "particles_", &OutputSettings::particles, "particle files (.vtp)",
                    "without both: as times and interval");
  add_schedule_keys(keys, "depth_", &OutputSettings::depth, "depth grids (.vti)",
                    "without both: as times and interval");
  keys.number("ledger_interval", "s", &OutputSettings::ledger_interval, at_least(0.0),
              "Interval of the leading edge and the ledger; 0: only at the times of other outputs.");
  keys.number("depth_cell_size", "m", &OutputSettings::depth_cell_size, above(0.0), "Cell of the depth grid.")
      .fallback("1.5 dx");
  keys.choice<DepthRule>(
      "depth_rule", &OutputSettings::depth_rule,
      {{"highest_particle", DepthRule::HighestParticle}, {"surface", DepthRule::Surface}},
      "Depth of a cell: height of the highest particle in it (thesis), or a smooth level without holes.");
  keys.boolean(
      "ignore_spray", &OutputSettings::ignore_spray,
      "The highest particle is one that is no spray: not in the air with a number density below that of an "
      "edge of water; false: of all particles (thesis). The smooth level counts spray by its volume.");
  keys.choice<bool>(
      "frames", &OutputSettings::latest_frame_only, {{"every", false}, {"latest", true}},
      "Draw every frame, the run waiting if need be, or drop those that the renderer is too slow for.");
  keys.integer("queue_length", "", &OutputSettings::queue_length, between(1.0, 1000.0),
               "Frames that may wait for the renderer.");
  return keys;
}

KeyTable<ImageSettings> image_keys() {
  KeyTable<ImageSettings> keys;
  const auto is = [](ImageKind wanted) {
    return [=](const ImageSettings& image, int) { return image.kind == wanted; };
  };
  const auto is_not_panels = [](const ImageSettings& image, int) { return image.kind != ImageKind::Panels; };
  const auto is_space = [](const ImageSettings& image, int dimension) {
    return image.kind == ImageKind::Particles && dimension == 3;
  };
  const std::string particles = "with kind = \"particles\"";
  const std::string depth_map = "with kind = \"depth_map\"";
  const std::string panels = "with kind = \"panels\"";
  const std::string not_panels = "with kind = \"particles\" or \"depth_map\"";
  const std::string space = particles + " in 3D";
  keys.identifier("name", &ImageSettings::name, "Name of the sequence, unlike those of all other images.")
      .required();
  keys.choice<ImageKind>("kind", &ImageSettings::kind,
                         {{"particles", ImageKind::Particles},
                          {"depth_map", ImageKind::DepthMap},
                          {"panels", ImageKind::Panels}},
                         "The water seen by a camera, its depth seen from above (3D only), or several images "
                         "and gauges in one frame.");
  keys.string("caption", &ImageSettings::caption, "Text below the picture; empty: none.");
  keys.integer("width", "pixels", &ImageSettings::width, between(16.0, 16384.0), "Width of a frame.");
  keys.integer("height", "pixels", &ImageSettings::height, between(16.0, 16384.0), "Height of a frame.");
  keys.choice<WaterStyle>("style", &ImageSettings::style,
                          {{"particles", WaterStyle::Spheres}, {"surface", WaterStyle::Surface}},
                          "Particles as spheres, or the smooth surface of transparent water.")
      .when(space, is_space);
  std::vector<std::pair<std::string, std::string>> fields;
  for (const char* field :
       {"speed", "velocity_x", "velocity_y", "velocity_z", "pressure", "depth", "kind", "water"}) {
    fields.emplace_back(field, field);
  }
  keys.choice<std::string>("field", &ImageSettings::field, fields,
                           "Quantity shown as colour; velocity_y in 3D only, kind with style = "
                           "\"particles\" only. water: none, with style = \"surface\" only.")
      .fallback("\"speed\", with style = \"surface\" \"water\"")
      .when(particles, is(ImageKind::Particles));
  keys.string("colour_map", &ImageSettings::colour_map, "A table in assets/colour_maps, or grey_depth.")
      .fallback("\"viridis\", for depth maps \"depth_blue\"")
      .when(not_panels, is_not_panels);
  keys.add(
          {.name = "range",
           .type = "\"automatic\" or a list of two rising numbers",
           .unit = "the unit of the field",
           .meaning = "Ends of the colour bar."},
          [](const toml::node& node, int, ImageSettings& image) {
            std::string word;
            image.range.reset();
            if (read_text(node, word)) return word == "automatic";
            std::vector<double> ends;
            if (!read_ascending(node, any_number(), ends) || ends.size() != 2) return false;
            image.range = {ends[0], ends[1]};
            return true;
          },
          [](const ImageSettings& image, int) {
            return image.range ? write_numbers({(*image.range)[0], (*image.range)[1]})
                               : write_text("automatic");
          })
      .when(not_panels, is_not_panels);
  keys.number("dry_depth", "m", &ImageSettings::dry_depth, at_least(0.0),
              "Shallower water is drawn as background.")
      .when(depth_map, is(ImageKind::DepthMap));
  keys.boolean("mirror", &ImageSettings::mirror, "Draw the mirror image beyond symmetry planes as well.")
      .when(depth_map, is(ImageKind::DepthMap));
  keys.boolean("draw_walls", &ImageSettings::draw_walls, "Draw the walls of the domain.")
      .when(not_panels, is_not_panels);
  keys.boolean("draw_obstacles", &ImageSettings::draw_obstacles, "Draw obstacles, dam walls and gates.")
      .when(not_panels, is_not_panels);
  keys.boolean("glass", &ImageSettings::glass, "Draw walls as panes of glass, not only their edges.")
      .when(space, is_space);
  keys.boolean("shadow", &ImageSettings::shadow, "Draw the soft shadow of water and solids on the floor.")
      .when(space, is_space);
  const auto add_particle_key = [&](const char* name, bool ImageSettings::*field, const char* meaning) {
    keys.boolean(name, field, meaning).when(particles, is(ImageKind::Particles));
  };
  add_particle_key("draw_fluid", &ImageSettings::draw_fluid, "Draw the fluid particles.");
  add_particle_key("draw_objects", &ImageSettings::draw_objects,
                   "Draw object particles one by one; with field = \"kind\" they always are.");
  add_particle_key("draw_ghosts", &ImageSettings::draw_ghosts,
                   "Draw ghost particles, the mirror images of the fluid beyond the walls.");
  add_particle_key("draw_virtual_particles", &ImageSettings::draw_virtual_particles,
                   "Draw the lattice of virtual particles on the walls.");
  keys.choice<bool>("background", &ImageSettings::dark_background, {{"light", false}, {"dark", true}},
                    "Background.");
  add_names(keys, "panels", &ImageSettings::panels,
            "Images to draw in the frame, by name: the first is the large one. At least one.")
      .when(panels, is(ImageKind::Panels));
  add_names(keys, "gauges", &ImageSettings::gauges,
            "Gauges whose free surface is drawn over time up to the present, by name.")
      .when(panels, is(ImageKind::Panels));
  add_schedule_keys(keys, "", &ImageSettings::schedule, "frames", "without both: as in [output]");
  KeyTable<ClipBox> clip;
  clip.vector("min", "m", &ClipBox::min, "Lower corner.").required();
  clip.vector("max", "m", &ClipBox::max, "Upper corner.").required();
  keys.optional_section("clip", &ImageSettings::clip, clip,
                        "Shows only what is inside this box. Only with kind = \"particles\".");
  keys.optional_section(
      "camera", &ImageSettings::camera, camera_keys(),
      "Default: the whole domain from the front and above. Only with kind = \"particles\".");
  return keys;
}

}  // namespace eisph
