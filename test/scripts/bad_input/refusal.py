# SPDX-License-Identifier: BSD-3-Clause
"""What a refusal looks like: one line on standard error, exit status 2."""
import os
import subprocess

import rosgraph
import roslib.packages

from surroundings import SOURCE, FolderTest

PACKAGE = "pomdp_crowd_nav"
SHARE = SOURCE
WORLD = f"{SHARE}/config/worlds/scenario_1.yaml"
TRACKS_HEADER = "time_s,ped_id,x_m,y_m\n"


class BadInputTest(FolderTest):
    def run_program(self, name, *args, **environment):
        program = roslib.packages.find_node(PACKAGE, name)[0]
        return subprocess.run([program, *args], cwd=self.folder, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              timeout=60, check=False, env={**os.environ, **environment})

    def expect_refusal(self, name, args, *words):
        result = self.run_program(name, *args)
        self.assertEqual(result.returncode, 2, result.stderr)
        lines = result.stderr.splitlines()
        self.assertEqual(len(lines), 1, result.stderr)
        self.assertTrue(lines[0].startswith(name + ": "), lines[0])
        for word in words:
            self.assertIn(word, lines[0])

    # A node reads the parameters of its own name.
    def expect_node_refusal(self, node, params, *words):
        master = rosgraph.Master(self.id())
        name = f"/{node}_{self._testMethodName}"
        for key, value in params.items():
            master.setParam(f"{name}/{key}", value)
        try:
            self.expect_refusal(node, [f"__name:={name[1:]}"], *words)
        finally:
            master.deleteParam(name)
