// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <array>
#include <mutex>
#include <string>

#include "pomdp_crowd_nav/ros/drive.h"
#include "pomdp_crowd_nav/ros/guarded.h"
#include "pomdp_crowd_nav/ros/message_gate.h"
#include "pomdp_crowd_nav/ros/people_choice.h"

namespace pomdp_crowd_nav {

// The topics `tracked_persons` and `people`: who is where, and what is believed of them.
//
// One of the two is used at a time, the first whose messages can be used, until it has been silent
// for `people_timeout`, or has reported nobody for as long while the other reports somebody; so
// nobody is there twice. Beliefs are worked out here, outside the lock of the shared state, however
// many people there are.
class PeopleInput {
 public:
  PeopleInput(ros::NodeHandle& node, const PlannerNodeParams& params, const MessageGate& gate,
              Guarded<Drive>& drive);

  // Everything measured so far means nothing any more.
  void forget();

  const std::vector<Point>& destinations() const { return tracker_.destinations(); }

 private:
  template <class Message>
  void onMessage(size_t topic, const Message& message);

  struct Sweep {
    size_t topic = 0;
    std::string frame_id;
    TrackList tracks;
    size_t people = 0;  // in the message, usable or not
    HeaderVerdict verdict;
  };
  void take(Sweep sweep);
  void refuse(size_t topic, const std::string& frame_id, MessageFault fault);

  const MessageGate& gate_;
  Guarded<Drive>& drive_;
  double gap_;  // [s], a longer silence breaks the series
  // Locked before the shared state, never while that is locked.
  std::mutex mutex_;
  BeliefTracker tracker_;
  PeopleChoice choice_;
  std::array<NewestStamp, 2> newest_;
  std::array<std::string, 2> topics_;
  std::array<ros::Subscriber, 2> subscribers_;
};

}  // namespace pomdp_crowd_nav
