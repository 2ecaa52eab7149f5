"""Long calls let other Python threads run, may be called by several, and end by Ctrl-C."""

import os
import signal
import threading
import time
import unittest

import numpy as np
import scb
from support import built


class Threads(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scene = scb.load_scene("spheres-l1")
        cls.a, cls.b = built(scene)
        cls.poses = np.tile(scene.relative_poses("A", "B", np.arange(200, 300)), (40, 1, 1))

    def test_others_run_meanwhile(self):
        done, ticks = threading.Event(), []

        def tick():
            while not done.is_set():
                ticks.append(time.perf_counter())
                time.sleep(0.001)

        other = threading.Thread(target=tick)
        other.start()
        start = time.perf_counter()
        scb.collide_poses(self.a, self.b, self.poses, threads=1)
        end = time.perf_counter()
        done.set()
        other.join()
        within = [t for t in ticks if start < t < end]
        self.assertGreater(len(within), 20)
        # No part of the call kept the lock: nothing but a busy machine makes a long pause.
        self.assertLess(np.diff([start, *within, end]).max(), (end - start) / 2)

    def test_several_get_the_same(self):
        expected = scb.collide_poses(self.a, self.b, self.poses[:100])
        results = [None] * 6

        def ask(i):
            results[i] = (scb.collide_poses(self.a, self.b, self.poses[:100], threads=i),
                          scb.draw_level("thin-cylinder", 2, size=(400, 320), samples=1).array,
                          scb.build(self.a.mesh).validate())

        threads = [threading.Thread(target=ask, args=[i]) for i in range(len(results))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for found, picture, words in results:
            np.testing.assert_array_equal(found.pairs, expected.pairs)
            np.testing.assert_array_equal(found.stages, expected.stages)
            np.testing.assert_array_equal(picture, results[0][1])
            self.assertEqual(words, "")

    def test_one_source_of_queries_is_asked_by_several(self):
        queries = scb.open_queries("spheres-l1", frames="0:499:50")
        expected = {number: queries.frame(number).n_v for number in queries.frames}
        wrong = []

        def ask(order):
            for number in order:
                if queries.frame(number).n_v != expected[number]:
                    wrong.append(number)

        threads = [threading.Thread(target=ask, args=[queries.frames[::step]]) for step in (1, -1, 2, -2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(wrong, [])

    def test_ctrl_c_ends_a_long_call(self):
        many = np.tile(self.poses, (20, 1, 1))
        for threads in (1, 0):
            start = time.perf_counter()
            timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
            timer.start()
            with self.assertRaises(KeyboardInterrupt):
                scb.collide_poses(self.a, self.b, many, threads=threads)
            timer.join()
            self.assertLess(time.perf_counter() - start, 5)
        # The next call is none the wiser.
        self.assertEqual(len(scb.collide_poses(self.a, self.b, self.poses[:10])), 10)

    def test_what_a_signal_raises_is_raised(self):
        class Late(Exception):
            pass

        def alarm(number, frame):
            raise Late

        before = signal.signal(signal.SIGALRM, alarm)
        self.addCleanup(signal.signal, signal.SIGALRM, before)
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        with self.assertRaises(Late):
            scb.collide_poses(self.a, self.b, np.tile(self.poses, (20, 1, 1)))


if __name__ == "__main__":
    unittest.main()
