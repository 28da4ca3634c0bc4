#!/usr/bin/env bash
# Step of action.yml: installs INPUT_PACKAGE, a .deb, with the packages that it needs.
set -euo pipefail

package=$(realpath -e -- "$INPUT_PACKAGE")  # apt takes a name without a slash for a package of the archive
run=(env DEBIAN_FRONTEND=noninteractive)
[ "$(id -u)" -eq 0 ] || run=(sudo "${run[@]}")
install_package() { "${run[@]}" apt-get install -y -q --no-install-recommends --reinstall "$package"; }

# An image of Debian has no package lists, and those of a runner may be old.
if ! install_package >/dev/null 2>&1; then
  "${run[@]}" apt-get update -qq
  install_package
fi
ridgeline --version
