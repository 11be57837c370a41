#!/bin/sh
# prove.sh GAPPA GENERATOR NAME: proves one obligation. Exit status 77 tells CTest that Gappa is missing.
case $1 in
'' | *-NOTFOUND)
    echo "gappa is not installed (apt install gappa): proof of $3 skipped"
    exit 77
    ;;
esac
script=$(mktemp) || exit 1
trap 'rm -f "$script"' EXIT
"$2" "$3" >"$script" || exit 1
# Gappa says what it could not prove and fails; a script that proves nothing must not pass either.
grep -q -e '->' "$script" || { echo "no obligation in $3"; exit 1; }
# Sums next to 2^63 take more bits than its bounds have by default.
"$1" -Eprecision=96 "$script" || { echo "not proven:"; cat "$script"; exit 1; }
