#include "io/vtk_output.hpp"

#include "core/error.hpp"
#include "io/temporary_folder.hpp"

#include <cstring>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>

namespace eisph {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Snapshot random_snapshot(std::size_t count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> value(-2.0F, 2.0F);
  Snapshot snapshot;
  snapshot.time = 0.1 + 0.2;
  snapshot.step = (std::uint64_t{1} << 60) + 1;
  snapshot.time_step = 1.0 / 3.0;
  snapshot.particle_spacing = 0.01;
  snapshot.smoothing_length = 0.0132;
  snapshot.particle_mass = 0.001;
  snapshot.reference_density = 998.2;
  for (std::size_t k = 0; k < count; ++k) {
    snapshot.id.push_back(static_cast<std::uint32_t>(4294967295U - 3 * k));
    snapshot.position.emplace_back(value(random), value(random), value(random));
    snapshot.velocity.emplace_back(value(random), value(random), value(random));
    snapshot.pressure.push_back(1000.0F * value(random));
    snapshot.number_density.push_back(value(random));
  }
  snapshot.objects = std::make_shared<const ObjectParticles>();
  return snapshot;
}

template <typename Value>
bool same_bits(const std::vector<Value>& a, const std::vector<Value>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(static_cast<const void*>(a.data()), b.data(),
                                                           a.size() * sizeof(Value)) == 0);
}

void expect_same(const Snapshot& read, const Snapshot& written) {
  EXPECT_EQ(read.time, written.time);
  EXPECT_EQ(read.step, written.step);
  EXPECT_EQ(read.time_step, written.time_step);
  EXPECT_EQ(read.dimension, written.dimension);
  EXPECT_EQ(read.particle_spacing, written.particle_spacing);
  EXPECT_EQ(read.smoothing_length, written.smoothing_length);
  EXPECT_EQ(read.particle_mass, written.particle_mass);
  EXPECT_EQ(read.reference_density, written.reference_density);
  EXPECT_TRUE(same_bits(read.id, written.id));
  EXPECT_TRUE(same_bits(read.position, written.position));
  EXPECT_TRUE(same_bits(read.velocity, written.velocity));
  EXPECT_TRUE(same_bits(read.pressure, written.pressure));
  EXPECT_TRUE(same_bits(read.number_density, written.number_density));
  ASSERT_NE(read.objects, nullptr);
  EXPECT_TRUE(read.objects->position.empty());
}

