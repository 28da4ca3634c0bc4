# SPDX-License-Identifier: BSD-3-Clause
import json
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import ridgeline
from support import CLOUD, LINES, ROOT, Case


class ErrorsAreOfTheRightKind(Case):
    def test_a_missing_file_is_named(self):
        for call in (lambda f: ridgeline.evaluate(f, CLOUD), lambda f: ridgeline.evaluate(LINES, f),
                     ridgeline.read_cloud, ridgeline.read_lines, ridgeline.reconstruct,
                     lambda f: ridgeline.evaluate(LINES, CLOUD, config=f),
                     lambda f: ridgeline.gate(f, [{"max": 1.0}])):
            with self.assertRaisesRegex(FileNotFoundError, "nowhere.xyz"):
                call("nowhere.xyz")

    def test_a_wrong_file_is_an_input_file_error(self):
        for call in (lambda f: ridgeline.evaluate(LINES, f), ridgeline.read_cloud, ridgeline.read_lines,
                     ridgeline.reconstruct):
            with self.assertRaisesRegex(ridgeline.InputFileError, "LICENSE: "):
                call(ROOT / "LICENSE")
        self.assertTrue(issubclass(ridgeline.InputFileError, OSError))

    def test_a_value_out_of_range_is_named_with_its_rule(self):
        for rule, options in ((r"lidar_sigma_m = -1, must be in \[0, 10\]", {"lidar_sigma_m": -1}),
                              ("min_points = 10.5, must be a whole number", {"min_points": 10.5}),
                              (r"classes: 300; must be in \[0, 255\]", {"classes": [300]}),
                              ("bounds: 3 numbers", {"bounds": (1, 2, 3)}),
                              ("bounds: .* must not be inverted", {"bounds": (1, 1, 0, 0)}),
                              ("sample_consensus = x, must be msac", {"sample_consensus": "x"}),
                              ("^unknown key 'sigma'", {"config": {"judge": {"sigma": 1}}}),
                              ("^gross_m = nan, must be", {"gross_m": float("nan")}),
                              ("max_points = -1, must be neither negative", {"max_points": -1}),
                              ("patch, views: both are given", {"patch": "p.yaml", "views": []})):
            with self.assertRaisesRegex(ValueError, rule):
                ridgeline.evaluate(LINES, CLOUD, **options)

    def test_an_unknown_argument_is_a_type_error(self):
        with self.assertRaisesRegex(TypeError, "'sigma'; parameters of the judge are lidar_sigma_m"):
            ridgeline.evaluate(LINES, CLOUD, sigma=1)
        with self.assertRaisesRegex(TypeError, "gross_m = 'x', must be a number"):
            ridgeline.evaluate(LINES, CLOUD, gross_m="x")

    def test_arrays_of_another_shape_are_value_errors(self):
        segments = ridgeline.read_lines(LINES).segments
        cloud = ridgeline.read_cloud(CLOUD)
        for rule, call in (
            (r"lines: the shape is \(3, 4\); must be \(n, 2, 3\) or \(n, 6\)",
             lambda: ridgeline.evaluate(np.zeros((3, 4)), cloud)),
            (r"cloud: the shape is \(3, 2\); must be \(n, 3\)", lambda: ridgeline.evaluate(LINES, np.zeros((3, 2)))),
            (r"covariance_m2: the shape is \(2, 6\); must be \(89, 6, 6\)",
             lambda: ridgeline.evaluate(ridgeline.Lines(segments, covariance_m2=np.zeros((2, 6))), cloud)),
            ("ids: 1 strings; must be one for each of 89 lines",
             lambda: ridgeline.evaluate(ridgeline.Lines(segments, ids=["a"]), cloud)),
            ("lines: .* degrees", lambda: ridgeline.evaluate(segments / 1e6, cloud)),
            ("lines: lines and cloud are not in the same frame", lambda: ridgeline.evaluate(segments + 1e5, cloud)),
            ("lines: lines and cloud do not match: .*UTM zone 32N.*UTM zone 33N.* with assume_crs",
             lambda: ridgeline.evaluate(ridgeline.read_lines(LINES), ridgeline.Cloud(cloud.points, "EPSG:25833"))),
            ("cloud: no file given", lambda: ridgeline.evaluate(segments, [])),
            ("epipolar_angle_deg: must be an array of numbers",
             lambda: ridgeline.evaluate(ridgeline.Lines(segments, epipolar_angle_deg=["a"] * 89), cloud)),
            ("covariance_m2: that of line 0 is not a covariance",
             lambda: ridgeline.evaluate(ridgeline.Lines(segments, covariance_m2=np.tile(-np.eye(6), (89, 1, 1))), cloud)),
            ("schema = x, must be plain or fkb",
             lambda: ridgeline.evaluate(segments, cloud).to_geopackage(self.folder / "x.gpkg", schema="x")),
            ("gates: entry 2: unknown key", lambda: ridgeline.gate(ridgeline.evaluate(segments, cloud), [{"max": 1}, {"mx": 1}])),
            ("cloud: has no points", lambda: ridgeline.evaluate(segments, np.zeros((0, 3)))),
        ):
            with self.assertRaisesRegex(ValueError, rule):
                call()

    def test_digits_that_float32_has_lost_are_noticed(self):
        lines, cloud = ridgeline.read_lines(LINES), ridgeline.read_cloud(CLOUD)
        with self.assertWarnsRegex(UserWarning, "cloud: float32 holds these numbers in steps of 0.5"):
            ridgeline.evaluate(lines, cloud.xyz.astype(np.float32))
        with self.assertRaisesRegex(ValueError, "cloud: float32"):
            ridgeline.evaluate(lines, cloud.xyz.astype(np.float32), strict=True)
        with self.assertWarnsRegex(UserWarning, "lines: float32"):
            ridgeline.Lines(lines.segments.astype(np.float32))
        ridgeline.Lines((lines.segments - lines.segments[0, 0]).astype(np.float32))  # local ones are fine

    def test_what_deserves_attention_is_a_warning(self):
        segments = np.array(ridgeline.read_lines(LINES).segments)
        segments[0] = np.nan
        with self.assertWarnsRegex(UserWarning, "lines: .*non-finite"):
            result = ridgeline.evaluate(segments, CLOUD)
        self.assertEqual(result.lines["status"][0], "non_finite")
        self.assertTrue(any("non-finite" in text for text in result.warnings))

    def test_what_a_file_holds_beside_lines_is_counted(self):
        point = {"type": "Feature", "properties": {}, "geometry": {"type": "Point", "coordinates": [1, 2, 3]}}
        with open(LINES, encoding="utf-8") as file:
            collection = json.load(file)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "mixed.geojson")
            with open(path, "w", encoding="utf-8") as file:
                json.dump(collection | {"features": collection["features"] + [point]}, file)
            with self.assertWarnsRegex(UserWarning, "mixed.geojson: ignored: 1 point"):
                ridgeline.evaluate(LINES, CLOUD, reference_lines=path)
            with open(path, "w", encoding="utf-8") as file:
                json.dump(collection | {"features": [point, point]}, file)
            with self.assertRaisesRegex(ridgeline.InputFileError, "has no 3D lines but 2 points"):
                ridgeline.evaluate(path, CLOUD)


