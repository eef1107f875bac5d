// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/belief_markers.h"

#include <algorithm>
#include <utility>

#include "pomdp_crowd_nav/ros/marker_shapes.h"
#include "pomdp_crowd_nav/ros/markers.h"

namespace pomdp_crowd_nav {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr double kLeastProbability = 0.1;  // of a destination to which an arrow is drawn

using People = std::vector<const PersonBelief*>;

bool isAttended(const PersonBelief& person, const BeliefScene& scene) {
  const auto& ids = scene.attended;
  return std::find(ids.begin(), ids.end(), person.id) != ids.end();
}

// Those who must not be left out first.
People inOrder(const BeliefScene& scene) {
  using Key = std::pair<bool, double>;
  std::vector<std::pair<Key, const PersonBelief*>> keyed;
  for (const PersonBelief& person : scene.crowd.people) {
    const double distance = (person.position - scene.robot).squaredNorm();
    keyed.push_back({{!isAttended(person, scene), distance}, &person});
  }
  std::sort(keyed.begin(), keyed.end());
  People people;
  for (const auto& [key, person] : keyed) people.push_back(person);
  return people;
}

// How far above that of a destination in a uniform belief the largest probability is, from 0 to 1.
double certainty(const IntentionBelief& intention) {
  const double count = static_cast<double>(intention.probabilities().size());
  if (count < 2.0) return 1.0;
  const double best = intention.probability(intention.mostLikely());
  return std::clamp((best - 1.0 / count) / (1.0 - 1.0 / count), 0.0, 1.0);
}

std_msgs::ColorRGBA hypothesisColor(size_t hypothesis, double alpha) {
  if (hypothesis == IntentionBelief::kStanding) return color(0.0, 0.0, 0.0, alpha);
  if (hypothesis == IntentionBelief::kElsewhere) return color(0.45, 0.45, 0.45, alpha);
  return destinationColor(hypothesis, alpha);
}

std_msgs::ColorRGBA personColor(const PersonBelief& person, double share) {
  const double alpha = 0.25 + 0.75 * certainty(person.intention);
  return paled(hypothesisColor(person.intention.mostLikely(), 1.0), share * alpha);
}

// Calls `draw(way, hypothesis, probability)` for everywhere the person may well be walking to.
template <class Draw>
void forEachWay(const PersonBelief& person, const std::vector<Point>& destinations, Draw draw) {
  const auto consider = [&](size_t hypothesis) {
    const double probability = person.intention.probability(hypothesis);
    if (probability < kLeastProbability) return;
    const Point way = walkerOf(person, hypothesis, destinations).destination - person.position;
    if (way.norm() > 0.0) draw(way, hypothesis, probability);
  };
  for (size_t i = 0; i < destinations.size(); ++i) consider(i);
  consider(IntentionBelief::kElsewhere);
}

void drawTracks(const BeliefScene& scene, const People& people, Marker& lines) {
  for (const PersonBelief* person : people) {
    const auto known = scene.trails.trails().find(person->id);
    if (known == scene.trails.trails().end()) continue;
    const std::deque<Point>& places = known->second.places();
    const double oldest = static_cast<double>(CrowdTrails::kPlaces - places.size());
    for (size_t i = 1; i < places.size(); ++i) {
      const double share = (oldest + static_cast<double>(i)) / CrowdTrails::kPlaces;
      addLine(places[i - 1], places[i], personColor(*person, 0.5 * share), lines);
    }
  }
}

void drawArrows(const BeliefScene& scene, const People& people, Marker& arrows) {
  const double size = scene.symbol_size;
  for (const PersonBelief* person : people) {
    forEachWay(*person, scene.destinations,
               [&](const Point& way, size_t hypothesis, double probability) {
                 const Point tip = person->position + std::min(1.0, 2.6 * size / way.norm()) * way;
                 addArrow({person->position, tip, 0.45 * probability * size},
                          hypothesisColor(hypothesis, 0.9), arrows);
               });
  }
}

// All the way for those alone whose futures are searched: of everybody they would hide the rest.
void drawWays(const BeliefScene& scene, const People& people, Marker& strokes) {
  for (const PersonBelief* person : people) {
    if (!isAttended(*person, scene)) continue;
    forEachWay(
        *person, scene.destinations, [&](const Point& way, size_t hypothesis, double probability) {
          if (hypothesis == IntentionBelief::kElsewhere) return;  // it has no end
          addStroke(
              {person->position, person->position + way, 0.5 * probability * scene.symbol_size},
              hypothesisColor(hypothesis, 0.25), strokes);
        });
  }
}

void drawBlocker(const BeliefScene& scene, const People& people, Marker& lines) {
  if (scene.blocker < 0) return;
  const auto red = color(0.75, 0.0, 0.0);
  for (const PersonBelief* person : people) {
    if (person->id != scene.blocker) continue;
    addLine(scene.robot, person->position, red, lines);
    addCircle(person->position, 1.3 * scene.symbol_size, red, lines);
  }
}

}  // namespace

MarkerArray beliefMarkers(const BeliefScene& scene, const std_msgs::Header& header) {
  MarkerBuilder builder(header);
  const double size = scene.symbol_size;
  const People people = inOrder(scene);
  drawTracks(scene, people, builder.beginList("tracks", Marker::LINE_LIST, 0.3 * size, 0.04));
  drawWays(scene, people, builder.beginList("ways", Marker::TRIANGLE_LIST, 1.0, 0.05));
  drawArrows(scene, people, builder.beginList("belief", Marker::TRIANGLE_LIST, 1.0, 0.06));
  Marker& spheres = builder.beginList("people", Marker::SPHERE_LIST, 0.9 * size, 0.4);
  for (const PersonBelief* person : people) {
    addPoint(person->position, personColor(*person, 1.0), spheres);
  }
  Marker& rings = builder.beginList("attended", Marker::LINE_LIST, 0.2 * size, 0.09);
  for (const PersonBelief* person : people) {
    if (!isAttended(*person, scene)) break;
    addCircle(person->position, 0.9 * size, color(0.85, 0.10, 0.10), rings);
  }
  drawBlocker(scene, people, builder.beginList("blocking", Marker::LINE_LIST, 0.35 * size, 0.11));
  return builder.take();
}

}  // namespace pomdp_crowd_nav
