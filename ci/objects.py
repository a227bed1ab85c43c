# SPDX-License-Identifier: Apache-2.0
"""What the build makes: from which folder of the tree each output comes, and what each folder costs to compile.

The unit of costs is the processor time that the compiler takes for ci/yardstick.cpp in the same run."""
import json
import os
import re
import resource
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
YARDSTICK = 'ci/yardstick.cpp'
LINKING, SHARED_HEADERS = '(linking)', '(precompiled headers)'


class Fault(Exception):
    """One line for the user."""


def folder_of(output, build):
    """The folder of the sources that are compiled into an output of the build folder; of headers and programs a word."""
    if output.endswith('.gch'):
        return SHARED_HEADERS
    found = re.fullmatch(r'(?:(.*?)/)?CMakeFiles/[^/]+\.dir/(.*)\.o', output)
    if not found:
        return LINKING
    folder, source = found[1] or '', found[2]
    if source.startswith('Unity/'):
        return _folder_of_joined(Path(build) / output[:-len('.o')])
    source = source.replace('__/', '../')  # as CMake writes it
    return os.path.dirname(os.path.normpath(os.path.join(folder, source))) or '.'


def _folder_of_joined(source):
    """CMake joins sources by a file that includes each by its absolute path."""
    try:
        included = re.findall(r'^#include "(.*)"', source.read_text(), re.M)
    except OSError:
        raise Fault(f'{source} is not there any more: which sources were joined in it is not known') from None
    if not included:
        raise Fault(f'{source} includes no source')
    folder = Path(os.path.commonpath([os.path.dirname(one) for one in included]))
    home = _cached(source, 'CMAKE_HOME_DIRECTORY')
    return str(folder.relative_to(home)) if home and folder.is_relative_to(home) else str(folder)


def _cached(below, name):
    for folder in Path(below).parents:
        if (cache := folder / 'CMakeCache.txt').exists():
            return cached(folder, name)
    return None


def cached(build, name):
    """A value of CMake's cache; None where there is none."""
    cache = Path(build) / 'CMakeCache.txt'
    if not cache.exists():
        return None
    found = re.search(rf'^{re.escape(name)}:\w+=(.*)$', cache.read_text(), re.M)
    return found[1] if found else None


def seconds_of(command, **options):
    """The exit code of a command and its processor seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    code = subprocess.run(command, **options).returncode
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return code, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def seconds_of_yardstick(compiler):
    with tempfile.TemporaryDirectory() as folder:
        code, seconds = seconds_of([compiler, '-std=c++20', '-O2', '-c', ROOT / YARDSTICK, '-o', Path(folder) / 'yardstick.o'])
    if code:
        raise Fault(f'{compiler} does not compile {YARDSTICK}')
    return seconds


class Budget:
    """ci/costs.json: the units that each folder may take, those of the dearest object, and of what build they are."""

    def __init__(self, preset='native', targets=(), dearest=20.0, units=None):
        self.preset, self.targets, self.dearest, self.units = preset, list(targets), dearest, dict(units or {})

    @staticmethod
    def read(path):
        try:
            given = json.loads(Path(path).read_text())
            return Budget(given['preset'], given['targets'], float(given['dearest object']),
                          {folder: float(units) for folder, units in given['units'].items()})
        except OSError:
            raise Fault(f'no budget in {path}: ci/costs --update writes it') from None
        except (ValueError, KeyError, TypeError, AttributeError) as fault:
            raise Fault(f'{path}: {fault}; ci/costs --update writes it anew') from None

    def write(self, path):
        rows = {folder: round(units, 2) for folder, units in sorted(self.units.items())}
        Path(path).write_text(json.dumps({'preset': self.preset, 'targets': self.targets, 'dearest object': self.dearest,
                                          'units': rows}, indent=1) + '\n')