#: Enough to be judged for hours: thousands of lines, whose interval then rests on millions of resamples.
HOURS_OF_WORK = """
import numpy as np, os, ridgeline, signal, sys, threading, time
signal.signal(signal.SIGINT, signal.default_int_handler)  # which a shell turns off in the background
lines = ridgeline.read_lines(sys.argv[1]).segments
cloud = ridgeline.read_cloud(sys.argv[2])
many = np.concatenate([lines] * 1000)

def judge_for_hours():
    return ridgeline.evaluate(many, cloud, bootstrap_replicates=5_000_000)
"""

#: Ends a test that hangs; far more than any of them takes on a busy machine.
HANGS_S = 600


def run_python(code, *arguments):
    """Runs a program of Python; what ends early because it was stopped ends before HANGS_S."""
    return subprocess.run([sys.executable, "-c", code, LINES, CLOUD, *map(str, arguments)], capture_output=True,
                          text=True, timeout=HANGS_S)


class LongCallsLeavePythonAlone(unittest.TestCase):
    def expect(self, run, printed):
        self.assertEqual((run.returncode, run.stdout.split(), run.stderr), (0, printed, ""))

    def test_ctrl_c_stops_a_judgement(self):
        run = run_python(HOURS_OF_WORK + """
try:
    threading.Timer(1, os.kill, (os.getpid(), signal.SIGINT)).start()
    judge_for_hours()
except KeyboardInterrupt:
    print("interrupted")
print(ridgeline.evaluate(lines, cloud).classes["total"]["n_lines"])  # later calls work
""")
        self.expect(run, ["interrupted", "89"])

    def test_calls_of_other_threads_give_their_results_nonetheless(self):
        run = run_python(HOURS_OF_WORK + """
import concurrent.futures
few = np.concatenate([lines] * 30)
with concurrent.futures.ThreadPoolExecutor(1) as pool:
    future = pool.submit(ridgeline.evaluate, few, cloud)
    try:
        threading.Timer(1, os.kill, (os.getpid(), signal.SIGINT)).start()
        judge_for_hours()
    except KeyboardInterrupt:
        print("interrupted")
    print(future.result().classes["total"]["n_lines"])
""")
        self.expect(run, ["interrupted", str(89 * 30)])

    def test_other_threads_run_meanwhile(self):
        run = run_python(HOURS_OF_WORK + """
results = []
threading.Thread(target=lambda: results.append(judge_for_hours()), daemon=True).start()
for _ in range(2000):
    time.sleep(0.001)  # and takes the GIL again
print(len(results))
""")
        self.expect(run, ["0"])

    def test_the_end_of_python_stops_the_calls_of_threads(self):
        code = """
import atexit

@atexit.register  # before the package registers what stops calls, so that it runs after that
def at_end():
    thread.join()
    print(len(results), ridgeline.evaluate(lines, cloud).classes["total"]["n_lines"])
""" + HOURS_OF_WORK + """
results = []
thread = threading.Thread(target=lambda: results.append(judge_for_hours()), daemon=True)
thread.start()
time.sleep(float(sys.argv[3]))
"""
        for moment_s in (0, 0.1, 1, 3):  # it does not matter what the call does then
            with self.subTest(moment_s=moment_s):
                self.expect(run_python(code, moment_s), ["0", "89"])

    def test_threads_that_work_do_not_break_the_end_of_python(self):
        code = HOURS_OF_WORK + """
folder = sys.argv[4]
result = ridgeline.evaluate(lines, cloud)

def repeat(call):
    while True:
        call()

for call in (judge_for_hours, lambda: ridgeline.evaluate(lines, cloud), lambda: ridgeline.read_cloud(sys.argv[2]),
             lambda: ridgeline.read_lines(sys.argv[1]), lambda: ridgeline.write_lines(f"{folder}/x.obj", lines, overwrite=True),
             lambda: result.write(f"{folder}/out", overwrite=True)):
    threading.Thread(target=repeat, args=(call,), daemon=True).start()
time.sleep(float(sys.argv[3]))
"""
        for moment_s in (0, 0.1, 0.3, 1):
            with self.subTest(moment_s=moment_s), tempfile.TemporaryDirectory() as folder:
                self.expect(run_python(code, moment_s, folder), [])

    def test_a_forked_process_ends_though_its_parent_works(self):
        run = run_python(HOURS_OF_WORK + """
threading.Thread(target=judge_for_hours, daemon=True).start()
time.sleep(1)
child = os.fork()
if child == 0:
    sys.exit(7)
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
""")
        self.expect(run, ["7"])


if __name__ == "__main__":
    unittest.main()
