#!/usr/bin/env bash
# Builds everything and runs the test suite: ./test.sh [options of ctest]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

"$root/.ci/install-deps"
"$root/.ci/build" release
exec ctest --test-dir "$root/build/release" --output-on-failure -j 2 "$@"
