#!/usr/bin/env bash
# Prints twelve digits that change with what Spangle adds to the kernel: configuration, patches, board, and how it is built.
cd "$(dirname "$(readlink -f "$0")")"
LC_ALL=C
cat board/* build.sh config ./*.patch | sha256sum | cut -c 1-12
