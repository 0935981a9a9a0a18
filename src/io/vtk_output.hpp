#pragma once

#include "core/depth_grid.hpp"
#include "core/snapshot.hpp"

#include <filesystem>

namespace eisph {

// ParaView files in VTK's XML formats, binary with LZ4, values as in memory: what is read back has the same
// bits. Files are replaced as a whole. Writing throws std::runtime_error, reading InputError, both naming the
// path. To be called from one thread at a time: VTK's object factory is shared by all threads.

/// Fluid particles (.vtp): a vertex each, with velocity, pressure, number_density and id; the other members
/// of the snapshot as field data. Objects are left out.
void write_particles(const std::filesystem::path& path, const Snapshot& snapshot);

/// The snapshot that write_particles() wrote, with no object particles.
[[nodiscard]] Snapshot read_particles(const std::filesystem::path& path);

/// Object particles (.vtp): a vertex each, with pressure; their spacing as field data.
void write_objects(const std::filesystem::path& path, const ObjectParticles& objects);

[[nodiscard]] ObjectParticles read_objects(const std::filesystem::path& path);

/// Depth grid (.vti): an image in the plane z = 0 with the depth as cell data and the time as field data.
void write_depth(const std::filesystem::path& path, const DepthGrid& grid);

/// The grid that write_depth() wrote.
[[nodiscard]] DepthGrid read_depth(const std::filesystem::path& path);

}  // namespace eisph
