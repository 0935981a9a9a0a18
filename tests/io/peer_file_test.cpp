#include "io/peer_file.hpp"

#include "core/error.hpp"
#include "io/temporary_folder.hpp"

#include <gmock/gmock.h>

namespace eisph {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string kText = R"(case = "ritter_long"
scheme = "VOF"
setting = "Courant 1"
spacing = 0.01
particles = 6600
steps = 400
cpu_time = 12.5
[[state]]
time = 0.4
file = "a.csv"
[[state]]
time = 0.8
file = "b.csv"
)";

class PeerFile : public testing::Test {
 protected:
  PeerFile() {
    put_text(folder_ / "a.csv", "");
    put_text(folder_ / "b.csv", "");
  }
  PeerRun load(const std::string& text) const {
    put_text(folder_ / "peer.toml", text);
    return load_peer_run(folder_ / "peer.toml");
  }
  /// The message about kText with `was` replaced by `is`.
  std::string complaint(const std::string& was, const std::string& is) const {
    std::string text = kText;
    text.replace(text.find(was), was.size(), is);
    return error_of<InputError>([&] { static_cast<void>(load(text)); });
  }

  TemporaryFolder folder_;
};

TEST_F(PeerFile, IsReadAsItStands) {
  const PeerRun run = load(kText);
  EXPECT_EQ(run.flow, "ritter_long");
  EXPECT_EQ(run.scheme, "VOF");
  EXPECT_EQ(run.setting, "Courant 1");
  EXPECT_EQ(run.spacing, 0.01);
  EXPECT_EQ(run.particles, 6600U);
  EXPECT_EQ(run.steps, 400U);
  EXPECT_EQ(run.cpu_time, 12.5);
  ASSERT_EQ(run.states.size(), 2U);
  EXPECT_EQ(run.states[1].time, 0.8);
  EXPECT_EQ(run.states[1].file, folder_ / "b.csv");
}

TEST_F(PeerFile, NamesFileKeyAndValueOfAMistake) {
  EXPECT_THAT(complaint("cpu_time = 12.5", "cpu_time = 0"),
              AllOf(HasSubstr("peer.toml"), HasSubstr("cpu_time")));
  EXPECT_THAT(complaint("cpu_time = 12.5\n", ""), HasSubstr("missing"));
  EXPECT_THAT(complaint("scheme", "shceme"), AllOf(HasSubstr("shceme"), HasSubstr("scheme")));
  EXPECT_THAT(complaint("time = 0.8", "time = 0.4"), AllOf(HasSubstr("state.1.time"), HasSubstr("0.4")));
  EXPECT_THAT(complaint("b.csv", "c.csv"), AllOf(HasSubstr("state.1.file"), HasSubstr("c.csv")));
  EXPECT_THAT(complaint(kText.substr(kText.find("[[state]]")), ""), HasSubstr("[[state]]"));
}

}  // namespace
}  // namespace eisph
