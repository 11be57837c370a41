#!/usr/bin/env bash
# Runs a program of the host on the tests' own kernel, as an ordinary process without privileges. Exits with the program's
# status, or with 77 where that kernel was not built, or cannot run because a container forbids ptrace.
# usage: boot.sh CACHE PROGRAM WORDS...
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
cache=$1
shift
kernel=
for built in "$cache"/*-"$("$here/kernel/key.sh")"/linux; do # the newest source's is the last
    [ -x "$built" ] && kernel=$built
done
if [ -z "$kernel" ]; then
    echo "skipped: the kernel for these tests is not in $cache; './dev kernel' builds it there"
    exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# The kernel's memory is a file in $TMPDIR; the first serial line is the console.
HOME=$work TMPDIR=$work timeout -k 5 "${SPANGLE_KERNEL_SECONDS:-200}" "$kernel" mem=192M uml_dir="$work" \
    root=/dev/root rootfstype=hostfs rootflags=/ ro con=null ssl=null ssl0=null,fd:1 console=ttyS0 quiet panic=-1 \
    init="$here/init.sh" -- "$@" </dev/null 2>"$work/errors" | tr -d '\r' | tee "$work/console" || true
if ! grep -q '^the kernel runs$' "$work/console"; then
    cat "$work/errors"
    echo "skipped: User-mode Linux does not start here"
    exit 77
fi
status=$(sed -n 's/^ended with status \([0-9]*\)$/\1/p' "$work/console" | tail -n 1)
if [ -z "$status" ]; then
    cat "$work/errors"
    echo "the kernel ended, or was ended, before the program did"
    exit 1
fi
exit "$status"
