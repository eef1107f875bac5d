// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/path/hybrid_astar.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

constexpr double kGoalSlack = 1e-6;  // [m], of the goal's tolerance, for rounding on the way
constexpr double kSlip = 1e-3;       // [m], clearance that a start in the margin may lose
constexpr int kMaxTime = 1000;       // elements; later ones are discounted as this one
constexpr long kClockPeriod = 64;    // expansions between two looks at the clock
constexpr size_t kHeapArity = 4;

void require(bool fits, const char* name, const char* expected, double value) {
  if (fits) return;
  throw std::invalid_argument(fmt::format("path/{} must be {}, got {}", name, expected, value));
}

}  // namespace

void validate(const HybridAstar::Params& p) {
  require(p.cell > 0.0, "cell", "positive", p.cell);
  require(p.cost_discount > 0.0 && p.cost_discount <= 1.0, "cost_discount", "in (0, 1]",
          p.cost_discount);
  require(p.way_weight >= 0.0, "way_weight", "at least 0", p.way_weight);
  require(p.heading_weight >= 0.0, "heading_weight", "at least 0", p.heading_weight);
  validate(p.crowd);
}

double HybridAstar::maxTurn(const VehicleParams& vehicle) {
  return kElement * maxCurvature(vehicle, vehicle.max_speed);
}

HybridAstar::HybridAstar(const StaticMap& map, const NavigationField& field, const Params& params)
    : params_(params), map_(map), field_(field), goal_(field.goal()), crowd_(params.crowd) {
  validate(params);
  constexpr double kCellDiagonal = 0.7072;  // from its centre, in edges
  table_error_ = kCellDiagonal / field.raster().cells_per_meter + 1e-3;
  if (map.obstacles().grid) table_error_ += 1.5 * map.obstacles().grid->resolution;
  const Point size = map.bounds().max - map.bounds().min;
  columns_ = static_cast<int>(size.x() / params.cell) + 1;
  rows_ = static_cast<int>(size.y() / params.cell) + 1;
  blocks_.assign(static_cast<size_t>(columns_) * rows_, -1);
  for (int t = 0; t <= kMaxTime; ++t) discounts_.push_back(std::pow(params.cost_discount, t));
  addMoves();
  headings_xy_.resize(headings_);
}

void HybridAstar::addMoves() {
  const bool is_car = params_.vehicle == VehicleKind::kCar;
  const int step = is_car ? 5 : 10;  // [degrees]
  constexpr double kRounding = 1e-9;
  const int most = static_cast<int>(params_.max_turn / kTurnStep + kRounding);
  headings_ = 360 / step;
  const int steps = is_car ? std::min(9, most) : 18;
  // Straight on first, then the smaller turns; -180 degrees is 180 degrees.
  for (int i = 0; i <= 2 * steps; ++i) {
    const int turn = (i % 2 == 1 ? 1 : -1) * ((i + 1) / 2);
    if (turn == -headings_ / 2) continue;
    const double angle = turn * step * M_PI / 180.0;
    const PathLeg leg{is_car ? 0.0 : angle, is_car ? angle : 0.0, kElement};
    const Point end = leg.displacement(kElement);
    const Point middle = leg.displacement(0.5 * kElement);
    moves_.push_back(
        {angle, (turn + headings_) % headings_, end.x(), end.y(), middle.x(), middle.y()});
  }
}

HybridAstar::Result HybridAstar::find(const Pose& start, const std::vector<PersonBelief>& people,
                                      const std::vector<Point>& destinations, const Limit& limit) {
  begin(start, people, destinations);
  const bool is_timed = limit.deadline != Clock::time_point::max();
  Result result;
  for (std::int32_t best = popBest(); best >= 0; best = popBest()) {
    if (isAtGoal(nodes_[best])) {
      result.outcome = Outcome::kFound;
      result.path = pathTo(best, start);
      result.cost = nodes_[best].cost;
      return result;
    }
    const bool looks = is_timed && result.expansions % kClockPeriod == 0;
    if (result.expansions >= limit.max_expansions || (looks && Clock::now() >= limit.deadline)) {
      result.outcome = Outcome::kTimedOut;
      return result;
    }
    ++result.expansions;
    expand(best);
  }
  return result;
}

