#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs what Debian 12 needs to build, test and run this package; asks apt only for what is
# missing. Run alone: scripts/install_dependencies.sh [--rviz] [--doc]. The other scripts source it.

BUILD_PACKAGES=(
  g++ cmake make ninja-build catkin
  ros-message-generation ros-std-msgs ros-geometry-msgs
  libroscpp-dev libactionlib-dev libdiagnostic-updater-dev libmove-base-msgs-dev libnav-msgs-dev
  libdynamic-reconfigure-config-init-mutex-dev python3-dynamic-reconfigure
  libnodeletlib-dev librosbag-storage-dev pluginlib-dev libtf2-msgs-dev libtf2-ros-dev libtopic-tools-dev
  libvisualization-msgs-dev
  libbenchmark-dev libcli11-dev libeigen3-dev libfmt-dev libompl-dev libopencv-dev
  libyaml-cpp-dev nlohmann-json3-dev
  libgtest-dev librostest-dev python3-rostest
  python3-matplotlib python3-opencv python3-pil python3-rosbag python3-visualization-msgs
  python3-yaml)
RUN_PACKAGES=(
  python3-roslaunch python3-rosparam python3-rosservice python3-rostopic rosbash rospack-tools
  libnodeletlib-tools python3-actionlib-msgs python3-geometry-msgs python3-nav-msgs python3-rospy
  python3-tf2-msgs ros-robot-state-publisher)
# Seeing it, the panel in RViz included.
RVIZ_PACKAGES=(rviz librviz-dev qtbase5-dev)
DOC_PACKAGES=(doxygen)

# A python3 of pyenv or conda in front of the system's lacks the ROS modules.
export PATH="/usr/bin:$PATH"

say() { printf '%s\n' "$*" >&2; }

# Prints one line and ends the script with the given status.
die() {
  local status=$1
  shift
  say "${0##*/}: $*"
  exit "$status"
}

# did_you_mean NAME KNOWN... : ", did you mean 'X'?" with the nearest of them, where one is near.
did_you_mean() {
  python3 -c 'import difflib, sys
for meant in difflib.get_close_matches(sys.argv[1], sys.argv[2:], 1):
    print(f", did you mean \x27{meant}\x27?", end="")' "$@" 2>/dev/null || true
}

missing_packages() {
  local package
  for package in "$@"; do
    [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] ||
      printf '%s\n' "$package"
  done
}

as_root() {
  if ((EUID == 0)); then "$@"; else sudo "$@"; fi
}

apt_install() {
  as_root apt-get -q -o Acquire::Retries=3 update &&
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends \
      -o Acquire::Retries=3 -o DPkg::Lock::Timeout=600 install "$@"
}

