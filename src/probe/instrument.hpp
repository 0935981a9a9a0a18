#pragma once

#include "core/scene.hpp"
#include "core/table.hpp"
#include "probe/observation.hpp"

#include <functional>
#include <string>
#include <vector>

namespace eisph {

/// A probe with its own times and its own table.
struct Instrument {
  Schedule schedule;
  std::function<void(Observation&)> record;  ///< appends to the table

  /// Without a schedule every time is due.
  [[nodiscard]] bool is_due(double time) const { return schedule.empty() || schedule.is_due(time); }
};

/// Opens the tables of all probes of a scene in the sink, which must outlive them.
[[nodiscard]] std::vector<Instrument> make_instruments(const Scene& scene, TableSink& sink);

// Parts of tables.

[[nodiscard]] inline TableColumn time_column() { return {"time", "s"}; }
/// A column for each direction of the scene: x, y, z, or x and z in two dimensions.
void add_vector_columns(std::vector<TableColumn>& columns, const std::string& name, const std::string& unit,
                        int dimension);
void add_vector(std::vector<double>& row, const Vec3d& value, int dimension);

}  // namespace eisph
