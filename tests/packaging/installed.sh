#!/usr/bin/env bash
# In a bare Debian 12 with the packages in /brought: installs them and takes each into use as its user would.
set -euo pipefail

say() { printf 'installed: %s\n' "$*" >&2; }
export DEBIAN_FRONTEND=noninteractive
install() { apt-get -q -o Dpkg::Use-Pty=0 install -y --no-install-recommends "$@" >/dev/null; }

here=$PWD
work=$(mktemp -d)
cd "$work"
begin=$SECONDS
apt-get -q update >/dev/null
install /brought/polhode_*.deb
say "the command is installed after $((SECONDS - begin)) s"
polhode --version
polhode verify paper --schemes strang_two_turns --experiments energy,casimir --effort quick --quiet --out report
test -s report/paper/report.html
zcat /usr/share/man/man1/polhode.1.gz | grep -q verify

# A stranger's scheme in C, as docs/verify-your-integrator.md has it.
install gcc libc6-dev /brought/libpolhode-dev_*.deb
cc -O2 -shared -fPIC -o my_heun.so "$here/integrators/examples/my_heun.c" -lm
code=0
polhode verify paper --with ./my_heun.so --experiments energy --effort quick --quiet --out mine || code=$?
((code == 0 || code == 3)) || { say "the stranger's scheme: exit $code"; exit 1; }
grep -q my_heun mine/paper/results.json
say "a scheme of one's own is verified after $((SECONDS - begin)) s"

# The integrators by pkg-config and by CMake; the laboratory by CMake.
install g++ cmake make pkg-config
cat >body.cpp <<'EOF'
#include <polhode/integrate.hpp>
#include <polhode/schemes/strang.hpp>
#include <polhode/systems/rigid_body.hpp>
#include <cmath>
int main() {
  const polhode::rigid_body body({1, 2, 3}, 0.5, polhode::rigid_body::isotropic(0.5));
  const auto pi = polhode::integrate<polhode::strang>(body, {{0.6, 0.48, 0.64}}, 0.01, 200, {.seed = 1});
  return std::fabs(dot(pi, pi) - 1) < 1e-12 ? 0 : 1;
}
EOF
# shellcheck disable=SC2046  # flags are words
g++ -O2 $(pkg-config --cflags polhode) body.cpp -o body
./body
cp -r "$here/integrators/examples/laboratory" own
cmake -S own -B own/build -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build own/build >/dev/null
own/build/my_report
say "a report by a program of one's own after $((SECONDS - begin)) s"

install /brought/python3-polhode_*.deb
python3 -c 'import polhode; print(polhode.reference("paper", "lyapunov"))'
say "all after $((SECONDS - begin)) s"
