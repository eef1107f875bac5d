#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs what is missing, builds and drives one simulated trip: see usage below.
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck source=scripts/install_dependencies.sh
. "$source_dir/scripts/install_dependencies.sh"

usage() {
  cat <<'END'
usage: scripts/demo.sh [options]

Drives one simulated trip through a crowd and sums it up in the last line of standard output.

  --world NAME       set-up, a file of config/worlds without its ending, or the path of
                     another yaml file (scenario_1)
  --pedestrians N    people, where they are generated (100)
  --planner NAME     what drives (the profile's)
  --seed N           of the crowd and of the sampled futures (1)
  --profile NAME     vehicle and tuning, a file of config/profiles without its ending (paper for
                     worlds named scenario_..., street for all others)
  --tracks FILE      CSV of recorded people: time_s,ped_id,x_m,y_m; needs --world
  --rviz, --no-rviz  show it in RViz or not (shown when there is a display)
  --build-only       install and build, do not drive
  --help             this text

Builds in build/ or in $PCN_BUILD_DIR.

Exit status:
  0  the goal was reached and nobody came within 1 m of the moving robot
  1  somebody did, which is unsafe by the paper's rule, or the goal was not reached, or installing,
     building or starting failed; the last line of standard error says which
  2  a bad option, or something in the world, the tracks or the profile that a node refuses
  130, 143  interrupted, terminated

Examples:
  scripts/demo.sh                                     the paper's open field, 100 people
  scripts/demo.sh --world scenario_2 --planner 1d_astar --no-rviz
  scripts/demo.sh --world "$HOME/yard.yaml" --pedestrians 20
END
}

options=(--world --pedestrians --planner --seed --profile --tracks --rviz --no-rviz --build-only --help)

# The names of a folder of config/, on one line.
names_in() {
  local files=("$source_dir/config/$1"/*.yaml)
  files=("${files[@]##*/}")
  printf '%s' "${files[*]%.yaml}"
}

check_name() {
  local option=$1 folder=$2 name=$3
  [[ $name =~ ^[A-Za-z0-9_-]+$ && -e $source_dir/config/$folder/$name.yaml ]] ||
    refuse_name "$option" "$name" "$(names_in "$folder")"
}

refuse_name() {
  local option=$1 name=$2 known=$3
  # shellcheck disable=SC2086  # one word each
  die 2 "$option: there is no '$name'; choose one of: $known$(did_you_mean "$name" $known)"
}

# Those of the table of parameters, which a test compares with the code.
check_planner() {
  local known
  known=$(sed -n 's/^  planner: {.*range: \[\(.*\)\],$/\1/p' "$source_dir/config/parameters.yaml")
  known=${known//,/}
  [[ " $known " == *" $1 "* ]] || refuse_name --planner "$1" "$known"
}

check_file() {
  [[ -f $2 && -r $2 ]] || die 2 "$1: the file '$2' cannot be read"
}

# A name, or the path of a file, which simulation.launch takes as world_file.
check_world() {
  local world=${given[world]}
  if ! [[ $world == */* || $world == *.yaml || $world == *.yml ]]; then
    check_name --world worlds "$world"
    return
  fi
  check_file --world "$world"
  given[world_file]=$(realpath "$world")
  unset 'given[world]'
}

check_number() {
  local option=$1 value=$2 largest=$3
  if ! [[ $value =~ ^[0-9]{1,9}$ ]] || ((10#$value > largest)); then
    die 2 "$option must be a whole number between 0 and $largest, got '$value'"
  fi
}

parse_options() {
  while (($# > 0)); do
    case $1 in
      --help | -h)
        usage
        exit 0
        ;;
      --rviz) rviz=true ;;
      --no-rviz) rviz=false ;;
      --build-only) build_only=true ;;
      --world | --pedestrians | --planner | --seed | --tracks | --profile)
        [[ -n ${2:-} ]] || die 2 "$1 needs a value"
        given[${1#--}]=$2
        shift
        ;;
      --*=*)
        set -- "${1%%=*}" "${1#*=}" "${@:2}"
        continue
        ;;
      *) die 2 "unknown option '$1'$(did_you_mean "$1" "${options[@]}") (--help lists them)" ;;
    esac
    shift
  done
}

check_options() {
  local name
  for name in "${!given[@]}"; do
    case $name in
      world) check_world ;;
      profile) check_name --profile profiles "${given[profile]}" ;;
      pedestrians) check_number --pedestrians "${given[pedestrians]}" 10000 ;;
      seed) check_number --seed "${given[seed]}" 999999999 ;;
      planner) check_planner "${given[planner]}" ;;
      tracks)
        check_file --tracks "${given[tracks]}"
        [[ -n ${given[world]:-}${given[world_file]:-} ]] ||
          die 2 "--tracks needs --world, the place where these people walked"
        given[tracks]=$(realpath "${given[tracks]}")
        ;;
    esac
  done
  [[ $rviz != true || -n ${DISPLAY:-} ]] || die 2 "--rviz needs a display; DISPLAY is not set"
  [[ $rviz != auto ]] || rviz=$([[ -n ${DISPLAY:-} ]] && echo true || echo false)
}

# Whatever was started for this trip has its folder in the environment.
processes_of_trip() {
  (
    unset ROS_HOME
    grep -lzFx "ROS_HOME=$run_dir" /proc/[0-9]*/environ 2>/dev/null | cut -d / -f 3 || true
  )
}

stop_processes() {
  local pids signal
  [[ -n $run_dir ]] || return 0
  if [[ -n $roslaunch_pid ]] && kill -TERM "$roslaunch_pid" 2>/dev/null; then
    for ((i = 0; i < 100; ++i)); do
      kill -0 "$roslaunch_pid" 2>/dev/null || break
      sleep 0.2
    done
  fi
  for signal in TERM KILL; do
    mapfile -t pids < <(processes_of_trip)
    ((${#pids[@]} > 0)) || break
    kill "-$signal" "${pids[@]}" 2>/dev/null || true
    sleep 1
  done
}

# shellcheck disable=SC2317  # the trap calls it
finish() {
  local status=$?
  trap '' INT TERM
  stop_heartbeat
  stop_processes
  ((status == 1)) || [[ -z $run_dir ]] || rm -rf "$run_dir" # its log is of use then alone
  exit "$status"
}

start_trip() {
  local port name arguments=("trip:=true" "rviz:=$rviz")
  for name in "${!given[@]}"; do arguments+=("$name:=${given[$name]}"); done
  mkdir -p "$BUILD_DIR/demo"
  run_dir=$(mktemp -d "$BUILD_DIR/demo/XXXXXX")
  log=$run_dir/roslaunch.log
  isolate_ros "$run_dir"
  set +u # setup.bash reads variables that may not be set
  # shellcheck source=/dev/null
  . "$BUILD_DIR/devel/setup.bash"
  set -u
  port=$(python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0))
print(s.getsockname()[1])')
  export ROS_MASTER_URI=http://127.0.0.1:$port
  roslaunch -p "$port" pomdp_crowd_nav simulation.launch "${arguments[@]}" \
    >"$log" 2>&1 </dev/null &
  roslaunch_pid=$!
}

show_progress() {
  local line last=
  while kill -0 "$roslaunch_pid" 2>/dev/null; do
    sleep 1
    line=$(sed -n 's/^send_goal: \(.* to the goal\)$/\1/p' "$log" | tail -n 1)
    [[ $line == "$last" ]] || say "      $line"
    last=$line
  done
  wait "$roslaunch_pid" || true
}

# value_of SUMMARY NAME : that figure of the line that sums the trip up.
value_of() {
  [[ ! " $1 " =~ \ $2=([^ ]*)\  ]] || printf '%s' "${BASH_REMATCH[1]}"
}

# faults_of SUMMARY : why this was no good trip; nothing for a good one.
faults_of() {
  local faults=() unsafe
  [[ $(value_of "$1" goal_reached) == true ]] || faults+=("the goal was not reached")
  unsafe=$(value_of "$1" unsafe_steps)
  case $unsafe in
    0) ;;
    nan | '') faults+=("nothing told how near people came to the robot") ;;
    *)
      faults+=("somebody came within 1 m of the moving robot (nearest: \
$(value_of "$1" min_moving_distance_m) m, decision steps within 1 m: $unsafe)")
      ;;
  esac
  ((${#faults[@]} == 0)) || printf '%s' "${faults[0]}${faults[1]:+, and ${faults[1]}}"
}

report_trip() {
  local reason summary
  # A node that refuses its configuration says why in one line of its own.
  ! reason=$(grep -m 1 -E '^(sim_node|planner_node|velocity_guard): ' "$log") || die 2 "$reason"
  if ! summary=$(grep '^goal_reached=' "$log" | tail -n 1); then
    say "--- the last lines of $log:"
    tail -n 30 "$log" >&2
    die 1 "the trip did not come to its end"
  fi
  reason=$(faults_of "$summary")
  if [[ -n $reason ]]; then
    sed -n '/ to the goal$/d; s/^send_goal: /demo.sh: the trip ended: /p' "$log" >&2
    say "demo.sh: the log is $log"
    say "demo.sh: exit status 1: $reason"
  fi
  printf '%s\n' "$summary"
  [[ -z $reason ]] || exit 1
  rm -rf "$run_dir"
}

declare -A given=()
rviz=auto
build_only=false
run_dir=
roslaunch_pid=
trap finish EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

parse_options "$@"
check_options
prepare_build_dir "$source_dir"
packages=("${BUILD_PACKAGES[@]}" "${RUN_PACKAGES[@]}")
[[ $rviz == false ]] || packages+=("${RVIZ_PACKAGES[@]}")
install_missing "[1/3]" "$BUILD_DIR/logs/install.log" "${packages[@]}"
build "[2/3]" "$source_dir" "$BUILD_DIR" all || die 1 "the build failed"
if $build_only; then
  say "[3/3] built; not driving"
  exit 0
fi
start_trip
say "[3/3] driving…"
show_progress
report_trip
