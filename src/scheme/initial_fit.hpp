#pragma once

#include "scheme/particle_system.hpp"
#include "scheme/simulation.hpp"

namespace eisph {

/// Sorts the particles and finds their neighbours on the way; to be asked before the first step.
template <int Dim>
InitialFit initial_fit(ParticleSystem<Dim>& particles);

}  // namespace eisph
