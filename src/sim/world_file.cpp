// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/sim/world_file.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "pomdp_crowd_nav/params/number_text.h"
#include "pomdp_crowd_nav/params/yaml_param_reader.h"

namespace pomdp_crowd_nav {
namespace {

using Numbers = std::vector<double>;

constexpr double kFarthest = 1.0e6;  // [m], beyond it sums of squares and grids come to no good
constexpr double kLargestId = 9007199254740992.0;  // 2^53, whole numbers up to here are exact

// Reads one world file and words its errors.
class WorldReader {
 public:
  explicit WorldReader(const std::string& path)
      : path_(path), reader_(YamlParamReader::fromFile(path)) {}

  World read() {
    World world;
    world.name = std::filesystem::path(path_).stem().string();
    world.bounds.min = point("bounds/min");
    world.bounds.max = point("bounds/max");
    const Numbers start = numbers("start", 3, "[x, y, heading]");
    world.start = {Point(start[0], start[1]), start[2]};
    world.goal = point("goal");
    if (!reader_.read("destinations", world.destinations) || world.destinations.empty()) {
      fail("destinations", "missing, expected a list of [x, y]");
    }
    readCircles(world);
    readPolygons(world);
    readTracks(world);
    reader_.requireAllUsed();
    checkReach(world);
    return world;
  }

  // Throws unless the robot can be at its start and goal.
  void check(const World& world) const {
    try {
      const StaticMap map = world.map();
      checkFree("start", world.start.position, map);
      checkFree("goal", world.goal, map);
    } catch (const std::invalid_argument& error) {
      throw std::runtime_error(fmt::format("{}: {}", path_, error.what()));
    }
  }

 private:
  Numbers numbers(const char* key, size_t count, const char* expected) {
    Numbers values;
    if (!reader_.read(key, values)) fail(key, fmt::format("missing, expected {}", expected));
    if (values.size() != count) failAt(key, expected, values);
    return values;
  }

  Point point(const char* key) {
    const Numbers values = numbers(key, 2, "[x, y]");
    return {values[0], values[1]};
  }

  void readCircles(World& world) {
    std::vector<Numbers> rows;
    reader_.read("circles", rows);
    for (const Numbers& row : rows) {
      if (row.size() != 3) failAt("circles", "a list of [x, y, radius]", row);
      world.obstacles.circles.push_back({Point(row[0], row[1]), row[2]});
    }
  }

  void readPolygons(World& world) {
    for (size_t i = 0;; ++i) {
      Polygon polygon;
      const std::string prefix = fmt::format("polygons/{}/", i);
      const bool has_vertices = reader_.read(prefix + "vertices", polygon.vertices);
      const bool has_closed = reader_.read(prefix + "closed", polygon.closed);
      if (!has_vertices && !has_closed) return;
      world.obstacles.polygons.push_back(polygon);
    }
  }

  void readTracks(World& world) {
    std::string file;
    if (reader_.read("tracks/file", file) && !file.empty()) {
      world.tracks_file = (std::filesystem::path(path_).parent_path() / file).string();
    }
    reader_.read("tracks/start_time", world.tracks_start_time);
    Numbers left_out;
    reader_.read("tracks/left_out", left_out);
    for (double id : left_out) {
      if (id != std::floor(id) || std::abs(id) > kLargestId) {
        failAt("tracks/left_out", "a list of whole numbers", left_out);
      }
      world.left_out.push_back(static_cast<std::int64_t>(id));
    }
  }

  void checkReach(const World& world) const {
    checkReach("bounds/min", world.bounds.min);
    checkReach("bounds/max", world.bounds.max);
    for (const Point& point : world.destinations) checkReach("destinations", point);
    for (const Circle& circle : world.obstacles.circles) {
      checkReach("circles", circle.center);
      checkReach("circles", Point(circle.radius, 0.0));
    }
    for (const Polygon& polygon : world.obstacles.polygons) {
      for (const Point& point : polygon.vertices) checkReach("polygons", point);
    }
  }

  void checkReach(const char* key, const Point& point) const {
    if (point.cwiseAbs().maxCoeff() <= kFarthest) return;
    failAt(key, "nothing farther away than 1e6 m", {point.x(), point.y()});
  }

  void checkFree(const char* key, const Point& point, const StaticMap& map) const {
    const Numbers values = {point.x(), point.y()};
    if (!map.bounds().contains(point)) failAt(key, "a point inside the bounds", values);
    if (map.clearance(point) <= 0.0) failAt(key, "a point outside the obstacles", values);
  }

  [[noreturn]] void failAt(const char* key, const char* expected, const Numbers& values) const {
    fail(key, fmt::format("expected {}, got '{}'", expected, toText(values)));
  }

  [[noreturn]] void fail(const char* key, const std::string& reason) const {
    throw std::runtime_error(fmt::format("{}: {}: {}", path_, key, reason));
  }

  std::string path_;
  YamlParamReader reader_;
};

}  // namespace

World loadWorld(const std::string& path) {
  WorldReader reader(path);
  const World world = reader.read();
  reader.check(world);
  return world;
}

}  // namespace pomdp_crowd_nav
