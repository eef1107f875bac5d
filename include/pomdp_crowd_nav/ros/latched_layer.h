// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace pomdp_crowd_nav {

// A latched topic whose message is dear: it is made when somebody subscribes, and made anew when
// what it shows has changed while somebody does. `make` runs in the thread of the callback queue,
// and so must `renew`.
template <class Message>
class LatchedLayer {
 public:
  // None where there is nothing to show yet.
  using Make = std::function<std::optional<Message>()>;

  LatchedLayer(const ros::NodeHandle& node, std::string topic, ros::CallbackQueue& queue, Make make)
      : node_(node), topic_(std::move(topic)), queue_(queue), make_(std::move(make)) {
    advertise();
  }

  // What it shows has changed.
  void renew() {
    const bool was_sent = std::exchange(is_sent_, false);
    if (publisher_.getNumSubscribers() > 0) return send();
    if (was_sent) advertise();  // else who comes next would get the old one
  }

 private:
  void advertise() {
    ros::AdvertiseOptions options;
    options.init<Message>(topic_, 1, [this](const ros::SingleSubscriberPublisher&) {
      if (!is_sent_) send();
    });
    options.callback_queue = &queue_;
    options.latch = true;
    publisher_.shutdown();
    publisher_ = node_.advertise(options);
  }

  void send() {
    const std::optional<Message> message = make_();
    if (!message) return;
    publisher_.publish(*message);
    is_sent_ = true;
  }

  ros::NodeHandle node_;
  std::string topic_;
  ros::CallbackQueue& queue_;
  Make make_;
  bool is_sent_ = false;
  ros::Publisher publisher_;
};

}  // namespace pomdp_crowd_nav
