#include "io/scene_keys.hpp"

#include "core/scheme_list.hpp"

#include <functional>

namespace eisph {

namespace {

/// Fills the scene itself.
constexpr std::identity kSelf;

KeyTable<Scene> particle_keys() {
  KeyTable<Scene> keys;
  keys.number("spacing", "m", &Scene::particle_spacing, above(0.0),
              "Particle spacing dx of the initial lattice.")
      .required();
  keys.number("smoothing_ratio", "", &Scene::smoothing_ratio, between(1.0, 2.0),
              "Smoothing length over particle spacing, h / dx; the kernel reaches 2 h.")
      .fallback("quintic_spline 1.42 (2D), 1.32 (3D); wendland_c2 1.32, 1.2; cubic_spline 1.32");
  keys.choice<KernelKind>("kernel", &Scene::kernel,
                          {{"quintic_spline", KernelKind::QuinticSpline},
                           {"wendland_c2", KernelKind::WendlandC2},
                           {"cubic_spline", KernelKind::CubicSpline}},
                          "Smoothing kernel, of support 2 h all of them. With the cubic spline of the thesis "
                          "particles pair from h = 1.2 dx on.");
  keys.number("jitter", "dx", &Scene::jitter, between(0.0, 0.5),
              "Largest random displacement of a particle at the start, per component.");
  keys.integer("jitter_seed", "", &Scene::jitter_seed, between(0.0, 4294967295.0),
               "Seed of the displacements: the same seed gives the same run.");
  return keys;
}

KeyTable<Scene> fluid_keys() {
  KeyTable<Scene> keys;
  keys.number("density", "kg/m^3", &Scene::density, above(0.0), "Density of the fluid.");
  keys.number(
      "kinematic_viscosity", "m^2/s", &Scene::kinematic_viscosity, at_least(0.0),
      "Laminar viscosity; water has 1e-6. At 0 with no artificial viscosity the viscous pass is skipped.");
  keys.number("artificial_viscosity", "", &Scene::artificial_viscosity, between(0.0, 1.0),
              "Coefficient alpha_v of the artificial viscosity.");
  keys.number("reference_depth", "m", &Scene::reference_depth, above(0.0),
              "Depth H of the expected speed sqrt(2 g H), which sets time step and repulsion.")
      .fallback("highest minus lowest water");
  keys.list("region", &Scene::fluid, fluid_region_keys(),
            "A body of water, or with cut = true a part taken out of all of them. At least one is needed.");
  return keys;
}

KeyTable<Scene> domain_keys() {
  KeyTable<Scene> keys;
  keys.vector("min", "m", &Scene::domain_min, "Lower corner of the domain; the particle lattice starts here.")
      .required();
  keys.vector("max", "m", &Scene::domain_max, "Upper corner of the domain.").required();
  keys.section("faces", &Scene::faces, faces_keys(), "The six faces of the domain (four in 2D).");
  return keys;
}

bool read_face(const toml::node& node, Face& face) {
  double slip_factor = 0.0;
  if (read_number(node, between(0.0, 1.0), slip_factor)) {
    face = {FaceKind::Wall, slip_factor};
    return true;
  }
  std::string word;
  if (!read_text(node, word)) return false;
  if (word == "free_slip") {
    face = {FaceKind::Wall, 1.0};
  } else if (word == "no_slip") {
    face = {FaceKind::Wall, 0.0};
  } else if (word == "symmetry") {
    face = {FaceKind::Symmetry, 1.0};
  } else if (word == "open") {
    face = {FaceKind::Open, 1.0};
  } else {
    return false;
  }
  return true;
}

std::string write_face(const Face& face) {
  if (face.kind == FaceKind::Symmetry) return write_text("symmetry");
  if (face.kind == FaceKind::Open) return write_text("open");
  if (face.slip_factor == 1.0) return write_text("free_slip");
  if (face.slip_factor == 0.0) return write_text("no_slip");
  return write_number(face.slip_factor);
}

}  // namespace

KeyTable<std::array<Face, kFaceCount>> faces_keys() {
  using Faces = std::array<Face, kFaceCount>;
  KeyTable<Faces> keys;
  const auto add_face = [&](const std::string& name, std::size_t index,
                            const std::string& meaning) -> Key<Faces>& {
    return keys.add(
        {.name = name,
         .type =
             R"(one of "free_slip", "no_slip", "symmetry", "open", or a slip factor from 0 (no slip) to 1 (free slip))",
         .meaning = meaning},
        [=](const toml::node& node, int, Faces& faces) { return read_face(node, faces[index]); },
        [=](const Faces& faces, int) { return write_face(faces[index]); });
  };
  const auto in_3d = [](const Faces&, int dimension) { return dimension == 3; };
  add_face("x_min", kXMin,
           "A wall with a slip factor, a mirror plane, or nothing: what leaves through an open face is taken "
           "out.");
  add_face("x_max", kXMax, "Opposite face.");
  add_face("y_min", kYMin, "Front face.").when("with dimension = 3", in_3d);
  add_face("y_max", kYMax, "Rear face.").when("with dimension = 3", in_3d);
  add_face("z_min", kZMin, "Floor.");
  add_face("z_max", kZMax, "Ceiling; \"open\" is the sky: nothing is taken out there.");
  return keys;
}

KeyTable<SchemeSettings> scheme_keys() {
  KeyTable<SchemeSettings> keys;
  std::vector<std::pair<std::string, std::string>> names;
  std::string meaning;
#define EISPH_SCHEME(scheme, text)      \
  names.emplace_back(#scheme, #scheme); \
  meaning += (meaning.empty() ? "" : "; ") + std::string(text);
  EISPH_SCHEMES(EISPH_SCHEME)
#undef EISPH_SCHEME
  keys.choice<std::string>("name", &SchemeSettings::name, names,
                           meaning +
                               ". With shallow_water, [shallow_water] applies and the other keys here, "
                               "[boundary] and all but the spacing in [particles] have no effect.");
  keys.choice<Stepping>(
      "stepping", &SchemeSettings::stepping,
      {{"symplectic", Stepping::Symplectic},
       {"thesis", Stepping::Thesis},
       {"predictor_corrector", Stepping::PredictorCorrector},
       {"runge_kutta", Stepping::RungeKutta}},
      "Leap-frog, with positions half a step ahead of the velocities; positions by the mean of old and new "
      "velocity (eisph, isph); two stages, or the classical four (wcsph, delta_sph).");
  keys.add(
      {.name = "time_step",
       .type = "\"adaptive\" or a number above 0",
       .unit = "s",
       .meaning = "Time step that follows phi and the viscous limit, or a fixed one."},
      [](const toml::node& node, int, SchemeSettings& scheme) {
        std::string word;
        const bool adaptive = read_text(node, word) && word == "adaptive";
        scheme.time_step_mode = adaptive ? TimeStepMode::Adaptive : TimeStepMode::Fixed;
        return adaptive || read_number(node, above(0.0), scheme.time_step);
      },
      [](const SchemeSettings& scheme, int) {
        const bool adaptive = scheme.time_step_mode == TimeStepMode::Adaptive;
        return adaptive ? write_text("adaptive") : write_number(scheme.time_step);
      });
  keys.number(
          "phi", "", &SchemeSettings::phi, above_to(0.0, 1.0),
          "Time step dt Umax / dx of the adaptive step; Umax is the largest of the speed of the moment, the "
          "initial speed and the weighted reference speed.")
      .fallback("0.17, with thesis stepping 0.06");
  keys.number("reference_speed_weight", "", &SchemeSettings::reference_speed_weight, between(0.1, 1.0),
              "Weight of the reference speed sqrt(2 g H) in the adaptive step of eisph and isph: below 1, "
              "steps are longer as long as no water is that fast.");
  keys.number("source_factor", "", &SchemeSettings::source_factor, above_to(0.0, 20.0),
              "Weight omega of the present velocity in the source of the pressure equation.")
      .fallback("3.0, of isph and with thesis stepping 1.0");
  keys.boolean(
          "viscous_source", &SchemeSettings::viscous_source,
          "Let the viscous acceleration take part in the source of the pressure equation. Without it the "
          "viscous sum is found together with the pressure gradient, one pass over the neighbours less.")
      .fallback("false; of isph and with thesis stepping true");
  keys.add(
          {.name = "volume_correction",
           .type = "\"automatic\" or a number from 0 to 4",
           .meaning = "Strength kappa of the pressure that undoes compression; 0 turns it off."},
          [](const toml::node& node, int, SchemeSettings& scheme) {
            std::string word;
            scheme.volume_correction.reset();
            if (read_text(node, word)) return word == "automatic";
            return read_number(node, between(0.0, 4.0), scheme.volume_correction.emplace());
          },
          [](const SchemeSettings& scheme, int) {
            return scheme.volume_correction ? write_number(*scheme.volume_correction)
                                            : write_text("automatic");
          })
      .fallback("\"automatic\": min(1, 3 phi), with thesis stepping 0.1");
  keys.integer("pressure_sweeps", "", &SchemeSettings::pressure_sweeps, between(1.0, 1000.0),
               "Jacobi sweeps of the pressure equation in a step.");
  keys.number("free_surface_threshold", "", &SchemeSettings::free_surface_threshold, between(0.0, 1.0),
              "Particles of a lower normalised number density are on the free surface and have no pressure.")
      .fallback("quintic_spline 0.93 (2D), 0.91 (3D); others 0.9");
  keys.choice<InitialPressure>(
      "initial_pressure", &SchemeSettings::initial_pressure,
      {{"solve", InitialPressure::Solve},
       {"hydrostatic", InitialPressure::Hydrostatic},
       {"zero", InitialPressure::Zero}},
      "Pressure at t = 0: the pressure equation swept to convergence, rho g depth, or none.");
  keys.boolean("clamp_pressure", &SchemeSettings::clamp_pressure, "Replace negative pressure by zero.");
  keys.number(
      "shifting", "", &SchemeSettings::shifting, between(0.0, 10.0),
      "Coefficient A of a shift of the particles by -A h |u| dt times the gradient of the number density, "
      "away from the free surface; evens out flows that stretch the particles along lines. 0: none.");
  keys.number(
          "pair_separation", "", &SchemeSettings::pair_separation, between(0.0, 1.0),
          "Particles nearer to each other than 0.62 dx are moved apart in every step by this part of what "
          "is missing; their velocities stay. Stretched flow would drive them together in pairs that stand "
          "for one. 0: none.")
      .fallback("0.5; 0 with stepping = \"thesis\"");
  keys.number(
      "list_reach", "dx", &SchemeSettings::list_reach, between(0.0, 2.0),
      "Neighbour lists and mirror images are kept until the fastest particle can have gone this far; what "
      "comes into reach meanwhile is missed, where the kernel is nearly zero. 0: made anew in every step.");
  keys.number("sound_speed", "m/s", &SchemeSettings::sound_speed, at_least(0.0),
              "Speed of sound c0 of wcsph and delta_sph.")
      .fallback("10 Umax, Umax the larger of sqrt(2 g H) and the initial speed");
  keys.number("courant", "", &SchemeSettings::courant, above_to(0.0, 10.0),
              "Adaptive time step of wcsph and delta_sph, dt (c0 + Umax) / h.")
      .fallback("0.25, predictor_corrector 0.4, runge_kutta 1.5");
  keys.number("diffusion", "", &SchemeSettings::diffusion, between(0.0, 1.0),
              "Coefficient delta of the density diffusion of delta_sph.");
  keys.choice<DensityDiffusion>(
      "diffusion_form", &SchemeSettings::diffusion_form,
      {{"renormalised", DensityDiffusion::Renormalised}, {"plain", DensityDiffusion::Plain}},
      "Diffusion of what the renormalised density gradient does not explain, or of the density itself.");
  keys.number("pressure_tolerance", "", &SchemeSettings::pressure_tolerance, above_to(0.0, 0.5),
              "Residual at which isph ends its conjugate gradients, relative to that of no pressure.");
  keys.integer("pressure_iterations", "", &SchemeSettings::pressure_iterations, between(1.0, 100000.0),
               "Most conjugate-gradient iterations of isph in a step.");
  return keys;
}

KeyTable<ShallowWaterSettings> shallow_water_keys() {
  KeyTable<ShallowWaterSettings> keys;
  keys.number("cell_size", "m", &ShallowWaterSettings::cell_size, above(0.0),
              "Side of the square cells. The domain must be a whole number of them long and wide.")
      .fallback("the largest one up to dx that fits the domain");
  keys.number("courant", "", &ShallowWaterSettings::courant, above_to(0.0, 1.0),
              "Time step over the cell size, times the largest sum over the axes of |u| + sqrt(g h).");
  keys.number("manning", "s m^(-1/3)", &ShallowWaterSettings::manning, at_least(0.0),
              "Manning coefficient n of the bed; 0: no friction. Walls are without friction.");
  keys.number("dry_depth", "m", &ShallowWaterSettings::dry_depth, above(0.0),
              "Shallower water counts as dry: it has no velocity.");
  keys.choice<SlopeLimiter>(
      "limiter", &ShallowWaterSettings::limiter,
      {{"minmod", SlopeLimiter::Minmod}, {"monotonised_central", SlopeLimiter::MonotonisedCentral}},
      "Limiter of the slopes; minmod is the smoother one.");
  return keys;
}

KeyTable<BoundarySettings> boundary_keys() {
  KeyTable<BoundarySettings> keys;
  keys.boolean("ghost_particles", &BoundarySettings::ghost_particles,
               "Mirror the water at walls and symmetry planes.");
  keys.boolean("virtual_particles", &BoundarySettings::virtual_particles,
               "Repel water that comes closer to a wall than the cutoff.");
  keys.choice<RepulsionForm>(
      "repulsion_form", &BoundarySettings::repulsion_form,
      {{"even", RepulsionForm::Even}, {"lattice", RepulsionForm::Lattice}},
      "By the distance to the wall, or point by point from a lattice of dx/2 as in the thesis (rougher).");
  keys.boolean("object_repulsion", &BoundarySettings::object_repulsion,
               "Surfaces of obstacles, dams and gates repel by the same law, within 0.625 of the cutoff.");
  keys.number("repulsion_cutoff", "dx", &BoundarySettings::repulsion_cutoff, above_to(0.0, 1.0),
              "Distance r0 from a virtual particle within which the repulsion acts.");
  keys.number("repulsion_strength", "Umax^2", &BoundarySettings::repulsion_strength, at_least(0.0),
              "Square c^2 of the speed that scales the repulsion.");
  keys.number("repulsion_cap", "Umax^2 / dx", &BoundarySettings::repulsion_cap, above(0.0),
              "Largest acceleration that the repulsion causes.");
  keys.boolean("object_no_slip", &BoundarySettings::object_no_slip,
               "Object particles take part in the viscous sum: water sticks to solids instead of slipping.");
  return keys;
}

KeyTable<Scene> scene_keys() {
  KeyTable<Scene> keys;
  keys.integer("dimension", "", &Scene::dimension, between(2.0, 3.0),
               "3, or 2 for the vertical plane y = 0, where all positions are [x, z].");
  keys.identifier("name", &Scene::name, "Folder of the outputs.").fallback("the name of the file");
  keys.string("title", &Scene::title, "Heading of the frames.").fallback("the name");
  keys.add(
          {.name = "comparison",
           .type = "a path, from the folder of this file",
           .meaning =
               "Comparison file (see eisph compare --schema) that is carried out while the scene runs; "
               "3D only."},
          [](const toml::node& node, int, Scene& scene) {
            return read_text(node, scene.comparison) && !scene.comparison.empty();
          },
          [](const Scene& scene, int) {
            return scene.comparison.empty() ? std::string() : write_text(scene.comparison);
          })
      .fallback("none")
      .when("with dimension = 3", [](const Scene&, int dimension) { return dimension == 3; });
  keys.number("end_time", "s", &Scene::end_time, above(0.0), "Time at which the run ends.").required();
  keys.vector("gravity", "m/s^2", &Scene::gravity,
              "Acceleration of gravity; zero only for water that moves at the start. Keep z the vertical.");
  keys.section("particles", kSelf, particle_keys(), "Resolution.");
  keys.section("fluid", kSelf, fluid_keys(), "The water.");
  keys.section("domain", kSelf, domain_keys(), "The tank: a box.");
  keys.list("obstacle", &Scene::obstacles, obstacle_keys(), "A fixed solid of object particles.");
  keys.list("dam", &Scene::obstacles, obstacle_keys(), "A wall of the dam: the same keys as [[obstacle]].",
            "obstacle");
  keys.list("gate", &Scene::gates, gate_keys(),
            "A solid that holds the water back until it vanishes or is lifted.");
  keys.list("gauge", &Scene::gauges, gauge_keys(),
            "Water level: the highest particle in a square column, and the free surface on its axis.");
  keys.list("probe", &Scene::probes, probe_keys(), "Pressure and velocity at a point.");
  keys.list("pressure_sensor", &Scene::pressure_sensors, pressure_sensor_keys(),
            "Pressure on a wall or on the surface of a solid: the mean over a disc or a square.");
  keys.list("front", &Scene::fronts, front_keys(), "How far the water has come in a horizontal direction.");
  keys.list("line", &Scene::lines, line_keys(), "Pressure and velocity along a straight line.");
  keys.list("force", &Scene::forces, force_keys(), "Pressure force on a solid, and its moment.");
  keys.list("discharge", &Scene::discharges, discharge_keys(),
            "Volume that passes a plane, positive along its axis.");
  keys.section("scheme", &Scene::scheme, scheme_keys(), "Time stepping and pressure.");
  keys.section("shallow_water", &Scene::shallow_water, shallow_water_keys(),
               "Cells and bed, with scheme.name = \"shallow_water\".");
  keys.section("boundary", &Scene::boundary, boundary_keys(), "Treatment of walls and solids.");
  keys.section("output", &Scene::output, output_keys(), "What is written when.");
  keys.list("image", &Scene::images, image_keys(),
            "A sequence of frames. A scene without any gets one of the particles and, in 3D, a depth map.");
  return keys;
}

}  // namespace eisph
