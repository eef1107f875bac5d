// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace pomdp_crowd_nav {

// A latched topic whose message is dear: it is made when somebody first subscribes, and from then
// on made anew when what it shows has changed. `make` runs in the thread of the callback queue, and
// so must `renew`.
template <class Message>
class LatchedLayer {
 public:
  // None where there is nothing to show yet.
  using Make = std::function<std::optional<Message>()>;

  LatchedLayer(const ros::NodeHandle& node, const std::string& topic, ros::CallbackQueue& queue,
               Make make)
      : make_(std::move(make)) {
    ros::AdvertiseOptions options;
    options.init<Message>(topic, 1, [this](const ros::SingleSubscriberPublisher&) {
      if (!is_sent_) send();
    });
    options.callback_queue = &queue;
    options.latch = true;
    publisher_ = ros::NodeHandle(node).advertise(options);
  }

  // What it shows has changed. It is made once more even if nobody listens, where somebody did: who
  // comes next gets what was published last. (To advertise anew would ask the master, for which all
  // publishers of the node would wait.)
  void renew() {
    if (is_sent_ || publisher_.getNumSubscribers() > 0) send();
  }

 private:
  void send() {
    const std::optional<Message> message = make_();
    if (!message) return;
    publisher_.publish(*message);
    is_sent_ = true;
  }

  Make make_;
  bool is_sent_ = false;
  ros::Publisher publisher_;
};

}  // namespace pomdp_crowd_nav
