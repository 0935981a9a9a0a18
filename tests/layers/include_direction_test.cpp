#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eisph {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kAnything = "*";

// The layers that each layer may include. Everything points towards core.
const std::map<std::string, std::set<std::string>>& allowed_layers() {
  static const std::map<std::string, std::set<std::string>> table = {
      {"core", {"core"}},
      {"sph", {"core", "sph"}},
      {"boundary", {"core", "sph", "boundary"}},
      {"scheme", {"core", "sph", "boundary", "scheme"}},
      {"probe", {"core", "probe"}},
      {"render", {"core", "render"}},
      {"io", {"core", "io"}},
      {"compare", {"core", "compare"}},
      {"app", {kAnything}},
  };
  return table;
}

std::vector<std::filesystem::path> source_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (entry.is_regular_file() && (extension == ".hpp" || extension == ".cpp"))
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// What is wrong with one quoted include of a file of `layer`; empty if nothing is.
std::string fault_of(const std::string& layer, const std::string& include,
                     const std::filesystem::path& sources) {
  const std::string included_layer = include.substr(0, include.find('/'));
  if (allowed_layers().count(included_layer) == 0 || !std::filesystem::exists(sources / include)) {
    return "is not a file of a layer, named from src";
  }
  const auto found = allowed_layers().find(layer);
  if (found == allowed_layers().end()) return "stands in a folder that is no layer";
  const std::set<std::string>& allowed = found->second;
  if (allowed.count(kAnything) != 0 || allowed.count(included_layer) != 0) return "";
  return layer + " may not include " + included_layer;
}

/// Every quoted include under `sources` that goes against the direction of the layers.
std::vector<std::string> include_faults(const std::filesystem::path& sources) {
  static const std::regex quoted_include(R"re(^\s*#\s*include\s*"([^"]+)")re");
  std::vector<std::string> faults;
  for (const std::filesystem::path& file : source_files(sources)) {
    const std::filesystem::path relative = std::filesystem::relative(file, sources);
    const std::string layer = relative.begin()->string();
    std::ifstream stream(file);
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
      std::smatch match;
      if (!std::regex_search(line, match, quoted_include)) continue;
      const std::string fault = fault_of(layer, match[1].str(), sources);
      if (fault.empty()) continue;
      faults.push_back(relative.string() + ":" + std::to_string(number) + ": " + match[1].str() + ": " +
                       fault);
    }
  }
  return faults;
}

/// A source tree of three layers in a temporary folder.
class FixtureTree : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = std::filesystem::temp_directory_path() /
            (std::string("eisph_layers_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(root_);
    write("core/scene.hpp", "#include <vector>\n");
    write("render/frame.hpp", "#include \"core/scene.hpp\"\n");
    write("app/main/main.cpp", "#include \"core/scene.hpp\"\n#include \"render/frame.hpp\"\n");
  }
  void TearDown() override { std::filesystem::remove_all(root_); }

  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name) << text;
  }

  std::filesystem::path root_;
};

TEST(IncludeDirection, HoldsThroughoutTheSources) {
  EXPECT_THAT(include_faults(std::filesystem::path(EISPH_SOURCE_DIR) / "src"), IsEmpty());
}

TEST_F(FixtureTree, WithoutFaultsIsAccepted) { EXPECT_THAT(include_faults(root_), IsEmpty()); }

TEST_F(FixtureTree, WithAnIncludeAgainstTheDirectionIsRefused) {
  write("core/scene.hpp", "#include <vector>\n\n#include \"render/frame.hpp\"\n");
  EXPECT_THAT(include_faults(root_),
              ElementsAre(HasSubstr("core/scene.hpp:3: render/frame.hpp: core may not")));
}

TEST_F(FixtureTree, WithAnIncludeBetweenNeighbouringLayersIsRefused) {
  write("io/table.cpp", "#include \"render/frame.hpp\"\n");
  EXPECT_THAT(include_faults(root_), ElementsAre(HasSubstr("io may not include render")));
}

TEST_F(FixtureTree, WithAnIncludeNotNamedFromTheSourceFolderIsRefused) {
  write("render/other.cpp", "#include \"frame.hpp\"\n  #  include \"../core/scene.hpp\"\n");
  EXPECT_THAT(include_faults(root_),
              ElementsAre(HasSubstr("other.cpp:1: frame.hpp: is not a file of a layer"),
                          HasSubstr("other.cpp:2: ../core/scene.hpp: is not")));
}

TEST_F(FixtureTree, WithAFolderThatIsNoLayerIsRefused) {
  write("extra/more.cpp", "#include \"core/scene.hpp\"\n");
  EXPECT_THAT(include_faults(root_), ElementsAre(HasSubstr("extra/more.cpp:1")));
}

}  // namespace
}  // namespace eisph
