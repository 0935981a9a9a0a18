#!/usr/bin/env bash
# Builds the program, if need be, and runs a scene: ./run.sh [scene] [options of `eisph run`]
# The scene is a file or the name of one in scenes/; without one the small Aureli tank runs.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

scene=aureli_coarse
if (($# > 0)) && [[ $1 != -* ]]; then
  scene=$1
  shift
fi
for candidate in "$scene" "$root/scenes/$scene" "$root/scenes/$scene.toml"; do
  if [[ -f $candidate ]]; then
    scene=$candidate
    break
  fi
done

"$root/.ci/install-deps"
"$root/.ci/build" release eisph
exec "$root/build/release/eisph" run "$scene" "$@"
