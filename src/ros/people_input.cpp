// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/people_input.h"

#include <ros/console.h>

#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {
namespace {

constexpr int kQueue = 1;  // only the newest message counts
constexpr size_t kTrackedPersons = 0, kPeople = 1;

}  // namespace

PeopleInput::PeopleInput(ros::NodeHandle& node, const PlannerNodeParams& params,
                         const MessageGate& gate, Guarded<Drive>& drive)
    : gate_(gate),
      drive_(drive),
      gap_(longestGap(params.navigation.people_timeout)),
      tracker_(params.destinations, params.navigation.belief),
      choice_(params.navigation.people_timeout),
      topics_{node.resolveName("tracked_persons"), node.resolveName("people")} {
  const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
  subscribers_[kTrackedPersons] = node.subscribe<TrackedPersons>(
      "tracked_persons", kQueue,
      [this](const TrackedPersonsConstPtr& message) { onMessage(kTrackedPersons, *message); },
      ros::VoidConstPtr(), hints);
  subscribers_[kPeople] = node.subscribe<People>(
      "people", kQueue, [this](const PeopleConstPtr& message) { onMessage(kPeople, *message); },
      ros::VoidConstPtr(), hints);
}

template <class Message>
void PeopleInput::onMessage(size_t topic, const Message& message) {
  const HeaderVerdict verdict = gate_.judge(message.header, newest_[topic]);
  const std::string& frame_id = message.header.frame_id;
  if (verdict.fault != MessageFault::kNone) return refuse(topic, frame_id, verdict.fault);
  take({topic, frame_id, toTracks(message, verdict.frame), countPeople(message), verdict});
}

void PeopleInput::take(Sweep sweep) {
  const auto robot = drive_.with([](Drive& drive) {
    const std::optional<RobotReading>& reading = drive.inputs.robot;
    return reading ? std::optional<Point>(reading->pose.position) : std::nullopt;
  });
  const size_t readable = sweep.tracks.tracks.size();
  LeftOut left_out = filterTracks(TrackRange(), robot, sweep.tracks);
  left_out.bad += static_cast<unsigned>(sweep.people - readable);
  // People are there, only nobody knows where.
  if (sweep.people > 0 && sweep.tracks.tracks.empty()) {
    return refuse(sweep.topic, sweep.frame_id,
                  readable == 0 ? MessageFault::kNotFinite : MessageFault::kOutOfRange);
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  if (gate_.isOutdated(sweep.verdict)) return;
  newest_[sweep.topic] = sweep.verdict.newest();
  const double now = steadySeconds();
  const PeopleChoice::Answer answer = choice_.hear(sweep.topic, sweep.tracks.tracks.size(), now);
  if (answer == PeopleChoice::Answer::kIgnore) {
    ROS_WARN_THROTTLE(10.0, "people come on two topics: %s is used, %s ignored",
                      topics_[1 - sweep.topic].c_str(), topics_[sweep.topic].c_str());
    return;
  }
  const bool is_afresh = answer == PeopleChoice::Answer::kUseAfresh;
  if (is_afresh) tracker_.clear();
  tracker_.update(sweep.tracks);
  CrowdBelief crowd = tracker_.belief();
  TrackList tracks = tracksOf(crowd);
  drive_.with([&](Drive& drive) {
    Inputs& inputs = drive.inputs;
    inputs.noteTracks(sweep.verdict.measured_at, gap_, is_afresh);
    inputs.left_out.add(left_out);
    inputs.people_traffic.topic = topics_[sweep.topic];
    inputs.people_traffic.noteArrival(sweep.frame_id, now);
    std::swap(inputs.crowd, crowd);  // what is old goes when the lock is open again
    std::swap(inputs.tracks, tracks);
  });
}

void PeopleInput::refuse(size_t topic, const std::string& frame_id, MessageFault fault) {
  drive_.with([&](Drive& drive) {
    InputTraffic& traffic = drive.inputs.people_traffic;
    if (traffic.topic.empty()) traffic.topic = topics_[topic];
    traffic.frame = frame_id;
    traffic.noteRefusal(fault, steadySeconds());
  });
  ROS_WARN_THROTTLE(1.0, "%s is refused: %s", topics_[topic].c_str(), describe(fault));
}

void PeopleInput::forget() {
  const std::lock_guard<std::mutex> lock(mutex_);
  tracker_.clear();
  CrowdBelief crowd;
  TrackList tracks;
  drive_.with([&](Drive& drive) {
    drive.inputs.tracks_at = -1.0;
    drive.inputs.first_tracks_at = -1.0;
    std::swap(drive.inputs.crowd, crowd);
    std::swap(drive.inputs.tracks, tracks);
  });
}

}  // namespace pomdp_crowd_nav
