# SPDX-License-Identifier: Apache-2.0
"""Why the compiled part of the package, _core, cannot be imported."""
from __future__ import annotations

import re
import sys
import sysconfig
from pathlib import Path
from typing import Optional


def reason() -> Optional[str]:
    """One line, with what to do; None where _core is there for this Python, and something else is wrong."""
    folder = Path(__file__).parent
    here = sysconfig.get_config_var('EXT_SUFFIX')
    built = sorted(path.name[len('_core'):] for path in folder.glob('_core.*so'))
    if here in built:
        return None
    if not built:
        return (f'{folder} holds no compiled part of polhode: build it with `ci/build release polhode_python`, '
                'and set PYTHONPATH=build/release/python')
    return (f'{folder} is built for {" and ".join(map(_python, built))}, and this is {_python(here)}, {sys.executable}: '
            f'run the former, or build it anew with `cmake --preset release -D Python3_EXECUTABLE={sys.executable}` '
            'and `ci/build release polhode_python`')


def _python(suffix: str) -> str:
    """'.cpython-311-x86_64-linux-gnu.so': 'Python 3.11 (x86_64-linux-gnu)'."""
    found = re.fullmatch(r'\.cpython-(\d)(\d+)m?-(.+)\.so', suffix)
    return 'Python {}.{} ({})'.format(*found.groups()) if found else suffix
