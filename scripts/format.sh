#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Checks the format of all C++ files, or sets it right with --apply. Needs clang-format.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

case ${1:-} in
  "") options=(--dry-run --Werror) ;;
  --apply) options=(-i) ;;
  --help)
    echo "usage: scripts/format.sh [--apply]

Checks the format of all C++ files (.clang-format), or sets it right with --apply. Needs clang-format.
Exits with 0 when it is right, 1 when not, 2 for a bad argument."
    exit 0
    ;;
  *)
    echo "format.sh: unknown option '$1' (--apply or --help)" >&2
    exit 2
    ;;
esac
command -v clang-format >/dev/null || {
  echo "format.sh: clang-format is missing: apt-get install clang-format" >&2
  exit 2
}

mapfile -t files < <(git ls-files '*.h' '*.cpp')
clang-format "${options[@]}" "${files[@]}"
