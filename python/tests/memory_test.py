"""Where there is not enough memory, that is said, with advice where there is any. In processes of their own, whose memory is limited."""

import subprocess
import sys
import unittest

program = """
import resource
import numpy as np
import shellmatch
model = shellmatch.ShapeModel().fit(np.random.default_rng(1).random((3, 10, 2)))
shapes, fine = ("generate:circle", "generate:ellipse/long"), {"levels": (9, 11), "align": "none", "threads": 1}
shellmatch.register(*shapes, **{**fine, "levels": (3, 3)})
pages = int(open("/proc/self/statm").read().split()[0])
resource.setrlimit(resource.RLIMIT_AS, (pages * resource.getpagesize() + 2**24, -1))
try:
    CALL
except shellmatch.OutOfMemoryError as error:
    print(error)
"""


class Memory(unittest.TestCase):
    def said(self, call):
        run = subprocess.run([sys.executable, "-c", program.replace("CALL", call)], capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout

    def test_levels_are_no_advice_for_statistics(self):
        self.assertEqual(self.said("model.sample(2**31 - 1)"), "not enough memory\n")

    def test_levels_are_advice_for_a_matching(self):
        for call in ("shellmatch.register(*shapes, **fine)", "shellmatch.Problem(*shapes, **fine)"):
            self.assertIn("a lower finest level", self.said(call))


if __name__ == "__main__":
    unittest.main()