void HybridAstar::begin(const Pose& start, const std::vector<PersonBelief>& people,
                        const std::vector<Point>& destinations) {
  for (const std::int32_t cell : touched_) blocks_[cell] = -1;
  touched_.clear();
  heap_.clear();
  pushes_ = 0;
  crowd_.predict(start.position, people, destinations, map_.bounds());
  start_heading_ = start.heading;
  for (int k = 0; k < headings_; ++k) {
    const Point direction = unitVector(start_heading_ + 2.0 * M_PI * k / headings_);
    headings_xy_[k] = {direction.x(), direction.y()};
  }
  const Place place{start.position.x(), start.position.y()};
  is_squeezed_ = field_.hasObstacles() && clearanceAt(place) < params_.clearance;
  const std::int32_t root = nodeAt(place, 0);
  open(root, {place.x, place.y, 0.0, -1, 0, 0, 0, Node::State::kOpen}, 0.0);
}

void HybridAstar::expand(std::int32_t index) {
  nodes_[index].state = Node::State::kClosed;
  Family family{nodes_[index], index, index % headings_, 0.0, 0.0};
  const Place place{family.parent.x, family.parent.y};
  if (is_squeezed_) family.clearance = clearanceAt(place);
  family.border = offField(place);
  for (size_t a = 0; a < moves_.size(); ++a) addChild(family, moves_[a], static_cast<int>(a));
}

void HybridAstar::addChild(const Family& family, const Move& move, int action) {
  const Node& parent = family.parent;
  const Place& facing = headings_xy_[family.heading];
  const Place end{parent.x + facing.x * move.x - facing.y * move.y,
                  parent.y + facing.y * move.x + facing.x * move.y};
  const Place middle{parent.x + facing.x * move.middle_x - facing.y * move.middle_y,
                     parent.y + facing.y * move.middle_x + facing.x * move.middle_y};
  if (offField(end) > 0.0 && offField(end) >= family.border) return;
  int heading = family.heading + move.heading_steps;
  if (heading >= headings_) heading -= headings_;
  const std::int32_t index = nodeAt(end, heading);
  const Node::State state = nodes_[index].state;
  if (state == Node::State::kClosed) return;
  const int time = parent.time + 1;
  const double discount = discountAt(time);
  const double known = nodes_[index].cost;
  if (state == Node::State::kOpen && known <= parent.cost + discount) return;
  if (!isAllowed(family, middle, end)) return;
  const double cost = parent.cost + discount * (1.0 + crowd_.at(end.x, end.y, time));
  if (!std::isfinite(cost) || (state == Node::State::kOpen && known <= cost)) return;
  open(index,
       {end.x, end.y, cost, family.index, 0, static_cast<std::int16_t>(std::min(time, kMaxTime)),
        static_cast<std::uint8_t>(action), Node::State::kOpen},
       cost + wayToGo(end, heading));
}

// C_st. The middle of an element is tested as well, so that no element leaps over a wall.
bool HybridAstar::isAllowed(const Family& family, const Place& middle, const Place& end) const {
  if (!field_.hasObstacles() || (isClear(end) && isClear(middle))) return true;
  if (!is_squeezed_ || family.clearance >= params_.clearance) return false;
  const double kept = family.clearance - kSlip;
  return clearanceAt(end) >= kept && clearanceAt(middle) >= kept;
}

bool HybridAstar::isClear(const Place& place) const {
  const double about =
      field_.clearances()[field_.cellOf(static_cast<float>(place.x), static_cast<float>(place.y))];
  if (about > params_.clearance + table_error_) return true;
  if (about < params_.clearance - table_error_) return false;
  return clearanceAt(place) >= params_.clearance;
}

double HybridAstar::clearanceAt(const Place& place) const {
  return map_.clearance({place.x, place.y});
}

// The border is off the field, as in the authors' code: less than any distance, and not 0.
double HybridAstar::offField(const Place& place) const {
  const Bounds& bounds = map_.bounds();
  const double x = std::max(bounds.min.x() - place.x, place.x - bounds.max.x());
  const double y = std::max(bounds.min.y() - place.y, place.y - bounds.max.y());
  const double outside = std::max(x, y);
  return outside < 0.0 ? 0.0 : std::max(outside, std::numeric_limits<double>::min());
}

