#!/usr/bin/env bash
# Checks that every C++ source is as clang-format leaves it: check_format.sh ROOT
set -euo pipefail

cd "$1"
find renderer ui app tests bench \( -name '*.h' -o -name '*.cpp' \) -print0 |
  xargs -0 clang-format --dry-run -Werror --ferror-limit=1 || {
    echo "Run tools/format."
    exit 1
  }
