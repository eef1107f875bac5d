#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds with a sanitizer and runs the tests, or a command, under it: see usage below.
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck source=scripts/install_dependencies.sh
. "$source_dir/scripts/install_dependencies.sh"

usage() {
  cat <<'END'
usage: scripts/sanitize.sh address|thread [--core | --rostests | COMMAND...]

Builds with AddressSanitizer and UndefinedBehaviorSanitizer, or with ThreadSanitizer, and runs under it

  nothing more   every test of ctest but those of launch files, documents, the panel in Qt and nodelets,
                 whose manager is not instrumented
  --core         the tests that need no ROS, in a build of their own
  --rostests     the tests of the nodes
  COMMAND...     a command, in the environment of the build, such as
                 scripts/sanitize.sh address scripts/soak.py --duration 600

Builds in build_address/ or build_thread/ (with --core: build_address_core/...), or in
$PCN_BUILD_DIR. Exits with the status of what was run, 1 where a sanitizer has reported something, and
2 for a bad argument.
END
}

# The libraries of ROS, OMPL and OpenCV are not instrumented: what happens in them alone is not looked
# at, and they take locks in orders that cannot be known.
set_options() {
  export ASAN_OPTIONS="detect_leaks=1:halt_on_error=1:strict_string_checks=1:$report"
  export UBSAN_OPTIONS="print_stacktrace=1:halt_on_error=1:$report"
  export TSAN_OPTIONS="ignore_noninstrumented_modules=1:detect_deadlocks=0:$report"
  TSAN_OPTIONS+=":suppressions=$source_dir/test/thread_sanitizer.supp"
}

# shellcheck disable=SC2317  # run_step calls it
configure_sanitized() {
  local options=(-DCMAKE_BUILD_TYPE=RelWithDebInfo "-DPCN_SANITIZE=$sanitizer"
    "-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O2 -g1 -DNDEBUG" "-DPCN_CORE_ONLY=$core_only")
  [[ -e $BUILD_DIR/CMakeCache.txt ]] || options+=(-G Ninja)
  ! command -v ccache >/dev/null || options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  cmake -S "$source_dir" -B "$BUILD_DIR" "${options[@]}"
}

# shellcheck disable=SC2317  # run_step calls it
run_tests() {
  cd "$BUILD_DIR"
  local others='roslaunch|readme|_doc|recipe|help|doxygen|headers_are|convert|plot|core_is_free'
  ctest --timeout 1800 --output-on-failure -R "$tests" \
    -E "$others|rostest_test_(panel|nodelets)"
}

# Sanitizers write a file for each process that has something to report.
count_reports() {
  local files
  mapfile -t files < <(find "$BUILD_DIR/reports" -type f | sort)
  ((${#files[@]} > 0)) || return 0
  say "--- reports of the sanitizer:"
  grep -h -m 3 -E '^(SUMMARY|.*(ERROR|WARNING): [A-Za-z]*Sanitizer)|runtime error:' "${files[@]}" |
    sort | uniq -c >&2 || true
  say "--- in full: $BUILD_DIR/reports"
  return 1
}

trap stop_heartbeat EXIT
case ${1:-} in
  --help | -h)
    usage
    exit 0
    ;;
  address | thread) sanitizer=$1 ;;
  "") die 2 "which sanitizer: address or thread (--help)" ;;
  *) die 2 "there is no sanitizer '$1': address or thread" ;;
esac
shift
core_only=OFF
tests=.
if [[ ${1:-} == --core || ${1:-} == --rostests ]]; then
  [[ $1 != --core ]] || core_only=ON
  [[ $1 != --rostests ]] || tests=_rostest_
  (($# == 1)) || die 2 "$1 takes no command, got '$2'"
  shift
elif [[ ${1:-} == -* ]]; then
  die 2 "unknown option '$1' (--help)"
fi

suffix=$sanitizer
[[ $core_only == OFF ]] || suffix+=_core
PCN_BUILD_DIR=${PCN_BUILD_DIR:-$source_dir/build_$suffix}
prepare_build_dir "$source_dir"
export PCN_BUILD_DIR=$BUILD_DIR
run_step "[1/3] configuring with $sanitizer…" "$BUILD_DIR/logs/configure.log" configure_sanitized ||
  die 1 "configuring failed"
targets=(all)
if [[ $tests == _rostest_ ]]; then
  targets+=(rostests)
elif [[ $core_only == OFF && $# -eq 0 ]]; then
  targets+=(tests)
fi
build "[2/3]" "$source_dir" "$BUILD_DIR" "${targets[@]}" || die 1 "the build failed"
rm -rf "$BUILD_DIR/reports"
mkdir -p "$BUILD_DIR/reports"
report="log_path=$BUILD_DIR/reports/report"
set_options
status=0
if (($# > 0)); then
  say "[3/3] running $1…"
  set +u # setup.bash reads variables that may not be set
  # shellcheck source=/dev/null
  [[ ! -e $BUILD_DIR/devel/setup.bash ]] || . "$BUILD_DIR/devel/setup.bash"
  set -u
  "$@" || status=$?
else
  isolate_ros "$BUILD_DIR/ros_home"
  run_step "[3/3] running the tests…" "$BUILD_DIR/logs/test.log" run_tests || status=$?
  grep -E 'tests passed|tests failed' "$BUILD_DIR/logs/test.log" || true
fi
count_reports || status=$((status == 0 ? 1 : status))
exit "$status"
