# SPDX-License-Identifier: Apache-2.0
"""How long a test waits for the command: longer where it was built to be watched, under sanitizers."""
import os


def within(seconds): return seconds * float(os.environ.get('POLHODE_PATIENCE', 1))
