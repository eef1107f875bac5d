// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <rosgraph_msgs/Clock.h>
#include <std_msgs/Header.h>
#include <topic_tools/shape_shifter.h>

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/ros/input_check.h"
#include "pomdp_crowd_nav/ros/rate_meter.h"
#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {

inline std_msgs::Header headerOf(const rosgraph_msgs::Clock& clock) {
  std_msgs::Header header;
  header.stamp = clock.clock;
  return header;
}

template <class Message>
std_msgs::Header headerOf(const Message& message) {
  return message.header;
}

// Listens to one topic, whatever type its publisher announces.
template <class Message>
class InputProbe {
 public:
  using Judge = std::function<MessageFault(const Message&, HeardInput&)>;

  InputProbe(ros::NodeHandle& node, const std::string& name, double limit, Judge judge)
      : judge_(std::move(judge)) {
    heard_.name = name;
    heard_.topic = node.resolveName(name);
    heard_.expected_type = ros::message_traits::datatype<Message>();
    heard_.limit = limit;
    subscriber_ = node.subscribe(name, 1, &InputProbe::onMessage, this);
  }

  HeardInput heard() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    HeardInput heard = heard_;
    heard.rate = rate_.rate(rate_.last());
    return heard;
  }

 private:
  void onMessage(const topic_tools::ShapeShifter::ConstPtr& raw) {
    const std::lock_guard<std::mutex> lock(mutex_);
    heard_.type = raw->getDataType();
    Message message;
    if (!decode(*raw, message)) {
      ++heard_.of_other_layout;
      return;
    }
    ++heard_.messages;
    rate_.count(steadySeconds());
    heard_.frame = headerOf(message).frame_id;
    heard_.fault = judge_(message, heard_);
  }

  static bool decode(const topic_tools::ShapeShifter& raw, Message& message) {
    if (raw.getMD5Sum() != ros::message_traits::md5sum<Message>()) return false;
    try {
      std::vector<std::uint8_t> bytes(raw.size());
      ros::serialization::OStream out(bytes.data(), raw.size());
      raw.write(out);
      ros::serialization::IStream in(bytes.data(), raw.size());
      ros::serialization::deserialize(in, message);
      return true;
    } catch (const std::exception&) {
      return false;
    }
  }

  mutable std::mutex mutex_;
  Judge judge_;
  HeardInput heard_;
  RateMeter rate_;
  ros::Subscriber subscriber_;
};

}  // namespace pomdp_crowd_nav
