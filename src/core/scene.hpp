#pragma once

#include "core/instruments.hpp"
#include "core/kernel.hpp"
#include "core/schedule.hpp"
#include "core/shape.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace eisph {

// The content of a scene file, checked and with defaults filled in. SI units. Two-dimensional scenes lie in
// the plane y = 0 and use x and z; the vertical is z in both dimensions.

/// Faces of the domain, in the order of Scene::faces. y faces are unused in two dimensions.
enum FaceIndex : int { kXMin = 0, kXMax, kYMin, kYMax, kZMin, kZMax, kFaceCount };

enum class FaceKind {
  Wall,      ///< impermeable; slip_factor 1 is free slip, 0 no slip
  Symmetry,  ///< mirror plane: free slip, without virtual particles
  Open,      ///< nothing; fluid that leaves is taken out, except through z_max, which is the open sky
};

struct Face {
  FaceKind kind = FaceKind::Wall;
  double slip_factor = 1.0;

  bool operator==(const Face&) const = default;
};

/// Water: what lies inside one of the added shapes and in none of the cut ones.
struct FluidRegion {
  Shape shape;
  bool cut = false;                ///< takes particles out instead of adding them
  Vec3d velocity = Vec3d::Zero();  ///< initial velocity, m/s
  double angular_velocity = 0.0;   ///< about the y axis through the centre of the bounds, rad/s
  double vortex_speed = 0.0;       ///< of a Taylor-Green vortex with the bounds as its period in x and z, m/s

  /// Initial velocity at `point` (m), m/s.
  [[nodiscard]] Vec3d velocity_at(const Vec3d& point) const;
  /// Not less than the largest initial speed, m/s.
  [[nodiscard]] double fastest() const;

  bool operator==(const FluidRegion&) const = default;
};

/// A fixed solid of object particles: an obstacle or a dam wall.
struct Obstacle {
  std::string name;
  Shape shape;

  bool operator==(const Obstacle&) const = default;
};

enum class GateMotion {
  Instant,  ///< vanishes at start_time
  Lift,     ///< rises by `stroke` at `speed` from start_time on, then is gone
};

/// A moving solid of object particles.
struct Gate {
  std::string name;
  Shape shape;
  GateMotion motion = GateMotion::Instant;
  double start_time = 0.0;  ///< s
  double speed = 0.0;       ///< m/s, upwards
  double stroke = 0.0;      ///< m

  /// Height above the closed position at `time`, or nothing once the gate is gone.
  [[nodiscard]] std::optional<double> lift(double time) const;

  bool operator==(const Gate&) const = default;
};

/// Water level at (x, y): the highest particle in a square column of side `size` (thesis section 4.2.1, where
/// spray counted too), and the smoothed free surface on the axis.
struct Gauge {
  std::string name;
  double x = 0.0;
  double y = 0.0;
  double size = 0.0;    ///< m, default 1.5 particle spacings
  double height = 0.0;  ///< m, top of the column above the floor; 0: the domain's height
  bool ignore_spray = true;
  double interval = 0.0;  ///< s

  bool operator==(const Gauge&) const = default;
};

/// Pressure and velocity at a point, by kernel interpolation over the fluid.
struct PointProbe {
  std::string name;
  Vec3d position = Vec3d::Zero();
  double interval = 0.0;  ///< s

  bool operator==(const PointProbe&) const = default;
};

/// How a step integrates in time. Incompressible schemes have the first two, weakly compressible ones all but
/// the second.
enum class Stepping {
  Symplectic,          ///< leap-frog: positions half a step ahead of the velocities
  Thesis,              ///< positions by the mean of old and new velocity
  PredictorCorrector,  ///< two stages, the second at the middle of the step
  RungeKutta,          ///< the classical four stages
};
/// Form of the density diffusion.
enum class DensityDiffusion {
  Plain,         ///< of the density (Molteni & Colagrossi 2009)
  Renormalised,  ///< of what its gradient does not explain (Antuono et al. 2010)
};
enum class InitialPressure { Solve, Hydrostatic, Zero };
enum class TimeStepMode { Adaptive, Fixed };

