#pragma once

#include "core/error.hpp"
#include "io/scene_file.hpp"
#include "io/temporary_folder.hpp"

#include <string>
#include <utility>
#include <vector>

namespace eisph {

/// A small scene with one section of every kind.
inline const std::string kSceneText = R"(name = "test"
dimension = 3
end_time = 1.0
[particles]
spacing = 0.1
[fluid]
density = 1000.0
[[fluid.region]]
min = [0.0, 0.0, 0.0]
max = [1.0, 1.0, 0.5]
[domain]
min = [0.0, 0.0, 0.0]
max = [4.0, 1.0, 2.0]
[domain.faces]
z_max = "open"
[[obstacle]]
name = "pillar"
min = [2.0, 0.3, 0.0]
max = [2.3, 0.6, 1.0]
[[dam]]
name = "dam"
min = [1.0, 0.0, 0.0]
max = [1.2, 0.3, 1.0]
[[gate]]
name = "gate"
min = [1.0, 0.3, 0.0]
max = [1.2, 1.0, 1.0]
motion = "lift"
stroke = 0.8
duration = 0.2
[[gauge]]
name = "level"
position = [0.5, 0.5]
[[probe]]
name = "floor"
position = [0.5, 0.5, 0.1]
[output]
times = [0.25, 0.5]
[[image]]
name = "view"
[image.camera]
eye = [2.0, -5.0, 2.0]
target = [2.0, 0.5, 0.5]
)";

inline const std::string kSceneText2d = R"(name = "plane"
dimension = 2
end_time = 1.0
[particles]
spacing = 0.1
[[fluid.region]]
min = [0.0, 0.0]
max = [1.0, 0.5]
[domain]
min = [0.0, 0.0]
max = [4.0, 2.0]
[[image]]
name = "view"
)";

/// Text with `from` replaced by `to`; an empty `from` adds `to` at the end.
inline std::string edited(std::string text, const std::string& from, const std::string& to) {
  if (from.empty()) return text + to;
  const std::size_t position = text.find(from);
  if (position == std::string::npos) throw std::runtime_error("the scene has no text " + from);
  return text.replace(position, from.size(), to);
}

/// Loads a scene from its text by way of a file "case.toml".
class SceneLoader {
 public:
  Scene load(const std::string& text, const std::vector<std::string>& overrides = {}) {
    put_text(file(), text);
    return load_scene(file(), overrides);
  }
  std::string error(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return error_of<InputError>([&] { (void)load(text, overrides); });
  }
  [[nodiscard]] std::filesystem::path file() const { return folder_ / "case.toml"; }

 private:
  TemporaryFolder folder_;
};

}  // namespace eisph
