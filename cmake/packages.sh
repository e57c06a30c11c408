# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by ./quickstart and ./check: the Debian packages that we need and how to install what is missing.
build_packages="g++ cmake ninja-build libcgal-dev libeigen3-dev libboost-dev libboost-program-options-dev
  libsuitesparse-dev libpng-dev nlohmann-json3-dev"
# The page of the studio. npm is part of some packages of nodejs, and then the package npm cannot stand beside them.
studio_packages=""
command -v node >/dev/null || studio_packages="nodejs"
command -v npm >/dev/null || studio_packages="$studio_packages npm"
# The Python package, its wheel, and what its examples use: REEBQUAD_PYTHON is switched on where pybind11 is found.
python_packages="pybind11-dev python3-dev python3-numpy python3-setuptools python3-wheel python3-pip python3-meshio python3-matplotlib"
test_packages="catch2 clang-format doxygen chromium"

# install_packages NAME...: installs those that are missing; says nothing when there are none.
install_packages() {
  local missing="" package
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing="$missing $package"
  done
  [ -z "$missing" ] && return 0
  local as_root=""
  [ "$(id -u)" -eq 0 ] || as_root="sudo"
  echo "Installing:$missing"
  $as_root apt-get update -qq || return 1
  # shellcheck disable=SC2086
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
}
