#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Reruns the experiments of the paper: results, bounds, report and figures. Started again with the
# same arguments, it goes on where it ended or was killed.
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
runs=100 trials=200 jobs=() output=
tools=${PCN_TOOLS_DIR:-$source_dir/build/devel/lib/pomdp_crowd_nav}

usage() {
  cat <<'END_OF_USAGE'
usage: scripts/paper_experiments.sh OUTPUT_DIR [--runs N] [--max-trials N] [--jobs N] [--tools DIR]

Reruns the paper's experiments into OUTPUT_DIR and goes on there when it is started again:
  holonomic.csv, car.csv, tuned.csv   results, with settings and trails beside them
  trials_N.csv                        2d_fmm with other limits of the search
  bounds_*.csv                        the fastest trips that were possible
  report.md, *.png, *.pdf             the tables and figures of doc/experiments.md

  --runs N         paired episodes of each combination (100)
  --max-trials N   search trials for each decision (200)
  --jobs N         episodes at once (one on each core)
  --tools DIR      folder of the programs (build/devel/lib/pomdp_crowd_nav, or $PCN_TOOLS_DIR)

  scripts/paper_experiments.sh results --runs 2 --max-trials 20    all of it in small

Exit status 0; 2 and one line for a bad argument; else that of the program that failed or was
interrupted.
END_OF_USAGE
}

die() {
  printf 'paper_experiments.sh: %s\n' "$1" >&2
  exit 2
}

require_number() {
  [[ $2 =~ ^[1-9][0-9]*$ ]] || die "$1: expected a whole number above 0, got '$2'"
}

while (($# > 0)); do
  case $1 in
    --help | -h)
      usage
      exit 0
      ;;
    --runs | --max-trials | --jobs | --tools)
      (($# > 1)) || die "$1 needs a value"
      [[ $1 == --tools ]] || require_number "$1" "$2"
      case $1 in
        --runs) runs=$2 ;;
        --max-trials) trials=$2 ;;
        --jobs) jobs=(--jobs "$2") ;;
        --tools) tools=$2 ;;
      esac
      shift 2
      ;;
    -*) die "unknown option '$1' (--help)" ;;
    *)
      [[ -z $output ]] || die "one OUTPUT_DIR is enough, got '$1' too"
      output=$1
      shift
      ;;
  esac
done
[[ -n $output ]] || die "an OUTPUT_DIR is missing (--help)"
for tool in run_experiments omniscient_bound report_experiments export_decision; do
  [[ -x $tools/$tool ]] || die "--tools: there is no program '$tools/$tool'"
done
mkdir -p "$output" || die "cannot write '$output'"

config=(--config "$source_dir/config")
crowds=(100 200 300 400)
scenarios=(scenario_1 scenario_2 scenario_3)

say() { printf '%s\n' "$*" >&2; }

# experiment NAME OPTION... : into NAME.csv and NAME_trails.csv
experiment() {
  local name=$1
  shift
  say "== $name"
  "$tools/run_experiments" "${config[@]}" "${jobs[@]}" --runs "$runs" --max-trials "$trials" \
    --output "$output/$name.csv" --trails "$output/${name}_trails.csv" --resume "$@"
}

# bounds NAME OPTION... : into bounds_NAME.csv, unless they are there
bounds() {
  local file=$output/bounds_$1.csv
  shift
  [[ -e $file ]] || "$tools/omniscient_bound" "${config[@]}" "${jobs[@]}" --runs "$runs" \
    --output "$file" "$@"
}

plot() {
  local figure=$1 name=$2
  shift 2
  python3 "$source_dir/scripts/plot_experiments.py" "$figure" "$@" \
    --output "$output/$name.png" "$output/$name.pdf"
}

begin=$SECONDS
experiment holonomic --worlds "${scenarios[@]}" --pedestrians "${crowds[@]}" \
  --planners 1d_astar 2d_fmm 2d_prm --profile paper
experiment car --worlds scenario_1 --pedestrians "${crowds[@]}" \
  --planners 1d_astar 2d_nhv --profile paper_car
experiment tuned --worlds scenario_1 --pedestrians 100 400 --planners 2d_fmm --profile tuned
results=("$output/holonomic.csv" "$output/car.csv" "$output/tuned.csv")

say "== travel time against search time"
limits=(10 50 200 1000)
for limit in "${limits[@]}"; do
  "$tools/run_experiments" "${config[@]}" "${jobs[@]}" --worlds scenario_1 --pedestrians 400 \
    --planners 2d_fmm --profile paper --runs "$runs" --max-trials "$limit" \
    --output "$output/trials_$limit.csv" --resume
done

say "== bounds"
bounds holonomic --worlds "${scenarios[@]}" --pedestrians "${crowds[@]}" --profile paper
bounds car --worlds scenario_1 --pedestrians "${crowds[@]}" --profile paper_car

say "== report and figures"
"$tools/report_experiments" "${results[@]}" --paper "$source_dir/config/paper_results.yaml" \
  --bound "$output/bounds_holonomic.csv" "$output/bounds_car.csv" >"$output/report.md.part"
mv "$output/report.md.part" "$output/report.md"
"$tools/export_decision" "${config[@]}" --world scenario_2 --pedestrians 200 --profile paper \
  --output "$output/decision.json"
# A Python of pyenv or conda in front of the system's lacks matplotlib.
export PATH="/usr/bin:$PATH"
plot trails trails_holonomic "$output/holonomic_trails.csv" --pedestrians 400
plot trails trails_car "$output/car_trails.csv" --pedestrians 400
plot reduction reduction_holonomic "$output/holonomic.csv"
plot reduction reduction_car "$output/car.csv"
plot decision decision "$output/decision.json"
curve=()
for limit in "${limits[@]}"; do curve+=("$output/trials_$limit.csv"); done
plot search-time search_time "${curve[@]}"
say "done after $((SECONDS - begin)) s: $output/report.md"
