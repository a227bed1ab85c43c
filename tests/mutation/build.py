# SPDX-License-Identifier: Apache-2.0
"""Compiles a changed source beside a finished build and links test programs with it; the build itself stays as it is."""
import json
import re
import shlex
import shutil
import subprocess
from pathlib import Path

LIMIT = 900  # seconds of a compilation or a link
ASSERTING = ['-w', '-Wno-error', '-UNDEBUG', '-D_GLIBCXX_ASSERTIONS']  # an index beyond the end is seen, whatever lies there


class Build:
    def __init__(self, tree, build):
        self.tree, self.build = Path(tree).resolve(), Path(build).resolve()
        commands = json.loads((self.build / 'compile_commands.json').read_text())
        self.command = {}
        for c in commands:
            words = shlex.split(c['command'])
            self.command[words[words.index('-o') + 1]] = (words, Path(c['file']))
        self.depends = self._depends()

    def _depends(self):
        """{object: sources of the tree that it is made from}."""
        text, out, name = subprocess.run(['ninja', '-C', self.build, '-t', 'deps'], capture_output=True, text=True, check=True).stdout, {}, None
        for line in text.splitlines():
            if m := re.match(r'(\S+): #deps', line): name = m.group(1); out[name] = set()
            elif name and line.startswith('    '):
                path = (self.build / line.strip()).resolve()
                if path.is_relative_to(self.tree): out[name].add(path.relative_to(self.tree))
        # What is read precompiled is not told of those who read it.
        return {name: sources | out.get(self._precompiled_by(name), set()) for name, sources in out.items()}

    def _precompiled_by(self, obj):
        """The object that holds the headers precompiled that this one reads, or None."""
        words, _ = self.command.get(obj, ((), None))
        return f"{Path(words[words.index('-include') + 1]).relative_to(self.build)}.gch" if '-include' in words else None

    def objects_of(self, file, under):
        return sorted(o for o, sources in self.depends.items() if file in sources and under in o and o in self.command)

    def compile(self, obj, overlay, out, changed=(), flags=(), first=()):
        """Under `overlay` lie the sources `changed` at their places in the tree: found before the tree's own."""
        words, source = self.command[obj]
        words = list(words)
        words[words.index('-o') + 1] = str(out)
        if (own := source.resolve().relative_to(self.tree)) in changed: words[words.index('-c') + 1] = str(overlay / own)
        if self.depends.get(self._precompiled_by(obj), set()) & set(changed):  # precompiled from the sources as they are
            at = words.index('-include') + 1
            words[at] = str(shutil.copy(words[at], overlay))
        places = [overlay, overlay / 'src', overlay / 'tests', overlay / 'integrators/include']
        words[1:1] = [*first, *(f'-I{place}' for place in places)]
        return self.run([*words, *ASSERTING, *flags], cwd=self.build)

    def link(self, target, replaced, out, alone=None):
        """The program with objects replaced; those of the library stand before it, so that its own are not taken.
        alone: of the program's objects only these."""
        line = subprocess.run(['ninja', '-C', self.build, '-t', 'commands', target], capture_output=True, text=True, check=True).stdout.splitlines()[-1]
        line = next(part for part in line.split('&&') if ' -o ' in part)
        words = shlex.split(line)
        own = [w for w in words if w.endswith('.o')]
        extra = [str(o) for name, o in replaced.items() if name not in own]
        kept = []
        for w in words:
            if w in own and (alone is None or w in alone):
                kept += [str(replaced.get(w, w))] + extra
                extra = []
            elif w not in own:
                kept.append(w)
        kept[kept.index('-o') + 1] = str(out)
        return self.run(kept, cwd=self.build)

    @staticmethod
    def run(words, cwd=None, limit=LIMIT):
        """Exit code and what was said; None after `limit` seconds."""
        try:
            done = subprocess.run([str(w) for w in words], cwd=cwd, capture_output=True, text=True, errors='replace', timeout=limit)
            return done.returncode, done.stdout + done.stderr
        except subprocess.TimeoutExpired:
            return None, ''
