#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# In a bare Debian 12 with the packages in /brought: takes each into use as its user would, and goes through every door of
# docs/verify-your-integrator.md. Says how long each took, from the installation of what it needs to a scheme that is verified.
set -euo pipefail

say() { printf 'installed: %s\n' "$*" >&2; }
export DEBIAN_FRONTEND=noninteractive DEBCONF_NOWARNINGS=yes
install() { apt-get -q -o Dpkg::Use-Pty=0 install -y --no-install-recommends "$@" >/dev/null; }
begin=0
start() { begin=$SECONDS; }
took() { say "$((SECONDS - begin)) s: $*"; }

here=$PWD
examples=$here/integrators/examples
work=$(mktemp -d)
cd "$work"

# The stranger's scheme is on the board, and nothing it claims is refuted.
verified() {  # the integrator, its name
  local code=0 out=${1//[^a-z_0-9]/_}
  polhode verify paper --with "$1" --schemes "${2:-my_heun},heun" --effort quick --experiments casimir,strong,energy --quiet --out "$out" || code=$?
  ((code == 0 || code == 3)) || { say "$1: exit $code"; exit 1; }
  grep -q "${2:-my_heun}" "$out/paper/results.json"
}

start
apt-get -q update >/dev/null
# Word for word as the guide has it; the packages are built already, and nobody is there to say yes.
echo 'APT::Get::Assume-Yes "true"; APT::Install-Recommends "false";' >/etc/apt/apt.conf.d/99answers
mkdir build && ln -s /brought build/package
sed -n '/^## Packages$/,/^## From/s/^\$ //p' "$here/docs/install.md" | grep -vx ci/package >as_told.sh
grep -q 'apt install .*polhode_' as_told.sh
bash -e as_told.sh >&2
polhode verify paper --schemes strang_two_turns --experiments energy,casimir --effort quick --quiet --out report
test -s report/paper/report.html
zcat /usr/share/man/man1/polhode.1.gz | grep -q verify
took 'the command'

start
install gcc libc6-dev /brought/libpolhode-dev_*.deb
cc -std=c99 -O2 -shared -fPIC "$examples/my_heun.c" -o my_heun.so
verified ./my_heun.so
took 'a library in C'

start
install gfortran
gfortran -O2 -shared -fPIC "$examples/my_heun.f90" -o my_heun_f.so
verified ./my_heun_f.so f_heun
took 'a library in Fortran'

start
cc -std=c99 -O3 "$examples/my_heun_process.c" -o my_heun_process
verified ./my_heun_process
took 'a process in C'

start
install python3 python3-numpy
verified "python3 $examples/my_heun.py"
took 'a process in Python'

start
install octave
verified "octave-cli -q $examples/my_heun.m"
took 'a process in Octave'

start
install /brought/python3-polhode_*.deb
sed -n '/^```python$/,/^```$/{/^```/d;p}' "$here/docs/verify-in-python.md" >guide.py
python3 guide.py >guide.txt
took 'import polhode, the whole guide'

start
install g++ cmake make
cp -r "$examples/laboratory" own
cmake -S own -B own/build -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build own/build >/dev/null
own/build/my_report
took 'the headers, a program of one'\''s own'

# The integrators alone, by pkg-config.
install pkg-config
cat >body.cpp <<'EOF'
#include <cmath>
#include <polhode/integrate.hpp>
#include <polhode/schemes/strang.hpp>
#include <polhode/systems/rigid_body.hpp>
int main() {
  const polhode::rigid_body body({1, 2, 3}, 0.5, polhode::rigid_body::isotropic(0.5));
  const auto pi = polhode::integrate<polhode::strang>(body, {{0.6, 0.48, 0.64}}, 0.01, 200, {.seed = 1});
  return std::fabs(dot(pi, pi) - 1) < 1e-12 ? 0 : 1;
}
EOF
# shellcheck disable=SC2046  # flags are words
g++ -std=c++20 -O2 $(pkg-config --cflags polhode) body.cpp -o body
./body
say 'all doors are open'
