#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A scheme or a system that does not fit: the compiler's first lines name what is missing. g++, and clang where there is."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
COMPILERS = [path for name in (os.environ.get("CXX", "g++"), "clang++-19") if (path := shutil.which(name))]
FLAGS = ["-std=gnu++20", "-fsyntax-only", f"-I{ROOT}", f"-I{ROOT}/src", f"-I{ROOT}/integrators/include", "-isystem",
         "/usr/include/eigen3", "-DPOLHODE_X86_LEVELS"]

INFO = 'static constexpr scheme_info info{.name = "mine"};'
STEP = "template <class T, class S> static auto step(const T&, const vec<S, T::dimension>& mu, const wiener<S, T::channels>&) { return mu; }"
RETURNS_A_NUMBER = "template <class T, class V, class W> static double step(const T&, const V&, const W&) { return 0; }"
NOISE = "double_bracket(0.1, constant_noise<so3>::isotropic(0.3))"
GENERATOR = "template <class S> vec<S, 3> omega(const vec<S, 3>& mu) const { return mu; }"
ENERGY = "template <class S> S energy(const vec<S, 3>& mu) const { return dot(mu, mu); }"


def integrated(scheme):
    return f"""#include <polhode/integrate.hpp>
#include <polhode/systems/rigid_body.hpp>
using namespace polhode;
struct mine {{ {scheme} }};
int main() {{ integrate<mine>(rigid_body({{1, 2, 3}}, 0.1, rigid_body::isotropic(0.3)), {{{{1, 0, 0}}}}, 0.1, 10); }}
"""


def bound(scheme):
    return f"""#include "systems/bind.hpp"
#include "systems/rigid_body/rigid_body.hpp"
using namespace polhode;
struct mine {{ {scheme} }};
int main() {{ bind(report::scene{{}}, make_rigid_body, scheme_list<mine>{{}}); }}
"""


def system(members):
    return f"""#include <polhode/integrate.hpp>
#include <polhode/lie/so3.hpp>
#include <polhode/schemes/heun.hpp>
#include <polhode/systems/double_bracket.hpp>
using namespace polhode;
struct mine : double_bracket<mine, so3> {{ mine() : {NOISE} {{}} {members} }};
int main() {{ integrate<heun>(mine(), {{{{1, 0, 0}}}}, 0.1, 10); }}
"""


class Messages(unittest.TestCase):
    def first_lines(self, compiler, source):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "main.cpp").write_text(source)
            done = subprocess.run([compiler, *FLAGS, "main.cpp"], cwd=folder, capture_output=True, text=True)
        return done.returncode, "\n".join(line for line in done.stderr.splitlines() if "error" in line or "note" in line)

    def expect(self, source, words):
        for compiler in COMPILERS:
            with self.subTest(compiler=Path(compiler).name):
                rc, text = self.first_lines(compiler, source)
                self.assertNotEqual(rc, 0)
                self.assertRegex("\n".join(text.splitlines()[:6]), words)

    def test_what_fits_compiles(self):
        for compiler in COMPILERS:
            for source in (integrated(INFO + STEP), system(GENERATOR + ENERGY)):
                self.assertEqual(self.first_lines(compiler, source), (0, ""))

    def test_a_scheme_without_info(self): self.expect(integrated(STEP), r"Scheme::info\.name")
    def test_a_scheme_without_step(self): self.expect(integrated(INFO), r"Scheme::step\(system, mu, w\)")
    def test_a_step_of_a_number(self): self.expect(integrated(INFO + RETURNS_A_NUMBER), r"Scheme::step\(system, mu, w\)|state_of<")
    def test_a_system_without_energy(self): self.expect(system(GENERATOR), r"system\.energy\(mu\)")
    def test_a_system_without_motion(self): self.expect(system(ENERGY), "omega")

    def test_in_the_laboratory(self):
        self.expect(bound(STEP), "a scheme needs `static constexpr polhode::scheme_info info`")
        self.expect(bound(INFO), r"a scheme needs `static auto step\(")
        self.expect(bound(INFO + RETURNS_A_NUMBER), "the step of a scheme returns a state")


if __name__ == "__main__":
    sys.exit(unittest.main())
