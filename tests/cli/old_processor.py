#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs polhode on an emulated processor without AVX: it must choose v2, finish and say so.

usage: old_processor.py POLHODE QEMU LEVELS     exit 77: skipped, as QEMU (qemu-x86_64) is not to be had, or POLHODE is
built for one instruction set (LEVELS, POLHODE_ISA_LEVELS of the build, is NATIVE)"""
import json, os, subprocess, sys, tempfile

polhode, qemu, levels = sys.argv[1:]
if levels == 'NATIVE':
    print('skipped: built for one instruction set')
    sys.exit(77)
if not os.access(qemu, os.X_OK):
    print('skipped: no qemu-x86_64 found when the build was configured (Debian: qemu-user)')
    sys.exit(77)

with tempfile.TemporaryDirectory() as work:
    run = subprocess.run([qemu, '-cpu', 'Nehalem', os.path.abspath(polhode), 'verify', 'paper', '--effort', 'quick', '--experiments',
                          'energy', '--schemes', 'heun', '--out', 'report'], cwd=work, capture_output=True, text=True)
    print(run.stdout, run.stderr, sep='\n')
    assert run.returncode == 0, f'exit {run.returncode}'
    with open(os.path.join(work, 'report/paper/results.json')) as f:
        isa = json.load(f)['provenance']['isa']
    assert isa == 'v2', f'chose {isa}'
    refused = subprocess.run([qemu, '-cpu', 'Nehalem', os.path.abspath(polhode), 'verify', 'paper', '--isa', 'v4', '--out', 'report'],
                             cwd=work, capture_output=True, text=True)
    assert refused.returncode == 2 and 'v4' in refused.stderr, (refused.returncode, refused.stderr)
    refused = subprocess.run([qemu, '-cpu', 'Nehalem', os.path.abspath(polhode), 'verify', 'paper', '--generator', 'ars', '--out', 'report'],
                             cwd=work, capture_output=True, text=True)
    said = "polhode: --generator 'ars': not to be had here: the processor has no AES; accepted: philox\n"
    assert (refused.returncode, refused.stderr) == (2, said), (refused.returncode, refused.stderr)
