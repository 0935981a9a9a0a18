#include "app/progress.hpp"

#include <algorithm>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eisph {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

ProgressState quarter_done() {
  ProgressState state;
  state.time = 0.5;
  state.end_time = 2.0;
  state.time_step = 1e-3;
  state.step = 500;
  state.particles = 16000;
  state.wall_time = 4.0;
  return state;
}

TEST(ProgressLine, StatesShareTimeStepParticlesRateAndTimeToGo) {
  const std::string line = progress_line(quarter_done(), 200);
  EXPECT_THAT(line, StartsWith(" 25.0 %"));
  EXPECT_THAT(line, HasSubstr("t 0.5000 s"));
  EXPECT_THAT(line, HasSubstr("step 500"));
  EXPECT_THAT(line, HasSubstr("dt 1.00e-03 s"));
  EXPECT_THAT(line, HasSubstr("16000 particles"));
  EXPECT_THAT(line, HasSubstr("2.00 M/s"));
  EXPECT_THAT(line, HasSubstr("ETA 12 s"));
}

TEST(ProgressLine, IsCutToTheWidth) { EXPECT_EQ(progress_line(quarter_done(), 30).size(), 30); }

TEST(DurationText, UsesUnitsThatFit) {
  EXPECT_EQ(duration_text(12.4), "12 s");
  EXPECT_EQ(duration_text(200.0), "3 min 20 s");
  EXPECT_EQ(duration_text(3725.0), "1 h 02 min");
}

TEST(ProgressReporter, OverwritesOneLineOnATerminal) {
  std::ostringstream out;
  ProgressReporter reporter(out, ProgressStyle::Live, 60);
  ProgressState state = quarter_done();
  reporter.update(state);
  state.wall_time += 1.0;
  reporter.finish(state);
  const std::string text = out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), 2);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  EXPECT_EQ(text.back(), '\n');
}

TEST(ProgressReporter, PrintsALineNowAndThenElsewhere) {
  std::ostringstream out;
  ProgressReporter reporter(out, ProgressStyle::Plain, 60);
  ProgressState state = quarter_done();
  for (int tenth = 0; tenth < 100; ++tenth) {
    state.wall_time = 0.1 * tenth;
    reporter.update(state);
  }
  const std::string text = out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), 0);
}

TEST(ProgressReporter, ThatIsQuietPrintsNothing) {
  std::ostringstream out;
  ProgressReporter reporter(out, ProgressStyle::Quiet, 60);
  reporter.update(quarter_done());
  reporter.finish(quarter_done());
  EXPECT_EQ(out.str(), "");
}

}  // namespace
}  // namespace eisph
