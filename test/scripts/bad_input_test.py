#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Bad input ends a program at once: one line on standard error, exit status 2.

Run by rostest, which starts the master that the nodes need. The cases are in the folder bad_input.
"""
# pylint: disable=wildcard-import,unused-wildcard-import
from bad_input.evaluation_tools import *
from bad_input.experiment_files import *
from bad_input.nodes import *
from bad_input.ros_tools import *
from bad_input.run_experiments import *
from bad_input.scripts import *
import rosunit

if __name__ == "__main__":
    rosunit.unitrun("pomdp_crowd_nav", "bad_input", "__main__")
