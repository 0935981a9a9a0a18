#include "app/gauge_history.hpp"

#include "core/error.hpp"
#include "io/temporary_folder.hpp"

#include <array>
#include <future>

#include <gmock/gmock.h>

namespace eisph {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

/// Counts what arrives.
class CountingSink : public TableSink {
 public:
  std::size_t open_table(const TableHeader&) override { return tables++; }
  void append_row(std::size_t, std::span<const double>) override { ++rows; }
  std::size_t tables = 0;
  std::size_t rows = 0;
};

Scene scene_with_panels() {
  Scene scene;
  ImageSettings image;
  image.kind = ImageKind::Panels;
  image.gauges = {"b", "a"};
  scene.images = {image};
  return scene;
}

TEST(GaugeHistory, KeepsTheGaugesOfTheImagesAndHandsEverythingOn) {
  GaugeHistory history(scene_with_panels());
  CountingSink sink;
  GaugeHistory::Tap tap(&history, sink);
  const std::size_t other = tap.open_table({"gauge_c", {}});
  const std::size_t gauge = tap.open_table({"gauge_a", {}});
  for (const double time : {0.0, 0.1, 0.2}) {
    tap.append_row(gauge, std::array{time, -1.0, 0.5 + time});
    tap.append_row(other, std::array{time, -1.0, 7.0});
    history.advance(time);
  }
  EXPECT_EQ(sink.tables, 2U);
  EXPECT_EQ(sink.rows, 6U);
  const std::vector<GaugeCurve> curves = history.up_to(0.1, {"b", "a"});
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(curves[0].name, "b");
  EXPECT_THAT(curves[0].time, IsEmpty());
  EXPECT_THAT(curves[1].time, ElementsAre(0.0, 0.1));
  EXPECT_THAT(curves[1].surface, ElementsAre(0.5, 0.6));
}

TEST(GaugeHistory, WaitsForTheRecordsAndNotOnceItIsClosed) {
  GaugeHistory history(scene_with_panels());
  auto curves = std::async(std::launch::async, [&] { return history.up_to(0.2, {"a"}); });
  history.advance(0.1);
  EXPECT_EQ(curves.wait_for(std::chrono::milliseconds(50)), std::future_status::timeout);
  history.advance(0.2);
  EXPECT_EQ(curves.get().size(), 1U);
  auto later = std::async(std::launch::async, [&] { return history.up_to(0.3, {"a"}); });
  EXPECT_EQ(later.wait_for(std::chrono::milliseconds(50)), std::future_status::timeout);
  history.close();
  EXPECT_EQ(later.get().size(), 1U);
}

TEST(GaugeHistory, OnlyImagesWithGaugesNeedIt) {
  EXPECT_TRUE(draws_gauges(scene_with_panels()));
  Scene scene;
  scene.images.emplace_back();
  EXPECT_FALSE(draws_gauges(scene));
}

TEST(GaugeHistory, ReadsWhatARunHasLeft) {
  const TemporaryFolder folder;
  put_text(folder / "gauge_a.csv", "time [s],level [m],surface [m]\n0,0.1,0.2\n0.01,0.1,0.25\n");
  const std::vector<GaugeCurve> curves = read_gauge_curves({folder.path()}, {"a"});
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_THAT(curves[0].time, ElementsAre(0.0, 0.01));
  EXPECT_THAT(curves[0].surface, ElementsAre(0.2, 0.25));
  EXPECT_THAT([&] { (void)read_gauge_curves({folder.path()}, {"absent"}); },
              ThrowsMessage<InputError>(HasSubstr("gauge_absent.csv")));
}

}  // namespace
}  // namespace eisph
