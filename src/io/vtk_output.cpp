#include "io/vtk_output.hpp"

#include "core/error.hpp"
#include "io/vtk_support.hpp"

#include <cstdint>
#include <memory>
#include <numeric>
#include <vector>

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedIntArray.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

namespace eisph {

namespace {

static_assert(sizeof(Vec3f) == 3 * sizeof(float),
              "positions and velocities are written as they lie in memory");

/// Points with a vertex cell on each: without cells ParaView shows nothing, and with one cell for all of them
/// its filters can only keep or drop the whole cloud.
vtkNew<vtkPolyData> make_points(const std::vector<Vec3f>& positions) {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->SetData(borrow_array<vtkFloatArray>("position", positions.data(), positions.size(), 3));
  data->SetPoints(points);

  const auto count = static_cast<vtkIdType>(positions.size());
  vtkNew<vtkTypeInt32Array> offsets;
  vtkNew<vtkTypeInt32Array> indices;
  offsets->SetNumberOfValues(count + 1);
  indices->SetNumberOfValues(count);
  std::iota(offsets->Begin(), offsets->End(), 0);
  std::iota(indices->Begin(), indices->End(), 0);
  vtkNew<vtkCellArray> vertices;
  vertices->SetData(offsets, indices);
  data->SetVerts(vertices);
  return data;
}

void write_poly_data(const std::filesystem::path& path, vtkPolyData* data) {
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  write_atomically(writer, path);
}

std::vector<Vec3f> take_positions(const std::filesystem::path& path, vtkPolyData* data) {
  std::vector<Vec3f> positions(static_cast<std::size_t>(data->GetNumberOfPoints()));
  if (!positions.empty()) take_array<float>(path, "position", data->GetPoints()->GetData(), positions);
  return positions;
}

template <typename Value, typename Element>
std::vector<Value> take_point_array(const std::filesystem::path& path, vtkPolyData* data, const char* name) {
  std::vector<Value> values(static_cast<std::size_t>(data->GetNumberOfPoints()));
  take_array<Element>(path, name, data->GetPointData()->GetArray(name), values);
  return values;
}

/// Columns of a depth-averaged model go with the particles that show them, as field data.
void put_columns(vtkFieldData* fields, const ColumnField& columns) {
  put_field(fields, "column_origin_x", columns.origin_x);
  put_field(fields, "column_origin_y", columns.origin_y);
  put_field(fields, "column_cell_size", columns.cell_size);
  put_field(fields, "column_columns", static_cast<std::uint64_t>(columns.columns));
  put_field(fields, "column_rows", static_cast<std::uint64_t>(columns.rows));
  const auto put = [&](const char* name, const std::vector<float>& values) {
    fields->AddArray(borrow_array<vtkFloatArray>(name, values.data(), values.size(), 1));
  };
  put("column_bed", columns.bed);
  put("column_depth", columns.depth);
  put("column_velocity_x", columns.velocity_x);
  put("column_velocity_y", columns.velocity_y);
}

std::shared_ptr<const ColumnField> take_columns(const std::filesystem::path& path, vtkFieldData* fields) {
  if (fields->GetArray("column_depth") == nullptr) return nullptr;
  auto columns = std::make_shared<ColumnField>();
  columns->origin_x = take_double(path, fields, "column_origin_x");
  columns->origin_y = take_double(path, fields, "column_origin_y");
  columns->cell_size = take_double(path, fields, "column_cell_size");
  columns->columns = take_uint64(path, fields, "column_columns");
  columns->rows = take_uint64(path, fields, "column_rows");
  const auto cells = static_cast<std::size_t>(fields->GetArray("column_depth")->GetNumberOfTuples());
  if (columns->rows == 0 || cells % columns->rows != 0 || cells / columns->rows != columns->columns) {
    throw InputError(fmt::format("{}: array 'column_depth' has {} values, not {} x {}", path.string(), cells,
                                 columns->columns, columns->rows));
  }
  const auto take = [&](const char* name, std::vector<float>& values) {
    values.resize(cells);
    take_array<float>(path, name, fields->GetArray(name), values);
  };
  take("column_bed", columns->bed);
  take("column_depth", columns->depth);
  take("column_velocity_x", columns->velocity_x);
  take("column_velocity_y", columns->velocity_y);
  return columns;
}

}  // namespace

void write_particles(const std::filesystem::path& path, const Snapshot& snapshot) {
  const std::size_t count = snapshot.size();
  const vtkNew<vtkPolyData> data = make_points(snapshot.position);
  vtkPointData* arrays = data->GetPointData();
  arrays->AddArray(borrow_array<vtkFloatArray>("velocity", snapshot.velocity.data(), count, 3));
  arrays->AddArray(borrow_array<vtkFloatArray>("pressure", snapshot.pressure.data(), count, 1));
  arrays->AddArray(borrow_array<vtkFloatArray>("number_density", snapshot.number_density.data(), count, 1));
  arrays->AddArray(borrow_array<vtkUnsignedIntArray>("id", snapshot.id.data(), count, 1));
  vtkFieldData* fields = data->GetFieldData();
  put_field(fields, "time", snapshot.time);
  put_field(fields, "step", snapshot.step);
  put_field(fields, "time_step", snapshot.time_step);
  put_field(fields, "dimension", static_cast<std::uint64_t>(snapshot.dimension));
  put_field(fields, "particle_spacing", snapshot.particle_spacing);
  put_field(fields, "smoothing_length", snapshot.smoothing_length);
  put_field(fields, "particle_mass", snapshot.particle_mass);
  put_field(fields, "reference_density", snapshot.reference_density);
  if (snapshot.columns) put_columns(fields, *snapshot.columns);
  write_poly_data(path, data);
}

Snapshot read_particles(const std::filesystem::path& path) {
  const vtkNew<vtkXMLPolyDataReader> reader;
  read_completely(reader, path);
  vtkPolyData* data = reader->GetOutput();
  vtkFieldData* fields = data->GetFieldData();
  Snapshot snapshot;
  snapshot.time = take_double(path, fields, "time");
  snapshot.step = take_uint64(path, fields, "step");
  snapshot.time_step = take_double(path, fields, "time_step");
  const std::uint64_t dimension = take_uint64(path, fields, "dimension");
  if (dimension != 2 && dimension != 3) {
    throw InputError(fmt::format("{}: dimension = {}: must be 2 or 3", path.string(), dimension));
  }
  snapshot.dimension = static_cast<int>(dimension);
  snapshot.particle_spacing = take_double(path, fields, "particle_spacing");
  snapshot.smoothing_length = take_double(path, fields, "smoothing_length");
  snapshot.particle_mass = take_double(path, fields, "particle_mass");
  snapshot.reference_density = take_double(path, fields, "reference_density");
  snapshot.position = take_positions(path, data);
  snapshot.velocity = take_point_array<Vec3f, float>(path, data, "velocity");
  snapshot.pressure = take_point_array<float, float>(path, data, "pressure");
  snapshot.number_density = take_point_array<float, float>(path, data, "number_density");
  snapshot.id = take_point_array<std::uint32_t, std::uint32_t>(path, data, "id");
  snapshot.objects = std::make_shared<const ObjectParticles>();
  snapshot.columns = take_columns(path, fields);
  return snapshot;
}

void write_objects(const std::filesystem::path& path, const ObjectParticles& objects) {
  const vtkNew<vtkPolyData> data = make_points(objects.position);
  data->GetPointData()->AddArray(
      borrow_array<vtkFloatArray>("pressure", objects.pressure.data(), objects.pressure.size(), 1));
  data->GetFieldData()->AddArray(borrow_array<vtkFloatArray>("spacing", &objects.spacing, 1, 1));
  write_poly_data(path, data);
}

ObjectParticles read_objects(const std::filesystem::path& path) {
  const vtkNew<vtkXMLPolyDataReader> reader;
  read_completely(reader, path);
  vtkPolyData* data = reader->GetOutput();
  ObjectParticles objects;
  objects.position = take_positions(path, data);
  objects.pressure = take_point_array<float, float>(path, data, "pressure");
  std::vector<float> spacing(1);
  take_array<float>(path, "spacing", data->GetFieldData()->GetArray("spacing"), spacing);
  objects.spacing = spacing.front();
  return objects;
}

void write_depth(const std::filesystem::path& path, const DepthGrid& grid) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(static_cast<int>(grid.columns) + 1, static_cast<int>(grid.rows) + 1, 1);
  image->SetOrigin(grid.origin_x, grid.origin_y, 0.0);
  image->SetSpacing(grid.cell_size, grid.cell_size, grid.cell_size);
  image->GetCellData()->SetScalars(
      borrow_array<vtkFloatArray>("depth", grid.depth.data(), grid.depth.size(), 1));
  put_field(image->GetFieldData(), "time", grid.time);
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(image);
  write_atomically(writer, path);
}

DepthGrid read_depth(const std::filesystem::path& path) {
  const vtkNew<vtkXMLImageDataReader> reader;
  read_completely(reader, path);
  vtkImageData* image = reader->GetOutput();
  const int columns = image->GetDimensions()[0] - 1;
  const int rows = image->GetDimensions()[1] - 1;
  if (columns < 1 || rows < 1) {
    throw InputError(
        fmt::format("{}: {} x {} cells: must be at least one each way", path.string(), columns, rows));
  }
  DepthGrid grid;
  grid.time = take_double(path, image->GetFieldData(), "time");
  grid.origin_x = image->GetOrigin()[0];
  grid.origin_y = image->GetOrigin()[1];
  grid.cell_size = image->GetSpacing()[0];
  grid.columns = static_cast<std::size_t>(columns);
  grid.rows = static_cast<std::size_t>(rows);
  grid.depth.resize(grid.columns * grid.rows);
  take_array<float>(path, "depth", image->GetCellData()->GetArray("depth"), grid.depth);
  return grid;
}

}  // namespace eisph
