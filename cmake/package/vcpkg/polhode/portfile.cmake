# SPDX-License-Identifier: Apache-2.0
# An overlay port of this tree: vcpkg install polhode --overlay-ports=cmake/package/vcpkg
cmake_path(ABSOLUTE_PATH CURRENT_PORT_DIR OUTPUT_VARIABLE port)
set(SOURCE_PATH ${port}/../../../..)
vcpkg_cmake_configure(SOURCE_PATH ${SOURCE_PATH} OPTIONS -DPOLHODE_LABORATORY=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/polhode)
file(REMOVE_RECURSE ${CURRENT_PACKAGES_DIR}/debug ${CURRENT_PACKAGES_DIR}/lib)
vcpkg_install_copyright(FILE_LIST ${SOURCE_PATH}/LICENSE)
