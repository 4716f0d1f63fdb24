#!/usr/bin/env bash
# Every source file is as clang-format leaves it. Fix with: clang-format -i FILE
source "$(dirname "${BASH_SOURCE[0]}")/files.sh"
source_files | xargs -r clang-format --dry-run --Werror
echo "no faults"
