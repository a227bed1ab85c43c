# SPDX-License-Identifier: Apache-2.0
"""SIGINT ends a run in seconds, as KeyboardInterrupt: in Python schemes, in our own, in a choice of a scheme."""
import os, signal, subprocess, sys, time, unittest

HERE = os.path.dirname(os.path.abspath(__file__))
BEGIN = f'import sys, signal; sys.path.insert(0, {HERE!r}); signal.signal(signal.SIGINT, signal.default_int_handler); import polhode, strangers; print("up", flush=True)\n'


class Interrupts(unittest.TestCase):
    def interrupted(self, program):
        p = subprocess.Popen([sys.executable, '-c', BEGIN + program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertEqual(p.stdout.readline(), 'up\n')
        time.sleep(.5)
        self.assertIsNone(p.poll(), 'ended by itself')
        p.send_signal(signal.SIGINT)
        begun = time.monotonic()
        out, err = p.communicate(timeout=60) 
        self.assertLess(time.monotonic() - begun, 10)
        self.assertEqual(p.returncode, -signal.SIGINT, err)
        self.assertIn('KeyboardInterrupt', err)

    def test_python_scheme(self):
        self.interrupted('polhode.verify("paper", [strangers.their_heun], ["weak"], effort="thorough", threads=2)')
    def test_endless_step(self):
        self.interrupted('def endless(*given):\n  while True: pass\npolhode.verify("paper", [endless], ["weak"], threads=2)')
    def test_our_schemes(self):
        self.interrupted('polhode.verify("paper", ["heun"], ["gibbs", "strong"], effort="thorough", threads=2)')
    def test_select(self):
        self.interrupted('polhode.select("heavy_top", "weak", 1e-3, threads=2)')


if __name__ == '__main__':
    unittest.main()
