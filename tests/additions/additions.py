#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What does a new scheme cost, and a new system? Adds a toy of each to a copy of the tree and counts the files touched.

    additions.py SOURCE BUILD            what is touched compiles (the compiler's front end alone)
    additions.py SOURCE BUILD --build    the copy is built, and lists and verifies both (nightly)
"""
import argparse
import json
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile

SCHEME_FILES, SYSTEM_FILES = 2, 4  # a header and a line; a header, a source, a line and a scene


def run(command, folder):
    return subprocess.run(command, cwd=folder, check=True, stdout=subprocess.PIPE, text=True).stdout


def copy_of(source, folder):
    copy = pathlib.Path(folder) / 'tree'
    for name in run(['git', 'ls-files', '-z'], source).split('\0'):
        if name and (source / name).is_file():
            (copy / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source / name, copy / name)
    run(['git', 'init', '-q'], copy)
    run(['git', 'add', '-A', '-f'], copy)
    return copy


def touched(copy):
    names = run(['git', 'status', '--porcelain', '-uall', '-z'], copy).split('\0')
    return sorted(name[3:] for name in names if name and name[1] != ' ')


def replace(path, before, after):
    text = path.read_text()
    if text.count(before) != 1:
        sys.exit(f'{path}: {before!r} is there {text.count(before)} times, not once')
    path.write_text(text.replace(before, after))


def add_scheme(copy, toys):
    shutil.copy(toys / 'toy_scheme.hpp', copy / 'integrators/include/polhode/schemes')
    listed = copy / 'src/systems/schemes.hpp'
    replace(listed, 'strang_weak2>;', 'strang_weak2, toy_scheme>;')
    replace(listed, '#include <polhode/schemes/strang_weak2.hpp>\n',
            '#include <polhode/schemes/strang_weak2.hpp>\n#include <polhode/schemes/toy_scheme.hpp>\n')


def add_system(copy, toys):
    shutil.copy(toys / 'toy_system.hpp', copy / 'integrators/include/polhode/systems')
    shutil.copy(toys / 'toy_system.cpp', copy / 'src/systems')
    shutil.copy(toys / 'toy_system.toml', copy / 'reports/scenes')
    replace(copy / 'src/systems/systems.cpp', 'apply(so4_body)', 'apply(so4_body) apply(toy_system)')


def expect_count(what, files, most):
    print(f'a {what}: {len(files)} files: {", ".join(files)}')
    if len(files) != most:
        sys.exit(f'a {what} should touch {most} files')


def commands_for(build, source, like):
    """The compile commands of a source that the build has, as lists of words: by itself, or joined with its folder."""
    path = str(source / like)

    def compiles(file):
        return file == path or '/Unity/' in file and f'"{path}"' in pathlib.Path(file).read_text()
    all_commands = json.loads((build / 'compile_commands.json').read_text())
    found = [shlex.split(c['command'].replace(c['file'], path)) for c in all_commands if compiles(c['file'])]
    if not found:
        sys.exit(f'the build compiles no {like}')
    return found


def check_compiles(words, source, copy, like, name):
    words = [w.replace(str(source / like), str(copy / name)) for w in words]
    words = [w.replace(f'-I{source}', f'-I{copy}') if f'-I{source}/build' not in w else w for w in words]
    kept, skip = [], False
    for word in words:
        if skip or word.endswith('ccache'):
            skip = False
        elif word in ('-o', '-MF', '-MT'):
            skip = True
        elif word not in ('-c', '-MD', '-Winvalid-pch', '-Xclang', '-include', '-include-pch') and 'cmake_pch' not in word:
            kept.append(word)
    run([*kept, '-fsyntax-only'], copy)
    print(f'{name} compiles')


def check_front_end(source, build, copy):
    """Once for its table, once for an instruction set; and the list of systems."""
    table, *levels = sorted(commands_for(build, source, 'src/systems/so4_body.cpp'), key=lambda w: ' '.join(w).count('POLHODE_ISA='))
    for words in [table, *levels[:1]]:
        check_compiles(words, source, copy, 'src/systems/so4_body.cpp', 'src/systems/toy_system.cpp')
    check_compiles(commands_for(build, source, 'src/systems/systems.cpp')[0], source, copy, 'src/systems/systems.cpp',
                   'src/systems/systems.cpp')


def check_build(copy):
    run(['cmake', '--preset', 'native', '-DPOLHODE_TESTS=OFF'], copy)
    run(['cmake', '--build', '--preset', 'native', '--target', 'polhode'], copy)
    polhode = copy / 'build/native/polhode'
    print(run([polhode, 'list', 'systems'], copy))
    run([polhode, 'verify', 'toy_system', '--experiments', 'casimir,strong,energy', '--effort', 'quick', '--out', copy / 'out'], copy)
    run([polhode, 'verify', 'paper', '--schemes', 'toy_scheme', '--effort', 'quick', '--out', copy / 'out'], copy)
    print('both hold what they claim')


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('source', type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument('build', type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument('--build', action='store_true', dest='whole')
    given = parser.parse_args()
    toys = pathlib.Path(__file__).resolve().parent
    with tempfile.TemporaryDirectory() as folder:
        copy = copy_of(given.source, folder)
        add_scheme(copy, toys)
        scheme = touched(copy)
        expect_count('scheme', scheme, SCHEME_FILES)
        add_system(copy, toys)
        expect_count('system', [f for f in touched(copy) if f not in scheme], SYSTEM_FILES)
        check_build(copy) if given.whole else check_front_end(given.source, given.build, copy)


if __name__ == '__main__':
    main()
