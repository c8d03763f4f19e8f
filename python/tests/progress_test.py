"""Progress, stopping, Ctrl-C, and other threads meanwhile."""

import contextlib
import os
import signal
import threading
import time
import unittest

import numpy as np
import shapes

import shellmatch
from shellmatch import _core


@contextlib.contextmanager
def turn_is_taken():
    """Another thread computes, and waits in its progress function; yields a function that lets it go on."""
    taken, goes_on = threading.Event(), threading.Event()

    def wait(event):
        taken.set()
        goes_on.wait(60)

    thread = threading.Thread(
        target=lambda: shellmatch.register("generate:circle", "generate:ellipse/long", levels=(3, 3), progress=wait)
    )
    thread.start()
    try:
        taken.wait(60)
        yield goes_on.set
    finally:
        goes_on.set()
        thread.join()


class Progress(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.pair = (shapes.ellipse(100), shapes.ellipse(100, 1.3, 0.7))
        cls.options = {"levels": (3, 5), "align": "none"}

    def test_events(self):
        events = []
        result = shellmatch.register(*self.pair, progress=events.append, **self.options)
        self.assertEqual([e.text for e in events if e.kind == "stage"], ["reading", "matching", "measuring"])
        self.assertEqual(sorted({e.level for e in events if e.kind == "step"}), [3, 4, 5])
        steps = [(e.level, e.substep, e.iteration, e.energy) for e in events if e.kind == "step"]
        self.assertEqual(steps, [(r["level"], r["substep"], r["iteration"], r["energy"]) for r in result.history])
        self.assertEqual(len([e for e in events if e.kind == "start"]), len([e for e in events if e.kind == "finish"]))

    def test_false_ends_with_what_there_is(self):
        result = shellmatch.register(*self.pair, progress=lambda e: not (e.kind == "step" and e.level == 4), **self.options)
        self.assertTrue(result.interrupted)
        self.assertEqual(result.summary["levels"][-1]["level"], 4)
        whole = shellmatch.register(*self.pair, progress=lambda e: None, **self.options)
        self.assertFalse(whole.interrupted)

    def test_false_of_numpy_is_false(self):
        stops = shellmatch.register(*self.pair, progress=lambda e: np.bool_(e.kind != "step" or e.level < 4), **self.options)
        self.assertTrue(stops.interrupted)
        self.assertEqual(stops.summary["levels"][-1]["level"], 4)
        goes_on = shellmatch.register(*self.pair, progress=lambda e: np.bool_(True), **self.options)
        self.assertFalse(goes_on.interrupted)

    def test_exceptions_go_through(self):
        class Mine(Exception):
            pass

        for kind in ("stage", "start", "step", "finish"):

            def fail(event, kind=kind):
                if event.kind == kind:
                    raise Mine(kind)

            with self.assertRaisesRegex(Mine, kind):
                shellmatch.register(*self.pair, progress=fail, **self.options)
        with self.assertRaises(SystemExit):
            shellmatch.register(*self.pair, progress=lambda e: exit(3), **self.options)
        self.assertEqual(shellmatch.register(*self.pair, **self.options).summary["levels"][-1]["level"], 5)

    def test_what_a_progress_function_may_call(self):
        result = shellmatch.register(*self.pair, **self.options)
        moved = []
        shellmatch.register(*self.pair, progress=lambda e: moved.append(result.apply(self.pair[0])), **self.options)
        self.assertTrue(all(np.array_equal(m, moved[0]) for m in moved))
        for call in (lambda e: shellmatch.register(*self.pair), lambda e: shellmatch.Problem(*self.pair)):
            with self.assertRaisesRegex(shellmatch.InputError, "progress function"):
                shellmatch.register(*self.pair, progress=call, **self.options)
        problem = shellmatch.Problem(*self.pair, **self.options)
        with self.assertRaisesRegex(shellmatch.InputError, "progress function"):
            problem.minimize(progress=lambda e: problem.energy(problem.x0))
        self.assertTrue(np.isfinite(problem.energy(problem.x0)))

    def test_notes_and_warnings(self):
        vertices, faces = shapes.sphere(8)
        doubled = (np.vstack([vertices, vertices]), np.vstack([faces[:50], faces[50:] + len(vertices)]))
        result = shellmatch.register(doubled, (vertices, faces), levels=(3, 3), align="none")
        self.assertTrue(any("duplicate" in note or "welded" in note for note in result.notes), result.notes)
        with self.assertWarns(shellmatch.ShellmatchWarning):
            shellmatch.register((vertices, faces), (vertices + 30, faces), levels=(3, 3), align="none")


class Interrupted(unittest.TestCase):
    """Latencies are those of a machine that has other work; docs/python.md states what was measured."""

    def interrupted(self, call, after):
        """Seconds from the signal to the exception."""
        sent = []

        def send():
            sent.append(time.perf_counter())
            os.kill(os.getpid(), signal.SIGINT)

        timer = threading.Timer(after, send)
        timer.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                call()
            return time.perf_counter() - sent[0]
        finally:
            timer.cancel()
            timer.join()

    def test_ctrl_c(self):
        # Level 10 takes a minute: the last signal must not come after the end, however fast the machine is.
        long = lambda: shellmatch.register("generate:hand", "generate:hand/bent", levels=(3, 10), align="none")  # noqa: E731
        for after in (0.3, 1.5, 3.0):
            seconds = self.interrupted(long, after)
            print(f"{seconds:.3f} s from Ctrl-C to KeyboardInterrupt", flush=True)
            self.assertLess(seconds, 3)
        result = shellmatch.register("generate:circle", "generate:ellipse/long", levels=(3, 4))
        self.assertFalse(result.interrupted)

    def test_ctrl_c_in_a_minimisation_of_ones_own(self):
        problem = shellmatch.Problem("generate:hand", "generate:hand/bent", levels=(3, 6), align="none")
        slow = lambda: problem.minimize(
            name="fletcher_reeves", stop={"relative_decrease": 0, "gradient_norm": 0, "max_iterations": 10**6}
        )  # noqa: E731
        self.assertLess(self.interrupted(slow, 0.5), 3)
        self.assertTrue(np.isfinite(problem.energy(problem.x0)))

    def test_ctrl_c_while_another_thread_computes(self):
        with turn_is_taken() as go_on:
            late = threading.Timer(10, go_on)  # whoever does not hear the signal gets the turn then
            late.start()
            waits = lambda: shellmatch.register("generate:circle", "generate:circle", levels=(3, 3))  # noqa: E731
            self.assertLess(self.interrupted(waits, 0.3), 5)
            late.cancel()

    def test_statistics_wait_for_their_turn(self):
        """So they compute without the interpreter's lock."""
        points = np.random.default_rng(2).random((4, 30, 2))
        segments = np.stack([np.arange(30), (np.arange(30) + 1) % 30], axis=1)
        model = shellmatch.ShapeModel().fit(points)
        calls = (
            lambda: _core.sample_scores(model.variances_, 3, 1),
            lambda: _core.area_weights(points, segments),
        )
        for call in calls:
            with turn_is_taken() as go_on:
                thread = threading.Thread(target=call)
                thread.start()
                thread.join(0.3)
                self.assertTrue(thread.is_alive())
                go_on()
                thread.join(60)
                self.assertFalse(thread.is_alive())

    def test_other_threads_run_meanwhile(self):
        """The interpreter's lock is not held: a thread of Python counts on while another one matches."""
        done = threading.Event()
        longest, counted = [0.0], [0]

        def count():
            last = time.perf_counter()
            while not done.is_set():
                time.sleep(0.001)
                now = time.perf_counter()
                longest[0], last = max(longest[0], now - last), now
                counted[0] += 1

        thread = threading.Thread(target=count)
        thread.start()
        begin = time.perf_counter()
        shellmatch.register("generate:hand", "generate:hand/bent", levels=(3, 5), align="none")
        seconds = time.perf_counter() - begin
        done.set()
        thread.join()
        self.assertGreater(seconds, 0.3)
        self.assertLess(longest[0], 0.5 * seconds)
        self.assertGreater(counted[0], 20)


if __name__ == "__main__":
    unittest.main()