TEST(WriteParticles, ReadsBackTheSameBits) {
  const TemporaryFolder folder;
  Snapshot snapshot = random_snapshot(20000);  // more than one compressed block
  snapshot.pressure[0] = -0.0F;
  snapshot.pressure[1] = std::numeric_limits<float>::denorm_min();
  snapshot.pressure[2] = std::numeric_limits<float>::quiet_NaN();
  snapshot.pressure[3] = std::numeric_limits<float>::infinity();
  write_particles(folder / "a.vtp", snapshot);
  expect_same(read_particles(folder / "a.vtp"), snapshot);
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(WriteParticles, KeepsTheDimension) {
  const TemporaryFolder folder;
  Snapshot snapshot = random_snapshot(3);
  snapshot.dimension = 2;
  write_particles(folder / "a.vtp", snapshot);
  expect_same(read_particles(folder / "a.vtp"), snapshot);
}

TEST(WriteParticles, ReplacesAnOlderFile) {
  const TemporaryFolder folder;
  write_particles(folder / "a.vtp", random_snapshot(300));
  write_particles(folder / "a.vtp", random_snapshot(10));
  EXPECT_EQ(read_particles(folder / "a.vtp").size(), 10U);
}

TEST(WriteParticles, TakesASceneThatHasRunDry) {
  const TemporaryFolder folder;
  write_particles(folder / "a.vtp", random_snapshot(0));
  expect_same(read_particles(folder / "a.vtp"), random_snapshot(0));
}

TEST(WriteParticles, MakesVerticesAndArraysThatVtkReads) {
  const TemporaryFolder folder;
  const Snapshot snapshot = random_snapshot(50);
  write_particles(folder / "a.vtp", snapshot);
  const vtkNew<vtkXMLPolyDataReader> reader;
  ASSERT_TRUE(reader->CanReadFile((folder / "a.vtp").c_str()));
  reader->SetFileName((folder / "a.vtp").c_str());
  reader->Update();
  vtkPolyData* data = reader->GetOutput();
  ASSERT_EQ(data->GetNumberOfPoints(), 50);
  EXPECT_EQ(data->GetNumberOfVerts(), 50);
  EXPECT_EQ(data->GetCellType(49), VTK_VERTEX);
  EXPECT_EQ(data->GetPoint(7)[1], snapshot.position[7].y());
  vtkDataArray* velocity = data->GetPointData()->GetArray("velocity");
  ASSERT_NE(velocity, nullptr);
  EXPECT_EQ(velocity->GetComponent(7, 2), snapshot.velocity[7].z());
  EXPECT_EQ(data->GetPointData()->GetArray("id")->GetComponent(7, 0), snapshot.id[7]);
  EXPECT_EQ(data->GetFieldData()->GetArray("time")->GetComponent(0, 0), snapshot.time);
}

TEST(WriteParticles, NamesThePathAndTheReasonWhenTheFolderIsMissing) {
  const TemporaryFolder folder;
  const auto path = folder / "missing" / "a.vtp";
  testing::internal::CaptureStderr();
  EXPECT_THAT(error_of<std::runtime_error>([&] { write_particles(path, random_snapshot(5)); }),
              AllOf(HasSubstr(path.string()), HasSubstr("No such file or directory")));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(WriteParticles, KeepsTheOldFileAndVtkQuietWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  write_particles(folder / "a.vtp", random_snapshot(5));
  std::filesystem::create_symlink("/dev/full", folder / "a.vtp.tmp");
  testing::internal::CaptureStderr();
  EXPECT_THAT(
      error_of<std::runtime_error>([&] { write_particles(folder / "a.vtp", random_snapshot(20000)); }),
      AllOf(HasSubstr((folder / "a.vtp").string()), HasSubstr("cannot be written")));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(read_particles(folder / "a.vtp").size(), 5U);
}

TEST(ReadParticles, RefusesAFileThatIsCutShortAnywhere) {
  const TemporaryFolder folder;
  const auto path = folder / "a.vtp";
  write_particles(path, random_snapshot(200));
  const std::string whole = text_of(path);
  testing::internal::CaptureStderr();
  for (const double part : {0.0, 0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99}) {
    put_text(path, whole.substr(0, static_cast<std::size_t>(part * static_cast<double>(whole.size()))));
    EXPECT_THAT(error_of<InputError>([&] { (void)read_particles(path); }),
                AllOf(HasSubstr(path.string()), HasSubstr("cut short")))
        << part;
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ReadParticles, RefusesADamagedDescriptionWithoutAWordFromVtk) {
  const TemporaryFolder folder;
  const auto path = folder / "a.vtp";
  write_particles(path, random_snapshot(200));
  const std::string whole = text_of(path);
  const std::size_t name = whole.find("Name=\"velocity\"");
  ASSERT_NE(name, std::string::npos);
  const auto error = [&](std::size_t from, std::size_t count, const std::string& text) {
    put_text(path, std::string(whole).replace(from, count, text));
    return error_of<InputError>([&] { (void)read_particles(path); });
  };
  testing::internal::CaptureStderr();
  EXPECT_THAT(error(name + 6, 3, "speed"), AllOf(HasSubstr(path.string()), HasSubstr("no array 'velocity'")));
  EXPECT_THAT(error(name + 5, 1, "<"), AllOf(HasSubstr(path.string()), HasSubstr("Error parsing XML")));
  const std::size_t count = whole.find("NumberOfComponents=\"3\"", name);
  EXPECT_THAT(error(count + 20, 1, "1"), AllOf(HasSubstr(path.string()), HasSubstr("velocity")));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ReadParticles, RefusesOtherFiles) {
  const TemporaryFolder folder;
  const auto path = folder / "a.vtp";
  const auto error = [&] { return error_of<InputError>([&] { (void)read_particles(path); }); };
  EXPECT_THAT(error(), AllOf(HasSubstr(path.string()), HasSubstr("No such file")));
  write_objects(path, {{Vec3f(1, 2, 3)}, {4.0F}, 0.01F});
  EXPECT_THAT(error(), AllOf(HasSubstr(path.string()), HasSubstr("has no array 'time'")));
  DepthGrid grid;
  grid.columns = grid.rows = 1;
  grid.cell_size = 0.1;
  grid.depth = {0.5F};
  testing::internal::CaptureStderr();
  write_depth(path, grid);
  EXPECT_THAT(error(), HasSubstr(path.string()));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(WriteObjects, ReadsBackTheSameBits) {
  const TemporaryFolder folder;
  const Snapshot cloud = random_snapshot(5000);
  const ObjectParticles objects{cloud.position, cloud.pressure, 0.00833F};
  write_objects(folder / "objects.vtp", objects);
  const ObjectParticles read = read_objects(folder / "objects.vtp");
  EXPECT_TRUE(same_bits(read.position, objects.position));
  EXPECT_TRUE(same_bits(read.pressure, objects.pressure));
  EXPECT_EQ(read.spacing, objects.spacing);
}

TEST(WriteObjects, TakesASceneWithoutObjects) {
  const TemporaryFolder folder;
  write_objects(folder / "objects.vtp", {});
  EXPECT_TRUE(read_objects(folder / "objects.vtp").position.empty());
}

TEST(WriteDepth, MakesAnImageThatVtkReads) {
  const TemporaryFolder folder;
  DepthGrid grid;
  grid.time = 0.75;
  grid.origin_x = -0.5;
  grid.origin_y = 0.25;
  grid.cell_size = 0.015;
  grid.columns = 3;
  grid.rows = 2;
  grid.depth = {0.0F, 0.1F, 0.2F, 0.3F, 0.4F, 0.5F};
  write_depth(folder / "depth.vti", grid);
  const vtkNew<vtkXMLImageDataReader> reader;
  ASSERT_TRUE(reader->CanReadFile((folder / "depth.vti").c_str()));
  reader->SetFileName((folder / "depth.vti").c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  EXPECT_EQ(image->GetNumberOfCells(), 6);
  EXPECT_EQ(image->GetOrigin()[0], -0.5);
  EXPECT_EQ(image->GetOrigin()[1], 0.25);
  EXPECT_EQ(image->GetSpacing()[0], 0.015);
  EXPECT_EQ(image->GetSpacing()[1], 0.015);
  vtkDataArray* depth = image->GetCellData()->GetArray("depth");
  ASSERT_NE(depth, nullptr);
  for (int k = 0; k < 6; ++k) {
    EXPECT_EQ(depth->GetComponent(k, 0), grid.depth[static_cast<std::size_t>(k)]);
  }
  EXPECT_EQ(image->GetFieldData()->GetArray("time")->GetComponent(0, 0), 0.75);
  const DepthGrid read = read_depth(folder / "depth.vti");
  EXPECT_EQ(read.depth, grid.depth);
  EXPECT_EQ(read.columns, 3U);
  EXPECT_EQ(read.rows, 2U);
  EXPECT_EQ(read.origin_x, -0.5);
  EXPECT_EQ(read.origin_y, 0.25);
  EXPECT_EQ(read.cell_size, 0.015);
  EXPECT_EQ(read.time, 0.75);
}

TEST(ReadDepth, RefusesAFileThatIsCutShort) {
  const TemporaryFolder folder;
  DepthGrid grid;
  grid.columns = grid.rows = 1;
  grid.cell_size = 0.1;
  grid.depth = {0.5F};
  const auto path = folder / "depth.vti";
  write_depth(path, grid);
  const std::string text = text_of(path);
  put_text(path, text.substr(0, text.size() / 2));
  EXPECT_THAT(error_of<InputError>([&] { (void)read_depth(path); }), HasSubstr(path.string()));
}

TEST(WriteDepth, NamesThePathThatCannotBeWritten) {
  const TemporaryFolder folder;
  DepthGrid grid;
  grid.columns = grid.rows = 1;
  grid.cell_size = 0.1;
  grid.depth = {0.5F};
  const auto path = folder / "missing" / "depth.vti";
  EXPECT_THAT(error_of<std::runtime_error>([&] { write_depth(path, grid); }), HasSubstr(path.string()));
}

}  // namespace
}  // namespace eisph
