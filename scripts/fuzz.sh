#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds the fuzzers of test/fuzz with clang and runs them: see usage below.
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck source=scripts/install_dependencies.sh
. "$source_dir/scripts/install_dependencies.sh"

usage() {
  cat <<'END'
usage: scripts/fuzz.sh [TARGET...] [--seconds N]

Feeds what libFuzzer makes up to the readers of world files and recordings and to the conversions of
messages, under AddressSanitizer and UndefinedBehaviorSanitizer, each for N seconds (600). Needs clang
with its libraries (on Debian: clang, libclang-rt-dev).

  TARGET   world_file, tracks_csv, conversions; all three when none is named

Builds in build_fuzz/ or in $PCN_BUILD_DIR. What has crashed a target is left in its folder
crashes/TARGET, and what has covered new code in corpus/TARGET; seeds are in test/fuzz/corpus.
Exits with 0 when nothing crashed, 1 otherwise, 2 for a bad argument.
END
}

all_targets() {
  local file
  for file in "$source_dir"/test/fuzz/fuzz_*.cpp; do
    file=${file##*/fuzz_}
    printf '%s\n' "${file%.cpp}"
  done
}

check_target() {
  all_targets | grep -qxF -- "$1" ||
    die 2 "there is no target '$1'; choose one of: $(all_targets | paste -sd ' ')"
}

# shellcheck disable=SC2317  # run_step calls it
configure_fuzzers() {
  local options=(-DCMAKE_BUILD_TYPE=RelWithDebInfo -DPCN_SANITIZE=address -DPCN_FUZZ=ON
    "-DCMAKE_C_COMPILER=$(command -v clang)" "-DCMAKE_CXX_COMPILER=$(command -v clang++)")
  [[ -e $BUILD_DIR/CMakeCache.txt ]] || options+=(-G Ninja)
  ! command -v ccache >/dev/null || options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  cmake -S "$source_dir" -B "$BUILD_DIR" "${options[@]}"
}

# The newest line of libFuzzer says how many inputs were run.
fuzz() {
  local target=$1 status=0 program dict=() corpus=$BUILD_DIR/corpus/$1 log=$BUILD_DIR/logs/$1.log
  local crashes=$BUILD_DIR/crashes/$1
  program=$(find "$BUILD_DIR" -type f -name "fuzz_$target" -perm -u+x | head -n 1)
  [[ ! -e $source_dir/test/fuzz/$target.dict ]] || dict=(-dict="$source_dir/test/fuzz/$target.dict")
  mkdir -p "$corpus" "$crashes"
  LOG_LINES=30 run_step "fuzzing $target for $seconds s…" "$log" "$program" "${dict[@]}" \
    -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=8192 -print_final_stats=1 \
    -artifact_prefix="$crashes/" "$corpus" "$source_dir/test/fuzz/corpus/$target" || status=$?
  printf '%s: %s inputs, %s\n' "$target" \
    "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")" \
    "$( ((status == 0)) && echo "no crash" || echo "CRASHED, see $crashes and $log")"
  return "$status"
}

trap stop_heartbeat EXIT
seconds=600
targets=()
while (($# > 0)); do
  case $1 in
    --help | -h)
      usage
      exit 0
      ;;
    --seconds)
      [[ ${2:-} =~ ^[1-9][0-9]{0,6}$ ]] ||
        die 2 "--seconds must be a whole number from 1 to 9999999, got '${2:-}'"
      seconds=$2
      shift
      ;;
    -*) die 2 "unknown option '$1' (--help)" ;;
    *)
      check_target "$1"
      targets+=("$1")
      ;;
  esac
  shift
done
((${#targets[@]} > 0)) || mapfile -t targets < <(all_targets)
command -v clang++ >/dev/null || die 1 "clang++ was not found; on Debian: apt-get install clang"

PCN_BUILD_DIR=${PCN_BUILD_DIR:-$source_dir/build_fuzz}
prepare_build_dir "$source_dir"
run_step "[1/3] configuring…" "$BUILD_DIR/logs/configure.log" configure_fuzzers ||
  die 1 "configuring failed"
build "[2/3]" "$source_dir" "$BUILD_DIR" "${targets[@]/#/fuzz_}" || die 1 "the build failed"
say "[3/3]"
export UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1
failures=0
for target in "${targets[@]}"; do fuzz "$target" || failures=$((failures + 1)); done
exit "$((failures > 0 ? 1 : 0))"
