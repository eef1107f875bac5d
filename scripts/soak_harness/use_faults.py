# SPDX-License-Identifier: BSD-3-Clause
"""What users and the simulator may do at any time; each is a function of the rig."""
import threading

import rospy
from geometry_msgs.msg import PoseWithCovarianceStamped
from pomdp_crowd_nav.srv import ResetSimulation, SetBool

PREEMPTIONS, PERIOD = 50, 0.1  # [s]


def call(rig, service, service_type, *arguments):
    """A service that does not answer is a finding, not an end."""
    try:
        answer = rospy.ServiceProxy(service, service_type)(*arguments)
        if not answer.success:
            rig.violate(f"{service} refused: {answer.message}")
    except rospy.ServiceException as error:
        rig.violate(f"{service} failed: {error}")


def preempt(rig):
    def send():
        for _ in range(PREEMPTIONS):
            rig.trips.send()
            if rig.is_over.wait(PERIOD):
                return
    threading.Thread(target=send, daemon=True).start()


def cancel(rig):
    rig.trips.cancel()
    rig.trips.sent = float("inf")  # no other goal until the fault ends


def new_goal(rig):
    rig.trips.send()


def pause_planner(rig):
    call(rig, "planner_node/pause", SetBool, True)


def resume_planner(rig):
    call(rig, "planner_node/pause", SetBool, False)


def pause_simulator(rig):
    call(rig, "sim_node/pause", SetBool, True)


def resume_simulator(rig):
    call(rig, "sim_node/pause", SetBool, False)


def reset_simulator(rig):
    rig.truth.move_start(rig.world.start)
    call(rig, "sim_node/reset", ResetSimulation, "", -1, rig.random.randrange(10 ** 6))


def put_elsewhere(rig):
    x, y = rig.world.place()
    message = PoseWithCovarianceStamped()
    message.header.frame_id = "map"
    message.pose.pose.position.x, message.pose.pose.position.y = x, y
    message.pose.pose.orientation.w = 1.0
    rig.truth.move_start((x, y, 0.0))
    rig.places.publish(message)
