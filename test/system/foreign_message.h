// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>

#include "pomdp_crowd_nav/ros/messages.h"

namespace pomdp_crowd_nav {

// What a publisher of people_msgs/People or spencer_tracking_msgs/TrackedPersons sends: type name
// and md5 are those of the other package, written down here; the bytes are those of our twin.
template <class Ours>
struct Foreign {
  Ours message;
};

template <class Ours>
struct ForeignName;

template <>
struct ForeignName<People> {
  static constexpr const char* kType = "people_msgs/People";
  static constexpr const char* kMd5 = "18722f4b8db20cc2369740732357847b";
};

template <>
struct ForeignName<TrackedPersons> {
  static constexpr const char* kType = "spencer_tracking_msgs/TrackedPersons";
  static constexpr const char* kMd5 = "21c0b1a57c4933e68f39aa3802861828";
};

}  // namespace pomdp_crowd_nav

namespace ros {
namespace message_traits {

template <class Ours>
struct IsMessage<pomdp_crowd_nav::Foreign<Ours>> : TrueType {};

template <class Ours>
struct MD5Sum<pomdp_crowd_nav::Foreign<Ours>> {
  static const char* value() { return pomdp_crowd_nav::ForeignName<Ours>::kMd5; }
  static const char* value(const pomdp_crowd_nav::Foreign<Ours>&) { return value(); }
};

template <class Ours>
struct DataType<pomdp_crowd_nav::Foreign<Ours>> {
  static const char* value() { return pomdp_crowd_nav::ForeignName<Ours>::kType; }
  static const char* value(const pomdp_crowd_nav::Foreign<Ours>&) { return value(); }
};

template <class Ours>
struct Definition<pomdp_crowd_nav::Foreign<Ours>> {
  static const char* value() { return Definition<Ours>::value(); }
  static const char* value(const pomdp_crowd_nav::Foreign<Ours>&) { return value(); }
};

}  // namespace message_traits

namespace serialization {

template <class Ours>
struct Serializer<pomdp_crowd_nav::Foreign<Ours>> {
  template <class Stream>
  static void write(Stream& stream, const pomdp_crowd_nav::Foreign<Ours>& foreign) {
    stream.next(foreign.message);
  }
  static std::uint32_t serializedLength(const pomdp_crowd_nav::Foreign<Ours>& foreign) {
    return serializationLength(foreign.message);
  }
};

}  // namespace serialization
}  // namespace ros
