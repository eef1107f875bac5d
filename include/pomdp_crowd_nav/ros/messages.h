// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/PoseWithCovariance.h>
#include <geometry_msgs/TwistWithCovariance.h>
#include <geometry_msgs/Vector3.h>
#include <ros/message_operations.h>
#include <ros/serialization.h>
#include <std_msgs/Header.h>

// Generated message types live in the namespace of the package, which is the core's namespace too,
// and three of them are called like the core type that they carry. They get another C++ name on
// their way in; names on the wire stay as they are. Include this header, not the generated ones.
#define CrowdBelief CrowdBeliefMessage
#define PersonBelief PersonBeliefMessage
#define EpisodeMetrics EpisodeMetricsMessage
#include <pomdp_crowd_nav/CrowdBelief.h>
#include <pomdp_crowd_nav/EpisodeMetrics.h>
#include <pomdp_crowd_nav/PersonBelief.h>
#undef EpisodeMetrics
#undef PersonBelief
#undef CrowdBelief

#include <pomdp_crowd_nav/ConfigCmd.h>
#include <pomdp_crowd_nav/GuardStatus.h>
#include <pomdp_crowd_nav/MovoStatus.h>
#include <pomdp_crowd_nav/People.h>
#include <pomdp_crowd_nav/PlannerStatus.h>
#include <pomdp_crowd_nav/ResetSimulation.h>
#include <pomdp_crowd_nav/SetBool.h>
#include <pomdp_crowd_nav/TrackedPersons.h>

#if __has_include(<std_srvs/SetBool.h>)
#include <std_srvs/SetBool.h>
#endif

namespace pomdp_crowd_nav {

// std_srvs/SetBool where it is installed, else our twin of it with the same md5.
#if __has_include(<std_srvs/SetBool.h>)
using PauseService = std_srvs::SetBool;
#else
using PauseService = SetBool;
#endif

}  // namespace pomdp_crowd_nav
