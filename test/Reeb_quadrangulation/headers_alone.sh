#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# headers_alone.sh COMPILER INCLUDE_DIR...: every public header compiles when it is the only one, and twice. Names those that do not.
set -uo pipefail
compiler="$1"
shift
include="$(cd "$(dirname "$0")/../../include" && pwd)"
flags=(-std=c++17 -fsyntax-only -Wall -Wextra -Werror -x c++)
for directory in "$@"; do
  flags+=(-I"$directory")
done
export compiler
alone() {
  printf '#include <%s>\n#include <%s>\n' "$1" "$1" | "$compiler" "${@:2}" - || { echo "$1 does not compile alone"; return 1; }
}
export -f alone
cd "$include" || exit 1
find . -name '*.h' -printf '%P\n' | sort | xargs -P "$(nproc)" -I{} bash -c 'alone "$@"' _ {} "${flags[@]}" || exit 1
echo "$(find . -name '*.h' | wc -l) headers compile alone"
