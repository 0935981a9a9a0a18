#pragma once

namespace eisph {

/// Bounds the threads of the software renderer (to one, unless the environment has LP_NUM_THREADS), so that
/// drawing takes about one core. It writes to the environment, so a program with several threads calls it
/// before it starts them; making a renderer does it too.
void limit_software_renderer_threads();

}  // namespace eisph
