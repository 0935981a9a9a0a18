#pragma once

// The schemes: a source file in src/scheme that defines make_<name>(), and a line here. The scene key
// scheme.name, its documentation and Simulation::create follow.
// X(name, meaning)
#define EISPH_SCHEMES(X)                                         \
  X(eisph, "explicit incompressible SPH")                        \
  X(wcsph, "weakly compressible SPH")                            \
  X(delta_sph, "weakly compressible SPH with density diffusion") \
  X(isph, "incompressible SPH with an implicit pressure")        \
  X(shallow_water, "the shallow-water equations on square cells")