# install_missing LABEL LOG PACKAGE... : does nothing when all are there.
install_missing() {
  local label=$1 log=$2 missing
  shift 2
  if ! command -v apt-get >/dev/null; then
    say "$label no apt-get here: taking it that all dependencies are installed"
    return
  fi
  mapfile -t missing < <(missing_packages "$@")
  if ((${#missing[@]} == 0)); then
    say "$label all packages are installed"
    return
  fi
  if ((EUID != 0)) && ! command -v sudo >/dev/null; then
    die 1 "neither root nor sudo; as root: apt-get install --no-install-recommends ${missing[*]}"
  fi
  ((EUID == 0)) || sudo -v || die 1 "sudo refused; missing are: ${missing[*]}"
  run_step "$label installing ${#missing[@]} packages and what they need…" "$log" \
    apt_install "${missing[@]}" || die 1 "packages could not be installed"
}

# How far a step is: its seconds and the last line of its log. One line that is written anew on a
# terminal; elsewhere a line after 3 s and every 30 s. Until the script or stop_heartbeat ends it.
heartbeat() {
  local log=$1 start=$SECONDS nap='' period=3 wipe='' text
  [[ ! -t 2 ]] || wipe=$'\r\e[K'
  trap '[[ -z $nap ]] || kill "$nap" 2>/dev/null; printf %s "$wipe" >&2; exit 0' TERM
  while kill -0 $$ 2>/dev/null; do
    [[ -z $wipe ]] || period=1
    sleep "$period" >/dev/null 2>&1 &
    nap=$!
    wait "$nap"
    text=$(tail -n 1 "$log" | cut -c 1-65)
    printf '%s      %d s%s' "$wipe" "$((SECONDS - start))" "${text:+: $text}" >&2
    [[ -n $wipe ]] || printf '\n' >&2
    period=30
  done
}

heartbeat_pid=
stop_heartbeat() {
  [[ -n $heartbeat_pid ]] || return 0
  kill "$heartbeat_pid" 2>/dev/null || true
  wait "$heartbeat_pid" 2>/dev/null || true
  heartbeat_pid=
}

# run_step LABEL LOG COMMAND... : output goes to the log, whose end is shown when it fails.
run_step() {
  local label=$1 log=$2 status=0
  shift 2
  say "$label"
  mkdir -p "$(dirname "$log")"
  : >"$log"
  heartbeat "$log" &
  heartbeat_pid=$!
  "$@" </dev/null >>"$log" 2>&1 || status=$?
  stop_heartbeat
  if ((status != 0)); then
    say "--- the last lines of $log:"
    tail -n "${LOG_LINES:-40}" "$log" >&2
  fi
  return "$status"
}

# As many compilers at once as cores and memory (1.5 GB each) allow.
build_jobs() {
  local by_memory
  by_memory=$(awk '/^MemAvailable/ {print int($2 / 1500000)}' /proc/meminfo)
  printf '%s\n' "$((by_memory < 1 ? 1 : by_memory < $(nproc) ? by_memory : $(nproc)))"
}

configure() {
  local source_dir=$1 build_dir=$2 options=(-DCMAKE_BUILD_TYPE=Release)
  [[ -e $build_dir/CMakeCache.txt ]] || options+=(-G Ninja)
  ! command -v ccache >/dev/null || options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  cmake -S "$source_dir" -B "$build_dir" "${options[@]}"
}

# Whether the build folder was configured before RViz was there.
is_without_panel() {
  grep -q '^rviz_DIR:.*-NOTFOUND$' "$1/CMakeCache.txt" 2>/dev/null &&
    [[ -z $(missing_packages "${RVIZ_PACKAGES[@]}") ]]
}

# build LABEL SOURCE_DIR BUILD_DIR TARGET... : configures once; later the build tool sees to it.
build() {
  local label=$1 source_dir=$2 build_dir=$3 log=$3/logs/build.log
  shift 3
  if [[ ! -e $build_dir/build.ninja && ! -e $build_dir/Makefile ]] ||
    is_without_panel "$build_dir"; then
    run_step "$label configuring…" "$build_dir/logs/configure.log" \
      configure "$source_dir" "$build_dir" || return
  fi
  run_step "$label building…" "$log" cmake --build "$build_dir" -j "$(build_jobs)" --target "$@"
}

# Keeps ROS inside one folder and on this machine, whatever the caller's environment says.
isolate_ros() {
  export ROS_HOME=$1 ROS_LOG_DIR=$1/log ROS_IP=127.0.0.1 ROSCONSOLE_STDOUT_LINE_BUFFERED=1
  unset ROS_HOSTNAME ROS_NAMESPACE ROS_MASTER_URI ROSCONSOLE_FORMAT ROSCONSOLE_CONFIG_FILE
  mkdir -p "$ROS_LOG_DIR"
  getent hosts localhost >/dev/null ||
    die 1 "the name localhost is unknown here: put '127.0.0.1 localhost' into /etc/hosts"
}

# The build folder, absolute. Tools that want a home folder get that where there is none.
prepare_build_dir() {
  local build_dir=${PCN_BUILD_DIR:-$1/build}
  mkdir -p "$build_dir"
  build_dir=$(cd "$build_dir" && pwd)
  export HOME=${HOME:-$build_dir}
  BUILD_DIR=$build_dir
}

if [[ ${BASH_SOURCE[0]} == "$0" ]]; then
  set -euo pipefail
  trap stop_heartbeat EXIT
  packages=("${BUILD_PACKAGES[@]}" "${RUN_PACKAGES[@]}")
  for option in "$@"; do
    case $option in
      --rviz) packages+=("${RVIZ_PACKAGES[@]}") ;;
      --doc) packages+=("${DOC_PACKAGES[@]}") ;;
      --help)
        printf '%s\n' "usage: scripts/install_dependencies.sh [--rviz] [--doc]" "" \
          "Installs with apt what is missing to build, test and run on Debian 12." \
          "--rviz: RViz too; --doc: doxygen too. Exits with 0 when all is there, 1 when apt failed," \
          "2 for a bad argument."
        exit 0
        ;;
      *) die 2 "unknown option '$option'$(did_you_mean "$option" --rviz --doc --help)" ;;
    esac
  done
  prepare_build_dir "$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
  install_missing "[1/1]" "$BUILD_DIR/logs/install.log" "${packages[@]}"
fi
