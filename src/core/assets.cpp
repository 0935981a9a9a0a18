#include "core/assets.hpp"

#include <cstdlib>

namespace eisph {

std::filesystem::path home_folder() {
  const char* home = std::getenv("EISPH_HOME");  // NOLINT(concurrency-mt-unsafe)
  return home != nullptr && *home != '\0' ? std::filesystem::path(home)
                                          : std::filesystem::path(EISPH_SOURCE_DIR);
}

std::filesystem::path shipped_scene(const std::string& name) {
  return home_folder() / "scenes" / (name + ".toml");
}

}  // namespace eisph