struct SchemeSettings {
  std::string name = "eisph";
  Stepping stepping = Stepping::Symplectic;
  TimeStepMode time_step_mode = TimeStepMode::Adaptive;
  double phi = 0.17;                        ///< dt Umax / dx of the adaptive step
  double reference_speed_weight = 1.0;      ///< of the reference speed in the adaptive step
  double time_step = 0.0;                   ///< s, fixed step
  double source_factor = 3.0;               ///< omega (method: symplectic 3, thesis 1)
  bool viscous_source = false;              ///< viscosity takes part in the source of the pressure equation
  std::optional<double> volume_correction;  ///< kappa; default min(1, 3 phi), thesis 0.1; 0: off
  int pressure_sweeps = 1;
  double free_surface_threshold = 0.93;  ///< of the normalised number density
  InitialPressure initial_pressure = InitialPressure::Solve;
  bool clamp_pressure = true;    ///< no negative pressure
  double shifting = 0.0;         ///< coefficient A of the particle shifting
  double pair_separation = 0.5;  ///< part of what pairs lack of kSeparationReach that a step makes good
  double list_reach = 0.5;       ///< way of the fastest particle for which neighbour lists are kept, over dx

  // Of wcsph and delta_sph.
  double sound_speed = 0.0;  ///< c0, m/s
  double courant = 0.0;      ///< dt (c0 + Umax) / h of the adaptive step
  double diffusion = 0.1;    ///< delta, coefficient of the density diffusion
  DensityDiffusion diffusion_form = DensityDiffusion::Renormalised;

  // Of isph.
  double pressure_tolerance = 1e-3;  ///< of the residual, relative to that of no pressure
  int pressure_iterations = 500;     ///< most of them in a step

  /// Whether a velocity without pressure is projected as a whole: then all that acts but the pressure belongs
  /// into the source of the pressure equation, and with the weight of one.
  [[nodiscard]] bool projects_velocity() const { return name == "isph" || stepping == Stepping::Thesis; }
  /// Whether the pressure follows from the density; then the Courant number sets the time step, not phi.
  [[nodiscard]] bool weakly_compressible() const { return name == "wcsph" || name == "delta_sph"; }

  bool operator==(const SchemeSettings&) const = default;
};

/// Slope limiter of the shallow-water scheme.
enum class SlopeLimiter {
  Minmod,
  MonotonisedCentral,
};

/// The scheme "shallow_water".
struct ShallowWaterSettings {
  double cell_size = 0.0;   ///< m; zero: the particle spacing
  double courant = 0.9;     ///< dt times the sum over the axes of (|u| + sqrt(g h)), over the cell size
  double manning = 0.007;   ///< s m^(-1/3), of the floor and of the tops of solids
  double dry_depth = 1e-6;  ///< m; shallower water does not move of its own
  SlopeLimiter limiter = SlopeLimiter::MonotonisedCentral;

  bool operator==(const ShallowWaterSettings&) const = default;
};

/// How the virtual particles of a wall repel.
enum class RepulsionForm {
  Even,     ///< by the distance to the wall, along its normal
  Lattice,  ///< one by one, as in the thesis
};

struct BoundarySettings {
  bool ghost_particles = true;
  bool virtual_particles = true;
  RepulsionForm repulsion_form = RepulsionForm::Even;
  double repulsion_cutoff = 0.4;    ///< r0 / dx
  double repulsion_strength = 1.0;  ///< c^2 / Umax^2
  double repulsion_cap = 5.0;       ///< largest acceleration, in units of Umax^2 / dx
  bool object_repulsion = true;     ///< surfaces of objects repel by the same law
  bool object_no_slip = false;      ///< objects take part in the viscous sum

  bool operator==(const BoundarySettings&) const = default;
};

enum class Projection { Perspective, Orthographic };

struct Camera {
  Projection projection = Projection::Perspective;
  Vec3d eye = Vec3d::Zero();
  Vec3d target = Vec3d::Zero();
  Vec3d up = Vec3d::UnitZ();
  double field_of_view = 35.0;       ///< vertical, degrees (perspective)
  double orthographic_height = 0.0;  ///< m of the scene over the image height (orthographic)

  bool operator==(const Camera&) const = default;
};

/// Box outside of which a picture shows neither particles nor solids.
struct ClipBox {
  Vec3d min = Vec3d::Zero();  ///< m
  Vec3d max = Vec3d::Zero();  ///< m

  bool operator==(const ClipBox&) const = default;
};

enum class ImageKind { Particles, DepthMap, Panels };
/// What a particle picture makes of the water.
enum class WaterStyle { Spheres, Surface };

