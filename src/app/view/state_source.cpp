#include "app/view/state_source.hpp"

namespace eisph {

const std::vector<double>& StateSource::saved_times() const {
  static const std::vector<double> kNone;
  return kNone;
}

}  // namespace eisph
