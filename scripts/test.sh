#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs what is missing, builds and runs all tests. Works on a bare Debian 12, as root or with
# sudo. Builds in build/ or $PCN_BUILD_DIR. Closes with "N passed, N failed".
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck source=scripts/install_dependencies.sh
. "$source_dir/scripts/install_dependencies.sh"

usage() {
  cat <<'END'
usage: scripts/test.sh

Installs what is missing, builds, runs all tests and closes with "N passed, N failed", and the number
of those that were skipped. Exits with 0 when none failed. Why a test failed or was skipped goes to
standard error.

  PCN_BUILD_DIR   folder to build in, instead of build/
  UCY_DATA_DIR    folder of the recordings ucy_zara01.csv, ucy_students03.csv and their .json, which
                  are not part of the package (doc/recorded_people.md); tests with recorded people
                  are skipped without them
END
}

# Whatever stops the script before the tests were counted is one failure.
is_counted=false
# shellcheck disable=SC2317  # the trap calls it
finish() {
  local status=$?
  stop_heartbeat
  $is_counted && exit "$status"
  printf '0 passed, 1 failed\n'
  exit "$((status == 0 ? 1 : status))"
}
trap finish EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

# shellcheck disable=SC2317  # run_step calls it
run_ctest() {
  cd "$BUILD_DIR"
  ctest -j2 --timeout 600 --output-on-failure --output-junit "$BUILD_DIR/test_results/ctest.xml"
}

case ${1:-} in
  "") ;;
  --help | -h)
    is_counted=true # nothing to count
    usage
    exit 0
    ;;
  *) die 2 "takes no arguments, got '$1' (--help)" ;;
esac
prepare_build_dir "$source_dir"
logs=$BUILD_DIR/logs
# RViz: the check of the launch files looks for every program they start.
install_missing "[1/4]" "$logs/install.log" \
  "${BUILD_PACKAGES[@]}" "${RUN_PACKAGES[@]}" "${RVIZ_PACKAGES[@]}" "${DOC_PACKAGES[@]}"
build "[2/4]" "$source_dir" "$BUILD_DIR" all || die 1 "the build failed"
build "[3/4] tests:" "$source_dir" "$BUILD_DIR" tests || die 1 "the tests could not be built"

rm -rf "$BUILD_DIR/test_results"
mkdir -p "$BUILD_DIR/test_results"
isolate_ros "$BUILD_DIR/ros_home"
LOG_LINES=60 run_step "[4/4] running the tests…" "$logs/test.log" run_ctest || true
summary=$(python3 "$source_dir/test/count_test_results.py" "$BUILD_DIR/test_results") || status=$?
is_counted=true
printf '%s\n' "$summary"
exit "${status:-0}"