/// One sequence of frames.
struct ImageSettings {
  std::string name;
  ImageKind kind = ImageKind::Particles;
  std::string caption;  ///< a text below the picture; empty: none
  int width = 1280;
  int height = 720;
  WaterStyle style = WaterStyle::Spheres;  ///< particles, three dimensions
  /// particles: speed, velocity_x, velocity_y, velocity_z, pressure, depth; kind (spheres only); water: no
  /// field (surface only). Depth maps: depth.
  std::string field = "speed";
  std::string colour_map = "viridis";          ///< a table in assets/colour_maps, or "grey_depth"
  std::optional<std::array<double, 2>> range;  ///< of the colour bar, field units; default: automatic
  std::optional<Camera> camera;                ///< default: the whole domain from the front and above
  double dry_depth = 0.005;                    ///< m, depth map: shallower is background
  bool mirror = false;                         ///< depth map: draw the mirror image across symmetry planes
  bool draw_walls = true;
  bool draw_obstacles = true;
  bool glass = true;   ///< particles, three dimensions: walls are panes of glass, not mere outlines
  bool shadow = true;  ///< particles, three dimensions: water and solids darken the floor about them
  bool draw_fluid = true;
  bool draw_objects = false;            ///< object particles one by one
  bool draw_ghosts = false;             ///< ghost particles
  bool draw_virtual_particles = false;  ///< of the walls
  std::optional<ClipBox> clip;          ///< particles: shows what is inside
  bool dark_background = false;
  std::vector<std::string> panels;  ///< of panels: the images in it, by name
  std::vector<std::string> gauges;  ///< of panels: the gauges whose surface is drawn over time
  Schedule schedule;

  bool operator==(const ImageSettings&) const = default;
};

/// What is written besides frames.
struct OutputSettings {
  Schedule frames;               ///< of the images that have no schedule of their own
  Schedule particles;            ///< .vtp files
  Schedule depth;                ///< .vti depth grids
  Schedule comparison;           ///< times of the photographs of Scene::comparison; not a key
  double ledger_interval = 0.0;  ///< s, of the leading edge and the ledger; 0: at the times of other outputs
  double depth_cell_size = 0.0;  ///< m, default 1.5 dx
  DepthRule depth_rule = DepthRule::HighestParticle;
  bool ignore_spray = true;        ///< by the rule HighestParticle
  bool latest_frame_only = false;  ///< frames: drop what the renderer is too slow for, instead of waiting
  int queue_length = 2;

  bool operator==(const OutputSettings&) const = default;
};

struct Scene {
  std::string name;   ///< folder of the outputs
  std::string title;  ///< on frames
  std::string source_file;
  std::string comparison;  ///< comparison file carried out beside the run; empty: none
  int dimension = 3;
  double end_time = 0.0;          ///< s
  double particle_spacing = 0.0;  ///< m
  double smoothing_ratio = 1.42;  ///< h / dx
  KernelKind kernel = KernelKind::QuinticSpline;

  double density = 1000.0;             ///< kg/m^3
  double kinematic_viscosity = 0.0;    ///< m^2/s
  double artificial_viscosity = 0.01;  ///< alpha_v
  double reference_depth = 0.0;        ///< m, H; default: from the water's highest to its lowest point
  double jitter = 0.0;                 ///< initial random displacement, fraction of dx
  unsigned jitter_seed = 1;
  Vec3d gravity = Vec3d(0.0, 0.0, -9.81);  ///< m/s^2

  Vec3d domain_min = Vec3d::Zero();
  Vec3d domain_max = Vec3d::Zero();
  std::array<Face, kFaceCount> faces;

  std::vector<FluidRegion> fluid;
  std::vector<Obstacle> obstacles;
  std::vector<Gate> gates;
  std::vector<Gauge> gauges;
  std::vector<PointProbe> probes;
  std::vector<PressureSensor> pressure_sensors;
  std::vector<FrontProbe> fronts;
  std::vector<LineProbe> lines;
  std::vector<ForceProbe> forces;
  std::vector<DischargeProbe> discharges;

  SchemeSettings scheme;
  ShallowWaterSettings shallow_water;
  BoundarySettings boundary;
  OutputSettings output;
  std::vector<ImageSettings> images;

  [[nodiscard]] double smoothing_length() const { return smoothing_ratio * particle_spacing; }
  [[nodiscard]] double support_radius() const { return kKernelSupport * smoothing_length(); }
  /// sqrt(2 g H): the speed expected of the wave, m/s.
  [[nodiscard]] double reference_speed() const;
  /// Of the fastest water at t = 0, m/s.
  [[nodiscard]] double initial_speed() const;
  /// The larger of the reference speed and the initial speed, m/s.
  [[nodiscard]] double expected_speed() const;

  bool operator==(const Scene&) const = default;
};

/// Intervals (s) of all probes of a scene.
[[nodiscard]] std::vector<double> probe_intervals(const Scene& scene);

}  // namespace eisph