bool HybridAstar::isAtGoal(const Node& node) const {
  const double tolerance = params_.goal_tolerance - kGoalSlack;
  return (goal_ - Point(node.x, node.y)).norm() < tolerance;
}

double HybridAstar::wayToGo(const Place& place, int heading) const {
  const Place& facing = headings_xy_[heading];
  double x = goal_.x() - place.x;
  double y = goal_.y() - place.y;
  double way = std::sqrt(x * x + y * y);
  double cosine = way > 0.0 ? (facing.x * x + facing.y * y) / way : 1.0;
  if (field_.hasObstacles()) {
    const NavigationCell cell = field_.at(static_cast<float>(place.x), static_cast<float>(place.y));
    way = std::max(way, static_cast<double>(cell.distance_to_goal));
    cosine = facing.x * cell.direction_x + facing.y * cell.direction_y;
  }
  return params_.way_weight * way - params_.heading_weight * cosine;
}

double HybridAstar::discountAt(int time) const { return discounts_[std::min(time, kMaxTime)]; }

std::int32_t HybridAstar::nodeAt(const Place& place, int heading) {
  const Point& origin = map_.bounds().min;
  const int column =
      std::clamp(static_cast<int>((place.x - origin.x()) / params_.cell), 0, columns_ - 1);
  const int row = std::clamp(static_cast<int>((place.y - origin.y()) / params_.cell), 0, rows_ - 1);
  std::int32_t& block = blocks_[static_cast<size_t>(row) * columns_ + column];
  if (block < 0) {
    block = static_cast<std::int32_t>(touched_.size()) * headings_;
    touched_.push_back(row * columns_ + column);
    const size_t end = static_cast<size_t>(block) + headings_;
    if (nodes_.size() < end) nodes_.resize(std::max(end, 2 * nodes_.size()));
    for (size_t i = block; i < end; ++i) nodes_[i].state = Node::State::kNew;
  }
  return block + heading;
}

// Entries that a better one of the same node has replaced stay in the heap and are passed over.
// Of equal values the newest comes first, which is the one farthest along.
void HybridAstar::open(std::int32_t index, const Node& node, double value) {
  nodes_[index] = node;
  nodes_[index].order = ++pushes_;
  const Entry entry{value, index, pushes_};
  size_t hole = heap_.size();
  heap_.push_back(entry);
  while (hole > 0) {
    const size_t parent = (hole - 1) / kHeapArity;
    if (heap_[parent].value < value) break;
    heap_[hole] = heap_[parent];
    hole = parent;
  }
  heap_[hole] = entry;
}

std::int32_t HybridAstar::popBest() {
  const auto precedes = [](const Entry& a, const Entry& b) {
    return a.value < b.value || (a.value == b.value && a.order > b.order);
  };
  while (!heap_.empty()) {
    const Entry best = heap_.front();
    const Entry last = heap_.back();
    heap_.pop_back();
    const size_t size = heap_.size();
    for (size_t hole = 0; size > 0;) {
      const size_t first = hole * kHeapArity + 1;
      size_t child = first;
      for (size_t i = first + 1; i < std::min(first + kHeapArity, size); ++i) {
        if (precedes(heap_[i], heap_[child])) child = i;
      }
      if (first >= size || !precedes(heap_[child], last)) {
        heap_[hole] = last;
        break;
      }
      heap_[hole] = heap_[child];
      hole = child;
    }
    const Node& node = nodes_[best.node];
    if (node.state == Node::State::kOpen && node.order == best.order) return best.node;
  }
  return -1;
}

Path HybridAstar::pathTo(std::int32_t index, const Pose& start) const {
  std::vector<PathLeg> legs;
  for (; nodes_[index].parent >= 0; index = nodes_[index].parent) {
    const Move& move = moves_[nodes_[index].action];
    const bool is_car = params_.vehicle == VehicleKind::kCar;
    const std::int32_t faced = is_car ? nodes_[index].parent : index;
    const double heading = start_heading_ + 2.0 * M_PI * (faced % headings_) / headings_;
    legs.push_back({wrapAngle(heading), is_car ? move.turn : 0.0, kElement});
  }
  std::reverse(legs.begin(), legs.end());
  return Path(start.position, std::move(legs));
}

}  // namespace pomdp_crowd_nav
