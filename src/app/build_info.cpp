#include "app/build_info.hpp"

#include <eisph_commit.hpp>

namespace eisph {

std::string software_name() { return std::string("eisph ") + EISPH_VERSION; }

BuildInfo build_info() {
  BuildInfo info = compiled_build_info();
  info.version = EISPH_VERSION;
  info.type = EISPH_BUILD_TYPE;
  info.flags = EISPH_COMPILE_FLAGS;
  info.commit = kSourceCommit;
  return info;
}

}  // namespace eisph
