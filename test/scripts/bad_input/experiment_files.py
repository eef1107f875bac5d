# SPDX-License-Identifier: BSD-3-Clause
"""Files of run_experiments: resumed, interrupted, written by several jobs."""
import signal
import subprocess
import time

import roslib.packages

from bad_input.refusal import PACKAGE, SHARE, BadInputTest


class ExperimentFilesTest(BadInputTest):
    def expect(self, args, *words):
        self.expect_refusal("run_experiments", ["--config", f"{SHARE}/config", *args], *words)

    def test_files_that_cannot_be_resumed(self):
        self.expect(["--resume"], "--output")
        self.expect(["--trails", "t.csv"], "--output")
        path = self.write("old.csv", "world,seed\nscenario_1,1\n")
        self.expect(["--output", path], "old.csv", "--resume")
        self.expect(["--output", path, "--resume"], "old.csv.settings.json")

    def options(self, output, *more):
        return ["--config", f"{SHARE}/config", "--pedestrians", "20", "--runs", "6",
                "--max-trials", "3", "--output", output, *more]

    @staticmethod
    def timeless(text):
        """Rows without the times that the search took."""
        return [row.split(",")[:11] + row.split(",")[13:] for row in text.splitlines()]

    def begin(self, options, **how):
        """The program under way, once it has written a row."""
        program = roslib.packages.find_node(PACKAGE, "run_experiments")[0]
        path = self.folder / options[options.index("--output") + 1]

        def count():
            files = [path, path.with_name(path.name + ".ahead")]
            return sum(max(0, file.read_text().count("\n") - 1) for file in files if file.exists())
        before = count()
        run = subprocess.Popen([program, *options], cwd=self.folder, stdin=subprocess.DEVNULL,
                               stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, **how)
        give_up = time.monotonic() + 60.0
        while count() <= before and time.monotonic() < give_up and run.poll() is None:
            time.sleep(0.005)
        return run

    def test_killed_and_resumed_it_writes_the_same(self):
        whole_options = self.options("whole.csv", "--trails", "whole_t.csv")
        options = self.options("killed.csv", "--trails", "killed_t.csv", "--resume")
        for some in (whole_options, options):
            some[some.index("6")] = "16"
        self.run_program("run_experiments", *whole_options)
        whole = (self.folder / "whole.csv").read_text()
        for _ in range(3):
            run = self.begin(options)
            run.kill()
            run.communicate()
            self.assertEqual(run.returncode, -signal.SIGKILL, "it was under way")
            self.assertLess((self.folder / "killed.csv").read_text().count("\n"), 17, "and not done")
        result = self.run_program("run_experiments", *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.timeless((self.folder / "killed.csv").read_text()),
                         self.timeless(whole))
        self.assertEqual((self.folder / "killed_t.csv").read_text(),
                         (self.folder / "whole_t.csv").read_text())
        self.assertEqual(sorted(path.name for path in self.folder.glob("*.ahead")), [])
        self.expect([*options[2:], "--set", "search/scenarios=50"], "search/scenarios",
                    '"100"', '"50"')

    def test_interrupted_it_says_how_to_go_on(self):
        for number, status in ((signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)):
            options = self.options(f"{status}.csv")
            options[options.index("6")] = "500"
            run = self.begin(options)
            run.send_signal(number)
            shown = run.communicate(timeout=30)[1]
            self.assertEqual(run.returncode, status, shown)
            self.assertRegex(shown, r"interrupted after \d+ of 500 episodes; .*--resume")

    def test_signals_that_are_ignored_stay_ignored(self):
        run = self.begin(self.options("results.csv"), preexec_fn=lambda: [
            signal.signal(number, signal.SIG_IGN) for number in (signal.SIGHUP, signal.SIGINT)])
        run.send_signal(signal.SIGHUP)
        run.send_signal(signal.SIGINT)
        shown = run.communicate(timeout=60)[1]
        self.assertEqual(run.returncode, 0, shown)
        self.assertEqual((self.folder / "results.csv").read_text().count("\n"), 7)

    def test_jobs_change_nothing(self):
        files = []
        for jobs in ("1", "4"):
            options = self.options(f"{jobs}.csv", "--trails", f"{jobs}_t.csv", "--jobs", jobs,
                                   "--planners", "1d_astar", "2d_prm", "2d_fmm")
            options[options.index("6")] = "2"
            result = self.run_program("run_experiments", *options)
            self.assertEqual(result.returncode, 0, result.stderr)
            files.append((self.timeless((self.folder / f"{jobs}.csv").read_text()),
                          (self.folder / f"{jobs}_t.csv").read_text()))
        self.assertEqual(files[0], files[1])
        self.assertEqual(len(files[0][0]), 7)
